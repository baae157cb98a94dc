#pragma once

#include <span>

/// Whether two sets of repeated measurements are the same within bounds, which an absent significance does not show.
namespace repose::thermal {

/// Two samples compared, B minus A.
struct Equivalence {
  double mean_a = 0.0;
  double mean_b = 0.0;
  double deviation_a = 0.0;  ///< standard deviations
  double deviation_b = 0.0;
  double difference = 0.0;      ///< of the means
  double standard_error = 0.0;  ///< of the difference (Welch)
  double degrees = 0.0;         ///< of freedom (Welch and Satterthwaite)
  double p_difference = 0.0;    ///< two-sided, that the means are equal
  double p_equivalence = 0.0;   ///< greater of the two one-sided, that they differ by the bound or more
  double low = 0.0;             ///< of the interval of the difference that the two one-sided tests correspond to
  double high = 0.0;
};

/// Two one-sided tests against a bound > 0 on the difference of the means (theory T.11 to T.13): Schuirmann 1987,
/// doi:10.1007/BF01068419, with unequal variances after Welch 1947, doi:10.1093/biomet/34.1-2.28. The interval is that
/// of 1 - 2 significance. Each sample needs two values.
Equivalence compare_means(std::span<const double> a, std::span<const double> b, double bound, double significance);

/// Growth of a diameter in m with the temperature: its expansion coefficient in 1/K times the rise in K (T.14).
double thermal_growth(double diameter, double expansion, double rise);

}  // namespace repose::thermal
