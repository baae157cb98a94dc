#pragma once

#include "calibration/descend.h"
#include "calibration/estimate.h"

namespace repose {

/// What is said of the point at which the surfaces are nearest to the laboratory; `limit` is that of T.
NearestPoint nearest_point(const Misfit& misfit, const LeastSquares& at, double limit);

/// DeckError unless it is between 0 and 1.
void check_confidence(double confidence);

}  // namespace repose
