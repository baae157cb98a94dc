#include "calibration/start_design.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/philox.h"

namespace repose {
namespace {

constexpr std::uint64_t tries = 2000;
constexpr std::uint32_t exchanges = 30000;  // that are tried to spread a hypercube in more than three dimensions

/// Each column is a permutation of equal steps from 0 to 1.
Matrix latin_hypercube(Index points, Index parameters, std::uint64_t seed, std::uint64_t attempt) {
  Matrix design(points, parameters);
  std::uint32_t k = 0;
  for (Index j = 0; j < parameters; ++j) {
    for (Index i = 0; i < points; ++i) {
      design(i, j) = points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0.5;
    }
    for (Index i = points - 1; i > 0; --i) {
      const double u = uniform(seed, attempt, RandomStream::start_design, k++);
      std::swap(design(i, j), design(static_cast<Index>(u * static_cast<double>(i + 1)), j));
    }
  }
  return design;
}

double least_distance(const Matrix& design) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < design.rows(); ++i) {
    for (Index j = 0; j < i; ++j) least = std::min(least, (design.row(i) - design.row(j)).squaredNorm());
  }
  return least;
}

/// What is least for points that are apart: the sum over pairs with the row of distance^-10, of Morris and Mitchell's
/// criterion.
double crowding(const Matrix& design, Index row, Index without) {
  double sum = 0.0;
  for (Index i = 0; i < design.rows(); ++i) {
    if (i == row || i == without) continue;
    const double squares = (design.row(i) - design.row(row)).squaredNorm();
    sum += 1.0 / (squares * squares * squares * squares * squares);
  }
  return sum;
}

/// The hypercube with values of two points exchanged in one parameter as often as that spreads it.
Matrix spread(Matrix design, std::uint64_t seed) {
  const auto n = static_cast<double>(design.rows());
  const auto d = static_cast<double>(design.cols());
  for (std::uint32_t k = 0; k < exchanges; ++k) {
    const auto number = [&](std::uint32_t j) { return uniform(seed, tries, RandomStream::start_design, 3 * k + j); };
    const auto a = static_cast<Index>(number(0) * n);
    const auto b = static_cast<Index>(number(1) * n);
    const auto j = static_cast<Index>(number(2) * d);
    if (a == b) continue;
    // The distance between the two stays.
    const double before = crowding(design, a, b) + crowding(design, b, a);
    std::swap(design(a, j), design(b, j));
    if (crowding(design, a, b) + crowding(design, b, a) >= before) std::swap(design(a, j), design(b, j));
  }
  return design;
}

}  // namespace

std::vector<std::vector<double>> start_design(const std::vector<ParameterRange>& ranges, std::size_t points,
                                              std::uint64_t seed) {
  if (points == 0 || ranges.empty()) throw DeckError("a start design needs a parameter and a point or more");
  Matrix best;
  double farthest = -1.0;
  for (std::uint64_t attempt = 0; attempt < tries; ++attempt) {
    const Matrix design = latin_hypercube(static_cast<Index>(points), static_cast<Index>(ranges.size()), seed, attempt);
    const double distance = least_distance(design);
    if (distance <= farthest) continue;
    farthest = distance;
    best = design;
  }
  if (ranges.size() > 3) best = spread(std::move(best), seed);
  std::vector<std::vector<double>> result;
  for (Index i = 0; i < best.rows(); ++i) result.push_back(from_box(ranges, best.row(i).transpose()));
  return result;
}

std::vector<std::vector<double>> points_between(const std::vector<ParameterRange>& ranges,
                                                std::span<const std::vector<double>> known, std::size_t points,
                                                std::uint64_t seed) {
  const auto d = static_cast<Index>(ranges.size());
  std::vector<Vector> taken;
  for (const std::vector<double>& values : known) taken.push_back(to_box(ranges, values));
  std::vector<std::vector<double>> result;
  while (result.size() < points) {
    Vector best;
    double farthest = -1.0;
    for (std::uint64_t attempt = 0; attempt < tries; ++attempt) {
      Vector point(d);
      for (Index j = 0; j < d; ++j) {
        point[j] = uniform(seed, tries + 1 + attempt, RandomStream::start_design, static_cast<std::uint32_t>(j));
      }
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector& other : taken) nearest = std::min(nearest, (point - other).squaredNorm());
      if (nearest <= farthest) continue;
      farthest = nearest;
      best = point;
    }
    taken.push_back(best);
    result.push_back(from_box(ranges, best));
  }
  return result;
}

}  // namespace repose
