#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/acquisition.h"
#include "campaign/campaign.h"
#include "campaign/curve_observables.h"
#include "deck/calibration_deck.h"

namespace repose {

/// The figures of the observables that are no curves.
std::vector<RunFigure> run_figures(const CalibrationDeck& deck);

/// Runs and what has become of them.
struct DoneRuns {
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;  ///< on rank 0
};

/// Collective. Does the runs of a calibration, batch after batch.
class CalibrationWork {
 public:
  /// Refers to its arguments. `request` names the calibration deck, whose text is given, and the directory; its
  /// overrides are of all base decks.
  CalibrationWork(const Communicator& world, const CalibrationDeck& deck, const std::string& text,
                  const RunRequest& request, const StopAsked& stop_asked);

  /// A report to be renewed while runs go on. For rank 0.
  void renew(LiveReport& report) { plan_.report = &report; }

  /// DeckError, FileError when the runs at these points cannot be in the directory. For rank 0.
  void check(std::span<const LevelPoint> points) const;

  /// The runs at all these points, which have been checked; what is complete is not done again. FileError, Stopped.
  DoneRuns at(std::span<const LevelPoint> points);

  /// What the runs at these points would take, for a person; runs nothing. For rank 0. DeckError, FileError.
  std::string planned(std::span<const LevelPoint> points) const;

  /// Puts the scores of curves into the tables of the runs. For rank 0.
  void write_table(const Projection& projection, std::span<const StudyRun> runs) const;

  const Communicator& world() const { return world_; }
  const RunLog& log() const { return plan_.log; }
  const std::string& directory() const { return plan_.directory; }
  const CampaignEffort& effort() const { return effort_; }  ///< of all batches

 private:
  const Communicator& world_;
  const CalibrationDeck& deck_;
  const std::vector<std::string>& overrides_;
  StopAsked stop_asked_;
  CampaignPlan plan_;
  CampaignEffort effort_;
};

}  // namespace repose
