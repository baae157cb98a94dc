#pragma once

#include <vector>

#include "calibration/estimate.h"
#include "calibration/misfit.h"

namespace repose {

/// The points at which the next runs are expected to narrow the estimate most, in the parameters' units, the best
/// first; a point may be one that has been run already, or stand there several times. Each is to be run with so many
/// seeds. Chosen one after the other: the variance of a surface after runs at a point follows without their values, if
/// the hyperparameters are held (C.17, C.18). A function of the runs so far alone: no random numbers.
///
/// A point whose nearest run has no value of an observable (a plugged orifice) is expected to have none either.
std::vector<std::vector<double>> next_points(const Misfit& misfit, const Estimate& estimate, std::size_t points,
                                             std::size_t seeds_per_point);

}  // namespace repose
