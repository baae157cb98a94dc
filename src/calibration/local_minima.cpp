#include "calibration/local_minima.h"

#include <algorithm>
#include <cstddef>

namespace repose {
namespace {

constexpr double same = 1e-3;                       // of the box
constexpr std::size_t most_starts = 200;            // a T that is flat along a line has a start at each node of it
constexpr Index lattice_side[] = {0, 401, 61, 21};  // for each number of parameters

bool is_lowest(const LatticeResiduals& l, Index node) {
  const std::vector<Index> around = l.lattice.neighbours(node);
  return std::all_of(around.begin(), around.end(), [&](Index other) { return l.squares[node] <= l.squares[other]; });
}

/// Whether each residual has both signs at the corners of the cell above a node.
bool may_cross(const LatticeResiduals& l, Index node) {
  const Vector middle = l.lattice.point(node) + 0.5 * l.lattice.spacing();
  if ((middle.array() > l.lattice.upper.array()).any()) return false;
  const std::vector<Index> corners = l.lattice.corners(middle);
  const Matrix z = l.residuals(Eigen::all, corners);
  return (z.rowwise().minCoeff().array() <= 0.0).all() && (z.rowwise().maxCoeff().array() >= 0.0).all();
}

}  // namespace

LatticeResiduals evaluate(const Residuals& residuals, const BoxLattice& lattice) {
  LatticeResiduals result = {.lattice = lattice, .residuals = {}, .squares = Vector(lattice.size())};
  for (Index node = 0; node < lattice.size(); ++node) {
    const Vector z = residuals(lattice.point(node));
    if (node == 0) result.residuals.resize(z.size(), lattice.size());
    result.residuals.col(node) = z;
    result.squares[node] = z.squaredNorm();
  }
  return result;
}

LatticeResiduals evaluate_over_box(const Residuals& residuals, Index parameters) {
  return evaluate(residuals, unit_lattice(parameters, lattice_side[parameters]));
}

std::vector<LeastSquares> local_minima(const Residuals& residuals, const LatticeResiduals& over_box) {
  std::vector<LeastSquares> starts;
  for (Index node = 0; node < over_box.lattice.size(); ++node) {
    const Vector point = over_box.lattice.point(node);
    if (is_lowest(over_box, node)) starts.push_back({.point = point, .squares = over_box.squares[node]});
    if (may_cross(over_box, node)) {
      starts.push_back({.point = point + 0.5 * over_box.lattice.spacing(), .squares = over_box.squares[node]});
    }
  }
  const auto lower = [](const LeastSquares& a, const LeastSquares& b) { return a.squares < b.squares; };
  std::stable_sort(starts.begin(), starts.end(), lower);
  if (starts.size() > most_starts) starts.resize(most_starts);
  for (LeastSquares& start : starts) start = descend(residuals, start.point);
  std::stable_sort(starts.begin(), starts.end(), lower);
  std::vector<LeastSquares> minima;
  for (const LeastSquares& one : starts) {
    const bool known = std::any_of(minima.begin(), minima.end(), [&](const LeastSquares& other) {
      return (one.point - other.point).cwiseAbs().maxCoeff() < same;
    });
    if (!known) minima.push_back(one);
  }
  return minima;
}

}  // namespace repose
