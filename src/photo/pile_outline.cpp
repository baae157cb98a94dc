#include "photo/pile_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace repose::photo {
namespace {

/// Between the column `outside` and its neighbour inside at a row between two of the picture.
double crossing(const Image& excess, double outside, double inside, double row, double threshold) {
  const double a = sample(excess, outside, row);
  const double b = sample(excess, inside, row);
  if (a >= threshold || b <= threshold) return 0.5 * (outside + inside);
  return outside + (inside - outside) * (threshold - a) / (b - a);
}

}  // namespace

Extent extent_of(const Level& level, double threshold) {
  Extent extent;
  extent.patches = find_patches(level.excess.width, level.excess.height, [&](std::size_t x, std::size_t y) {
    return static_cast<double>(y) <= level.base_row - 0.5 && level.excess.at(x, y) > threshold;
  });
  extent.found = largest(extent.patches.all);
  return extent;
}

double contrast_of_pile(const Level& level, const Extent& extent) {
  std::vector<float> values;
  extent.patches.for_each_pixel(extent.found.first,
                                [&](std::size_t x, std::size_t y) { values.push_back(level.excess.at(x, y)); });
  return static_cast<double>(median(values));
}

Silhouette outline_of(const Level& level, const Extent& extent, double threshold) {
  const Patch& pile = extent.pile();
  Silhouette outline{.base = 0.0, .row_height = 1.0, .top = 0.0, .left = {}, .right = {}};
  outline.top = level.base_row - static_cast<double>(pile.top) + 0.5;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto rows = static_cast<std::size_t>(outline.top);
  outline.left.assign(rows, nan);
  outline.right.assign(rows, nan);
  for (std::size_t i = 0; i < rows; ++i) {
    const double row = level.base_row - outline.row_z(i);
    const auto y = static_cast<std::size_t>(std::max(0.0, std::round(row)));
    if (y >= level.excess.height) continue;  // a base line below the picture
    for (std::size_t x = pile.left; x <= pile.right; ++x) {
      if (extent.patches.at(x, y) != extent.found.first) continue;
      const auto column = static_cast<double>(x);
      if (std::isnan(outline.left[i])) outline.left[i] = crossing(level.excess, column - 1.0, column, row, threshold);
      outline.right[i] = column;
    }
    if (!std::isnan(outline.right[i])) {
      outline.right[i] = crossing(level.excess, outline.right[i] + 1.0, outline.right[i], row, threshold);
    }
  }
  return outline;
}

double blur_of(const Level& level, const Silhouette& outline, double contrast) {
  constexpr double wider = 1.9;
  std::vector<float> widths;
  for (std::size_t i = 0; i < outline.left.size(); ++i) {
    const double row = level.base_row - outline.row_z(i);
    for (const double side : {-1.0, 1.0}) {
      const double edge = side < 0.0 ? outline.left[i] : outline.right[i];
      if (std::isnan(edge)) continue;
      const double reach = 0.25 * (outline.right[i] - outline.left[i]);
      const auto distance_to = [&](double share, double way) {
        double d = 0.0;
        while (std::abs(d) < reach + 1.0) {
          const double value = sample(level.excess, edge + side * d, row);
          if (way > 0.0 ? value < share * contrast : value > share * contrast) break;
          d += 0.5 * way;
        }
        return std::abs(d);
      };
      widths.push_back(static_cast<float>(distance_to(0.25, 1.0) + distance_to(0.75, -1.0)));
    }
  }
  if (widths.empty()) return 0.0;
  const auto fifth = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 5);
  std::nth_element(widths.begin(), fifth, widths.end());
  return wider * static_cast<double>(*fifth);
}

double roughness(const Silhouette& outline, const FlankView& fit) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < outline.left.size(); ++i) {
    const double z = outline.row_z(i);
    if (z < fit.z_from || z > fit.z_to || std::isnan(outline.left[i])) continue;
    for (const auto& [off, flank] : {std::pair(outline.left[i] - fit.left.u(z), fit.left),
                                     std::pair(outline.right[i] - fit.right.u(z), fit.right)}) {
      sum += off * off / (1.0 + flank.slope * flank.slope);
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace repose::photo
