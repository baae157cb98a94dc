#pragma once

#include <cmath>
#include <numeric>
#include <span>

namespace repose::thermal {

/// Of at least one value.
inline double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Mean and scatter of a sample.
struct Moments {
  double mean = 0.0;
  double variance = 0.0;  ///< unbiased
  double count = 0.0;

  double deviation() const { return std::sqrt(variance); }
  double squared_error() const { return variance / count; }  ///< of the mean
};

/// Of at least two values.
inline Moments moments_of(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, squares / (n - 1.0), n};
}

}  // namespace repose::thermal
