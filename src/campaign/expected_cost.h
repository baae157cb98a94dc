#pragma once

#include <span>
#include <vector>

#include "campaign/run_folder.h"
#include "campaign/run_list.h"

namespace repose {

/// The runs that wait, the one expected to take longest first: a long one begun last would leave the other groups idle.
/// A run is expected to cost what the nearest complete run has, in rank-seconds; the distance is measured in the ranges
/// of the parameters. What nothing is known of keeps its order, and comes first.
std::vector<std::size_t> longest_first(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                                       std::span<const ParameterDeck> parameters);

}  // namespace repose
