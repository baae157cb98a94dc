#include "thermal/equivalence.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "thermal/moments.h"

namespace repose::thermal {

Equivalence compare_means(std::span<const double> a, std::span<const double> b, double bound, double significance) {
  const Moments first = moments_of(a);
  const Moments second = moments_of(b);
  Equivalence e{.mean_a = first.mean,
                .mean_b = second.mean,
                .deviation_a = first.deviation(),
                .deviation_b = second.deviation(),
                .difference = second.mean - first.mean};
  const double va = first.squared_error();
  const double vb = second.squared_error();
  e.standard_error = std::sqrt(va + vb);  // (T.11)
  if (e.standard_error == 0.0) {          // every value of a sample is the same: nothing is left to chance
    e.degrees = first.count + second.count - 2.0;
    e.p_difference = e.difference == 0.0 ? 1.0 : 0.0;
    e.p_equivalence = std::abs(e.difference) < bound ? 0.0 : 1.0;
    e.low = e.high = e.difference;
    return e;
  }
  const double share = va / (va + vb);  // (T.12) by shares: the squares of the variances need not be representable
  e.degrees = 1.0 / (share * share / (first.count - 1.0) + (1.0 - share) * (1.0 - share) / (second.count - 1.0));
  e.p_difference = 2.0 * student_cdf(-std::abs(e.difference) / e.standard_error, e.degrees);
  e.p_equivalence = std::max(student_cdf(-(e.difference + bound) / e.standard_error, e.degrees),
                             student_cdf((e.difference - bound) / e.standard_error, e.degrees));  // (T.13)
  const double half = student_quantile(1.0 - significance, e.degrees) * e.standard_error;
  e.low = e.difference - half;
  e.high = e.difference + half;
  return e;
}

double thermal_growth(double diameter, double expansion, double rise) { return diameter * expansion * rise; }  // (T.14)

}  // namespace repose::thermal
