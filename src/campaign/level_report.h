#pragma once

#include <optional>
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

/// How many of the runs have come to what: a line.
std::string states_text(std::span<const RunRecord> records);

/// An observable without a surface: it has a value at fewer points of a level than one takes.
struct TooFewPoints {
  std::size_t level = 0;
  std::string what;        ///< for a person: observable, points
  std::string with_level;  ///< the same after the level's name, where there are several
};

/// The first such at the levels from `first` to `last`. Records have the figures of all observables of the deck, or of
/// those that are no curves; a curve then has a value where its run counts for it.
std::optional<TooFewPoints> too_few_points(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                           std::span<const RunRecord> records, std::size_t first, std::size_t last);

/// DeckError when an observable has too few points at any level, with what the runs have come to.
void require_surfaces(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records);

/// What a calibration is when a level of the model has too few runs yet.
struct KnownLevels {
  CalibrationDeck deck;  ///< with the levels that are known
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;
  std::string left_out;  ///< for a person: a line on the first that is not; empty: all are
};

/// The levels from the cheapest on, up to the first above it of which an observable has a value at fewer points than a
/// surface takes.
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

/// Of each level what has been run: points, runs and work in core-hours.
nlohmann::ordered_json levels_json(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                   std::span<const RunRecord> records);
std::string levels_text(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                        std::span<const RunRecord> records);

/// Of each observable and level what it takes of the level below, rho, what that explains, and whose scatter its runs
/// are taken to have.
nlohmann::ordered_json links_json(const CalibrationDeck& deck, const Misfit& misfit, Index observable);
std::string links_text(const CalibrationDeck& deck, const Misfit& misfit);

}  // namespace repose
