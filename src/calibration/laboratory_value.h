#pragma once

#include <cmath>
#include <limits>

namespace repose {

/// A measured observable: the mean of `repeats` measurements that scatter with `deviation`, in the observable's units.
struct LaboratoryValue {
  double value = 0.0;
  double deviation = 0.0;
  double repeats = 1.0;
  /// Degrees of freedom of the deviation. Infinite: it is known. repeats - 1: it is that of these very repeats; ten
  /// repeats taken for known would make a 95 % region one of 92 %.
  double freedom = std::numeric_limits<double>::infinity();

  double standard_error() const { return deviation / std::sqrt(repeats); }
};

}  // namespace repose
