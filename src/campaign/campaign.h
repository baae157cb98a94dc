#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/grid_table.h"
#include "campaign/live_report.h"
#include "campaign/run_folder.h"
#include "campaign/run_list.h"
#include "comm/communicator.h"
#include "run/run_file.h"

namespace repose {

/// What many runs of one deck have in common, and where they go.
struct CampaignPlan {
  StudyDeck study;
  std::string deck;                       ///< path of the study
  std::string deck_text;                  ///< for the table
  std::vector<std::string> command_line;  ///< overrides that came with the command; they are among those of the runs
  std::vector<std::string> bases;         ///< paths of the base decks, for each experiment one per level
  std::vector<std::string> levels;        ///< their names; empty: there is one, without a name
  std::vector<std::string> experiments;   ///< likewise
  std::vector<RunFigure> figures;         ///< for the table
  std::string directory;                  ///< runs in runs/NAME, tables beside
  VectorLevel level;
  RunLog log;                    ///< of the whole; each run has a run.log of its own
  LiveReport* report = nullptr;  ///< to be renewed meanwhile; rank 0
  /// Throws a DeckError when runs of this deck could not have what is asked of them beside `figures`. May be empty.
  std::function<void(const Deck& deck, std::size_t experiment)> check_deck;
  /// Throws an Error when a complete run, in this folder, is not what was meant. On rank 0 of its group; may be empty.
  std::function<void(const std::string& folder, const StudyRun& run)> check_run;

  /// The place in `bases` of a run's base deck.
  std::size_t base_of(const StudyRun& run) const {
    return run.experiment * std::max<std::size_t>(1, levels.size()) + run.level;
  }
};

/// How the ranks have spent a campaign.
struct CampaignEffort {
  std::int64_t runs = 0;  ///< done in this job
  int groups = 1;         ///< of ranks
  double wall_seconds = 0.0;
  double idle_share = 0.0;  ///< of all ranks' time, in which they waited for the others' last runs
};

/// For one level and experiment. `request` names the study's deck, whose text is given, and the
/// directory. Its overrides are of the base deck.
CampaignPlan plan_of(const StudyDeck& study, std::vector<RunFigure> figures, const std::string& deck_text,
                     const RunRequest& request);

/// The text of a study as it is kept beside its runs: below a comment for each of the overrides that came with it.
std::string copy_of_study(std::string_view text, const RunRequest& request);

/// A line for a person.
std::string effort_text(const CampaignEffort& effort, int ranks);

/// The table of these runs, with a column for each figure of the records.
void write_campaign_table(const CampaignPlan& plan, const std::vector<std::string>& columns,
                          std::span<const StudyRun> runs, std::span<const RunRecord> records);

/// DeckError when a run's deck is wrong, an override sets what the study sets itself, one of the figures is not
/// measured, a folder's name would be too long, or the directory holds results of another base deck; without a
/// directory the decks alone are checked. For rank 0.
void check_campaign(const CampaignPlan& plan, std::span<const StudyRun> runs);

/// Collective, while a ResultsDirectory has the plan's. Does the runs that are not complete, on groups of ranks which
/// draw one after the other, each in a folder of its own where it goes on if it was interrupted. A run that fails is
/// noted and ends no other. The records of all runs on rank 0; the tables are written now and then, and at the end.
/// Stopped when `stop_asked` gives a reason anywhere: the runs under way leave checkpoints. The same when `check_run`
/// throws.
std::vector<RunRecord> run_campaign(const Communicator& world, const CampaignPlan& plan, std::span<const StudyRun> runs,
                                    const StopAsked& stop_asked, CampaignEffort& effort);

}  // namespace repose
