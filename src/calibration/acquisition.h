#pragma once

#include <functional>
#include <limits>
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

/// A point and the level of the model at which it is to be run.
struct LevelPoint {
  std::size_t level = 0;
  std::vector<double> values;
};

/// What a search over levels may do in a batch.
struct BatchPlan {
  std::size_t points = 1;
  std::vector<std::size_t> seeds;                           ///< at a point, for each experiment one per level
  std::function<double(const LevelPoint&)> cost;            ///< predicted, of all seeds at a point; above 0
  double budget = std::numeric_limits<double>::infinity();  ///< of the batch, in the unit of the cost
};

/// The same over levels: each point and level is the one that is expected to narrow most per cost (C.29). Fewer points
/// than asked for, or none, when the budget takes no more.
std::vector<LevelPoint> next_level_points(const Misfit& misfit, const Estimate& estimate, const BatchPlan& batch);

}  // namespace repose
