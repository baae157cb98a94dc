#pragma once

#include "campaign/calibration_work.h"

namespace repose {

/// Collective. Runs at points of the levels that are decided batch after batch, each from the complete batches before
/// alone: so neither ranks nor timing can change them. Costs are counted in grains and steps, not by the clock, for the
/// same reason. `points`: those of the first design, which have been checked. Ends when two estimates in a row are
/// narrow enough, or at the budget.
DoneRuns search(const CalibrationDeck& deck, CalibrationWork& work, std::vector<LevelPoint> points);

/// The points that a search starts from, at every level: its design and those that the deck lists.
std::vector<LevelPoint> first_design(const CalibrationDeck& deck);

/// Core-hours of runs that have ended, at the deck's speed of a core. One that failed counts as long as it was expected
/// to take.
double core_hours(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records);

}  // namespace repose
