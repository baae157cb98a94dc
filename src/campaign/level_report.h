#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "calibration/estimate.h"
#include "campaign/run_folder.h"
#include "campaign/run_list.h"
#include "deck/calibration_deck.h"

namespace repose {

/// What an estimate would be with less: said beside the one that counts.
struct OtherEstimate {
  std::string what;  ///< for a person, such as "coarse alone"
  Misfit misfit;
  Estimate estimate;
};

/// What a calibration is when a level of the model has too few runs yet.
struct KnownLevels {
  CalibrationDeck deck;  ///< with the levels that are known
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;
  std::string left_out;  ///< for a person: a line on the first that is not; empty: all are
};

/// The levels from the cheapest on, up to the first above it of which fewer points are done than a surface takes.
KnownLevels known_levels(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                         std::span<const RunRecord> records);

/// From the runs of the cheapest level alone, as if it were the one that counts. For decks with levels.
OtherEstimate first_level_alone(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                std::span<const RunRecord> records);

/// From the runs and observables of each experiment alone that has as many observables as there are parameters. For
/// decks with several.
std::vector<OtherEstimate> experiments_alone(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                             std::span<const RunRecord> records);

/// As if the model had no discrepancy. For decks with one.
OtherEstimate without_discrepancy(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                  std::span<const RunRecord> records);
bool has_discrepancy(const CalibrationDeck& deck);

/// Of each level its points, runs and work in core-hours.
nlohmann::ordered_json levels_json(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                   std::span<const RunRecord> records);
std::string levels_text(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                        std::span<const RunRecord> records);

/// Of each observable and level what it takes of the level below, rho, and what that explains.
nlohmann::ordered_json links_json(const CalibrationDeck& deck, const Misfit& misfit, Index observable);
std::string links_text(const CalibrationDeck& deck, const Misfit& misfit);

}  // namespace repose
