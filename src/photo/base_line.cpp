#include "photo/base_line.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace repose::photo {
namespace {

constexpr double near = 1.5;             // px, from the plate's edge
constexpr double least_share = 1.0 / 7;  // of the columns
constexpr double steepest = 0.07;        // tan(4 degrees)
constexpr std::size_t tries = 60;        // places on each side from which a line is drawn
constexpr double foot_share = 0.05;      // of the columns, on each side

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
  for (std::size_t y = patch.top; y <= patch.bottom; ++y) {
    for (std::size_t i = 0; i < n; ++i) {
      if (patches.at(patch.left + i, y) != which) continue;
      if (columns.top[i] < 0.0) columns.top[i] = static_cast<double>(y) - 0.5;
      columns.bottom[i] = static_cast<double>(y) + 0.5;
    }
  }
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

/// The lowest rows of the columns from `begin` to `end`, but for a fifth of them that a stray may have.
double foot(const Columns& columns, std::size_t begin, std::size_t end) {
  std::vector<double> rows(columns.bottom.begin() + static_cast<std::ptrdiff_t>(begin),
                           columns.bottom.begin() + static_cast<std::ptrdiff_t>(end));
  const auto at = rows.begin() + static_cast<std::ptrdiff_t>(4 * rows.size() / 5);
  std::nth_element(rows.begin(), at, rows.end());
  return *at;
}

}  // namespace

BaseLine find_base_line(const Patches& patches, std::int32_t pile) {
  const Columns columns = columns_of(patches, pile);
  const auto first = static_cast<double>(columns.left);
  const std::size_t n = columns.size();
  const Line line = best_line(columns);
  if (static_cast<double>(support(line, columns)) >= least_share * static_cast<double>(n)) {
    const Line edge = refined(line, columns);
    BaseLine result{.y_at_0 = edge.at_0 - edge.slope * first, .slope = edge.slope, .plate_left = {}, .plate_right = {}};
    for (std::size_t i = 0; i < n; ++i) {
      if (!edge.holds(columns, i)) continue;
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
