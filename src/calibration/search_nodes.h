#pragma once

#include "calibration/estimate.h"
#include "calibration/misfit.h"

namespace repose {

/// Points of the unit box.
struct SearchNodes {
  Matrix points;  ///< one per row
  Vector volume;  ///< of the box, for each; of a posterior, the share of each sample
};

/// Where the doubt is summed, and where points are chosen from: lattices over the box and about each part of the
/// region, or samples of the posterior and points over the box. To choose from there are also the points of the runs
/// that are there.
SearchNodes nodes_of_sum(const Misfit& misfit, const Estimate& estimate);
Matrix candidates(const Misfit& misfit, const Estimate& estimate);

}  // namespace repose
