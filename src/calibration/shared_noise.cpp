#include "calibration/shared_noise.h"

#include <algorithm>

namespace repose {
namespace {

constexpr double least_freedom = 10.0;  // with fewer a correlation has an error above 0.3

}  // namespace

SharedNoise shared_noise(const Replicates& a, const Replicates& b) {
  SharedNoise result;
  result.partner.assign(static_cast<std::size_t>(a.size()), -1);
  result.share = Vector::Zero(a.size());
  double products = 0.0;
  for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
    const Index i = a.point_of_run[run];
    const Index j = b.point_of_run[run];
    if (i < 0 || j < 0) continue;
    products += a.rest_of_run[run] * b.rest_of_run[run];
    result.partner[static_cast<std::size_t>(i)] = j;
    result.share[i] += 1.0 / (a.count[i] * b.count[j]);
  }
  const double squares = a.squares_within * b.squares_within;
  if (std::min(a.freedom_within, b.freedom_within) < least_freedom || !(squares > 0.0)) return result;
  result.correlation = products / std::sqrt(squares);  // (C.10)
  return result;
}

}  // namespace repose
