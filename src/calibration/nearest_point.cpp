#include "calibration/nearest_point.h"

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

NearestPoint nearest_point(const Misfit& misfit, const LeastSquares& at, double limit) {
  const auto [differences, covariance] = misfit.look(at.point);
  const Vector off = differences.cwiseQuotient(covariance.diagonal().cwiseSqrt());
  return {.values = from_box(misfit.ranges(), at.point),
          .misfit = at.squares,
          .acceptable = at.squares <= limit,
          .off_by = std::vector<double>(off.begin(), off.end())};
}

void check_confidence(double confidence) {
  if (confidence > 0.0 && confidence < 1.0) return;
  throw DeckError(fmt::format("confidence {:g}: must be between 0 and 1", confidence));
}

}  // namespace repose
