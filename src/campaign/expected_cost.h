#pragma once

#include <functional>
#include <span>
#include <vector>

#include "campaign/run_folder.h"
#include "campaign/run_list.h"

namespace repose {

/// The work of a run before anything is known of it, such as particles times steps.
using WorkOf = std::function<double(const StudyRun&)>;

/// The runs that wait. First those with a checkpoint, lest a job that is stopped time and again begin all and end none;
/// then the one expected to take longest: a long one begun last would leave the other groups idle. A run is expected to
/// take its work at the speed of the nearest complete run; distances are in the ranges of the parameters. Runs that are
/// expected to take as long keep their order.
std::vector<std::size_t> begun_then_longest(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                                            std::span<const ParameterDeck> parameters, const WorkOf& work_of);

/// Particles times steps that a run is expected to take, from complete runs of its test, the nearest most: what the
/// clock says of them must not change a decision. 1 when there is none.
double expected_particle_steps(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                               std::span<const ParameterDeck> parameters, std::size_t level, std::size_t experiment,
                               const std::vector<double>& values);

}  // namespace repose
