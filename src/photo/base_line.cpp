#include "photo/base_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace repose::photo {
namespace {

constexpr double near = 1.5;             // px, from the plate's edge
constexpr double least_share = 1.0 / 7;  // of the columns that lie on it, and of the pile's height that is beneath it
constexpr double deepest_layer = 0.25;   // of the pile's height
constexpr double layer_share = 0.25;     // of the difference of a layer of grains from the plate, at which it ends
constexpr std::size_t most_places = 2000;
constexpr double steepest = 0.07;    // tan(4 degrees)
constexpr std::size_t tries = 60;    // places on each side from which a line is drawn
constexpr double foot_share = 0.05;  // of the columns, on each side

/// First and last row of a patch in each of its columns.
struct Columns {
  std::size_t left = 0;
  std::vector<double> top, bottom;

  std::size_t size() const { return top.size(); }
};

Columns columns_of(const Patches& patches, std::int32_t which) {
  const Patch& patch = patches.all[static_cast<std::size_t>(which)];
  const std::size_t n = patch.right - patch.left + 1;
  Columns columns{.left = patch.left, .top = std::vector<double>(n, -1.0), .bottom = std::vector<double>(n, -1.0)};
  patches.for_each_pixel(which, [&](std::size_t x, std::size_t y) {
    const std::size_t i = x - patch.left;
    if (columns.top[i] < 0.0) columns.top[i] = static_cast<double>(y) - 0.5;
    columns.bottom[i] = static_cast<double>(y) + 0.5;
  });
  return columns;
}

struct Line {
  double at_0 = 0.0;  ///< at the first column
  double slope = 0.0;

  bool holds(const Columns& columns, std::size_t i) const {
    return std::abs(columns.top[i] - at_0 - slope * static_cast<double>(i)) <= near;
  }
};

std::size_t support(const Line& line, const Columns& columns) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) count += line.holds(columns, i) ? 1U : 0U;
  return count;
}

/// The line through tops of a left and a right column that most columns agree with.
Line best_line(const Columns& columns) {
  Line best;
  std::size_t most = 0;
  const std::size_t third = columns.size() / 3;
  const std::size_t step = std::max<std::size_t>(1, third / tries);
  for (std::size_t i = 0; i < third; i += step) {
    for (std::size_t j = columns.size() - third; j < columns.size(); j += step) {
      const double slope = (columns.top[j] - columns.top[i]) / static_cast<double>(j - i);
      if (std::abs(slope) > steepest) continue;
      const Line line{columns.top[i] - slope * static_cast<double>(i), slope};
      const std::size_t count = support(line, columns);
      if (count <= most) continue;
      most = count;
      best = line;
    }
  }
  return best;
}

/// Least squares over the columns that hold to it; twice, as the first may be off by their tolerance.
Line refined(Line line, const Columns& columns) {
  for (int round = 0; round < 2; ++round) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!line.holds(columns, i)) continue;
      const Eigen::Vector2d t(1.0, static_cast<double>(i));
      normal += t * t.transpose();
      right += columns.top[i] * t;
    }
    const Eigen::Vector2d solution = normal.ldlt().solve(right);
    line = {solution[0], solution[1]};
  }
  return line;
}

/// How far the tops lie below the line, sorted (px; above it negative).
std::vector<double> depths_below(const Line& line, const Columns& columns) {
  std::vector<double> depths;
  for (std::size_t i = 0; i < columns.size(); ++i)
    depths.push_back(columns.top[i] - line.at_0 - line.slope * static_cast<double>(i));
  std::sort(depths.begin(), depths.end());
  return depths;
}

/// Whether there is more beneath the line than a layer of grains.
bool is_plate(const Line& line, const Columns& columns) {
  if (static_cast<double>(support(line, columns)) < least_share * static_cast<double>(columns.size())) return false;
  std::vector<double> thickness;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (line.holds(columns, i)) thickness.push_back(columns.bottom[i] - columns.top[i]);
  }
  std::nth_element(thickness.begin(), thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 2),
                   thickness.end());
  return thickness[thickness.size() / 2] > -least_share * depths_below(line, columns).front();
}

/// The quartiles of brightness along the line, so many px below it.
std::array<double, 3> quartiles(const Image& excess, const Columns& columns, const Line& line, double below) {
  std::vector<float> values;
  const std::size_t step = std::max<std::size_t>(1, columns.size() / most_places);
  for (std::size_t i = 0; i < columns.size(); i += step) {
    const auto x = static_cast<double>(i);
    values.push_back(static_cast<float>(
        sample(excess, static_cast<double>(columns.left) + x, line.at_0 + line.slope * x + below + 0.5)));
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](std::size_t quarters) { return static_cast<double>(values[quarters * (values.size() - 1) / 4]); };
  return {at(1), at(2), at(3)};
}

/// The edge of the plate, which is the line itself or lies below it by a layer of grains that goes all along it: the
/// quartiles of the layer's brightness are others than the plate's.
Line plate_edge(Line line, const Columns& columns, const Image& excess) {
  const double deepest = deepest_layer * -depths_below(line, columns).front();
  if (!(deepest >= 1.0)) return line;  // a pile of less than four pixels, or none
  const std::array<double, 3> plate = quartiles(excess, columns, line, deepest);
  std::vector<double> off;  // at each depth, from the plate's quartiles
  for (double below = 0.0; below < deepest; below += 1.0) {
    const std::array<double, 3> here = quartiles(excess, columns, line, below);
    off.push_back(0.0);
    for (std::size_t i = 0; i < 3; ++i) off.back() = std::max(off.back(), std::abs(here[i] - plate[i]));
  }
  const double layer = *std::max_element(off.begin(), off.end());
  if (layer < 3.0 * (plate[2] - plate[0])) return line;
  std::size_t depth = off.size();
  while (depth > 0 && off[depth - 1] < layer_share * layer) --depth;
  // A blurred edge is where it is steepest, above where it has ended.
  const auto fall = [&](std::size_t k) { return off[k - 1] - (k < off.size() ? off[k] : 0.0); };
  while (depth > 1 && fall(depth - 1) > fall(depth)) --depth;
  line.at_0 += static_cast<double>(depth);
  return line;
}

/// The lowest rows of the columns from `begin` to `end`, but for a fifth of them that a stray may have.
double foot(const Columns& columns, std::size_t begin, std::size_t end) {
  std::vector<double> rows(columns.bottom.begin() + static_cast<std::ptrdiff_t>(begin),
                           columns.bottom.begin() + static_cast<std::ptrdiff_t>(end));
  const auto at = rows.begin() + static_cast<std::ptrdiff_t>(4 * rows.size() / 5);
  std::nth_element(rows.begin(), at, rows.end());
  return *at;
}

}  // namespace

BaseLine find_base_line(const Image& excess, const Patches& patches, std::int32_t pile) {
  const Columns columns = columns_of(patches, pile);
  const auto first = static_cast<double>(columns.left);
  const std::size_t n = columns.size();
  const Line line = refined(best_line(columns), columns);
  if (is_plate(line, columns)) {
    const Line edge = plate_edge(line, columns, excess);
    BaseLine result{.y_at_0 = edge.at_0 - edge.slope * first, .slope = edge.slope, .plate_left = {}, .plate_right = {}};
    for (std::size_t i = 0; i < n; ++i) {
      if (columns.top[i] - edge.at_0 - edge.slope * static_cast<double>(i) > near) continue;  // beside the plate
      if (!result.plate_left) result.plate_left = first + static_cast<double>(i) - 0.5;
      result.plate_right = first + static_cast<double>(i) + 0.5;
    }
    return result;
  }
  const std::size_t width = std::max<std::size_t>(1, static_cast<std::size_t>(foot_share * static_cast<double>(n)));
  const double left = foot(columns, 0, width);
  const double right = foot(columns, n - width, n);
  const double between = static_cast<double>(n - width);
  const double slope = between > 0.0 ? (right - left) / between : 0.0;
  const double middle_of_left = first + 0.5 * static_cast<double>(width - 1);
  return {.y_at_0 = left - slope * middle_of_left, .slope = slope, .plate_left = {}, .plate_right = {}};
}

}  // namespace repose::photo
