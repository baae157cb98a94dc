#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/acquisition.h"
#include "campaign/run_list.h"
#include "deck/calibration_deck.h"

namespace repose {

/// All seeds at each point of the levels by each experiment, level after level, in folders below the names of both. A
/// point of a level that stands there again gets the next seeds. `overrides` are of all base decks and come last.
std::vector<StudyRun> level_runs(const CalibrationDeck& deck, const std::vector<std::string>& overrides,
                                 std::span<const LevelPoint> points);

/// The runs of all levels and experiments that have folders in `directory`. FileError when it cannot be read.
std::vector<StudyRun> level_runs_in(const std::string& directory, const CalibrationDeck& deck);

/// The same points at every level.
std::vector<LevelPoint> at_every_level(const CalibrationDeck& deck, const std::vector<std::vector<double>>& points);

}  // namespace repose
