#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace repose {

/// The value at `x` of what is linear between the points (places[k], values[k]) and constant beyond them; the places
/// rise, and there is at least one.
inline double interpolate(std::span<const double> places, std::span<const double> values, double x) {
  const auto above = static_cast<std::size_t>(std::upper_bound(places.begin(), places.end(), x) - places.begin());
  if (above == 0) return values.front();
  if (above == places.size()) return values.back();
  const std::size_t below = above - 1;
  const double share = (x - places[below]) / (places[above] - places[below]);
  return values[below] + share * (values[above] - values[below]);
}

}  // namespace repose
