#include "calibration/shared_noise.h"

#include <algorithm>

namespace repose {
namespace {

constexpr double least_freedom = 10.0;  // with fewer a correlation has an error above 0.3

/// Sums over the runs that have both observables, of their differences from the means of these runs at their points.
struct CommonRests {
  double products = 0.0;
  double squares_a = 0.0;
  double squares_b = 0.0;
  double freedom = 0.0;
};

/// Whether a run has both.
bool has_both(const Replicates& a, const Replicates& b, std::size_t run) {
  return a.point_of_run[run] >= 0 && b.point_of_run[run] >= 0;
}

bool have_the_same_runs(const Replicates& a, const Replicates& b) {
  for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
    if ((a.point_of_run[run] < 0) != (b.point_of_run[run] < 0)) return false;
  }
  return true;
}

/// Means of the rests of the common runs at each point of `a`; 0 where none lacks a value.
struct CommonMeans {
  Vector of_a, of_b, count;
};

CommonMeans common_means(const Replicates& a, const Replicates& b) {
  CommonMeans means = {Vector::Zero(a.size()), Vector::Zero(a.size()), Vector::Zero(a.size())};
  for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
    if (!has_both(a, b, run)) continue;
    const Index i = a.point_of_run[run];
    means.of_a[i] += a.rest_of_run[run];
    means.of_b[i] += b.rest_of_run[run];
    means.count[i] += 1.0;
  }
  means.of_a = means.of_a.cwiseQuotient(means.count.cwiseMax(1.0));
  means.of_b = means.of_b.cwiseQuotient(means.count.cwiseMax(1.0));
  return means;
}

CommonRests common_rests(const Replicates& a, const Replicates& b) {
  CommonRests sums;
  if (have_the_same_runs(a, b)) {
    for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
      if (has_both(a, b, run)) sums.products += a.rest_of_run[run] * b.rest_of_run[run];
    }
    sums.squares_a = a.squares_within;
    sums.squares_b = b.squares_within;
    sums.freedom = std::min(a.freedom_within, b.freedom_within);
    return sums;
  }
  const CommonMeans means = common_means(a, b);
  for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
    if (!has_both(a, b, run)) continue;
    const Index i = a.point_of_run[run];
    const double rest_a = a.rest_of_run[run] - means.of_a[i];
    const double rest_b = b.rest_of_run[run] - means.of_b[i];
    sums.products += rest_a * rest_b;
    sums.squares_a += rest_a * rest_a;
    sums.squares_b += rest_b * rest_b;
  }
  sums.freedom = means.count.sum() - static_cast<double>((means.count.array() > 0.0).count());
  return sums;
}

}  // namespace

SharedNoise shared_noise(const Replicates& a, const Replicates& b) {
  SharedNoise result;
  result.partner.assign(static_cast<std::size_t>(a.size()), -1);
  result.share = Vector::Zero(a.size());
  for (std::size_t run = 0; run < a.point_of_run.size(); ++run) {
    const Index i = a.point_of_run[run];
    const Index j = b.point_of_run[run];
    if (i < 0 || j < 0) continue;
    result.partner[static_cast<std::size_t>(i)] = j;
    result.share[i] += 1.0 / (a.count[i] * b.count[j]);
  }
  const CommonRests common = common_rests(a, b);
  const double squares = common.squares_a * common.squares_b;
  if (common.freedom < least_freedom || !(squares > 0.0)) return result;
  result.correlation = common.products / std::sqrt(squares);  // (C.10)
  return result;
}

}  // namespace repose
