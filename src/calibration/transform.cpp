#include "calibration/transform.h"

#include <algorithm>
#include <cmath>

namespace repose {
namespace {

constexpr double anscombe = 0.375;
constexpr double least_root = 0.5;  // below it the slope of the root says nothing of counts, which are whole numbers

}  // namespace

double transformed(Transform transform, double value) {
  if (transform == Transform::square_root) return std::sqrt(value + anscombe);
  if (transform == Transform::logarithm) return value > 0.0 ? std::log(value) : std::nan("");
  return value;
}

double mean_in_units(Transform transform, double mean, double variance) {
  if (transform == Transform::square_root) return mean * mean + variance - anscombe;  // (C.9)
  if (transform == Transform::logarithm) return std::exp(mean + 0.5 * variance);
  return mean;
}

double transformed_mean(Transform transform, double value, double variance) {
  if (transform == Transform::square_root) return std::sqrt(std::max(0.0, value + anscombe - variance));
  if (transform == Transform::logarithm) return value > 0.0 ? std::log(value) - 0.5 * variance : std::nan("");
  return value;
}

double slope_of_transform(Transform transform, double mean, double variance) {
  if (transform == Transform::square_root) return 0.5 / std::max(least_root, mean);
  if (transform == Transform::logarithm) return 1.0 / mean_in_units(transform, mean, variance);
  return 1.0;
}

}  // namespace repose
