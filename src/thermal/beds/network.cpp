#include "thermal/beds/network.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Sparse>
#include <fmt/core.h>

#include "base/error.h"

namespace repose::thermal {
namespace {

enum class Role { free, held, floating };

/// Held beyond the box; floating without links to a held grain.
std::vector<Role> roles_of(const std::vector<Grain>& grains, const std::vector<Link>& links, const MeasuringBox& box) {
  std::vector<Role> roles(grains.size(), Role::floating);
  std::vector<std::vector<std::size_t>> partners(grains.size());
  for (const Link& link : links) {
    partners[link.first].push_back(link.second);
    partners[link.second].push_back(link.first);
  }
  std::vector<std::size_t> front;
  bool is_beyond[2] = {false, false};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double x = grains[i].centre[box.axis];
    const bool is_below = x <= box.min[box.axis];
    if (!is_below && x < box.max[box.axis]) continue;
    is_beyond[is_below ? 0 : 1] = true;
    roles[i] = Role::held;
    front.push_back(i);
  }
  if (!is_beyond[0] || !is_beyond[1]) {
    throw DeckError(
        fmt::format("no grain lies {} the box; the grains beyond its two faces have the temperatures that "
                    "drive the heat: make it shorter",
                    is_beyond[0] ? "above" : "below"));
  }
  while (!front.empty()) {
    const std::size_t at = front.back();
    front.pop_back();
    for (const std::size_t next : partners[at]) {
      if (roles[next] != Role::floating) continue;
      roles[next] = Role::free;
      front.push_back(next);
    }
  }
  return roles;
}

/// The temperatures of all grains in K: the balance of heat of each free grain (T.19).
std::vector<double> temperatures_of(const std::vector<Grain>& grains, const std::vector<Link>& links,
                                    const std::vector<double>& conductance, const std::vector<Role>& roles,
                                    std::size_t axis) {
  std::vector<double> temperature(grains.size());
  std::vector<Eigen::Index> row(grains.size(), -1);
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    temperature[i] = grains[i].centre[axis];  // 1 K/m
    if (roles[i] == Role::free) row[i] = rows++;
  }
  if (rows == 0) return temperature;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd source = Eigen::VectorXd::Zero(rows);
  Eigen::VectorXd guess(rows);
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (row[i] >= 0) guess[row[i]] = temperature[i];
  for (std::size_t l = 0; l < links.size(); ++l) {
    const std::size_t ends[2] = {links[l].first, links[l].second};
    for (const int side : {0, 1}) {
      const Eigen::Index here = row[ends[side]];
      const std::size_t other = ends[1 - side];
      if (here < 0) continue;
      entries.emplace_back(here, here, conductance[l]);
      if (row[other] >= 0) {
        entries.emplace_back(here, row[other], -conductance[l]);
      } else {
        source[here] += conductance[l] * temperature[other];
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;  // Jacobi's preconditioner
  solver.setTolerance(1e-12);
  solver.setMaxIterations(20 * rows + 1000);
  solver.compute(matrix);
  const Eigen::VectorXd solution = solver.solveWithGuess(source, guess);
  if (solver.info() != Eigen::Success) {
    throw PhysicsError(
        fmt::format("the temperatures of {} grains have not converged after {} iterations; the residual "
                    "is {:.2g}",
                    rows, solver.iterations(), solver.error()));
  }
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (row[i] >= 0) temperature[i] = solution[row[i]];
  return temperature;
}

/// How much of the way from `start` along `way`, as a share of it, lies inside the box.
double share_inside(const Point& start, const Point& way, const MeasuringBox& box, const Periods& periods) {
  double enters = 0.0;
  double leaves = 1.0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (periods.length[d] > 0.0) continue;
    if (way[d] == 0.0) {
      if (start[d] < box.min[d] || start[d] > box.max[d]) return 0.0;
      continue;
    }
    const double a = (box.min[d] - start[d]) / way[d];
    const double b = (box.max[d] - start[d]) / way[d];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return std::max(0.0, leaves - enters);
}

double volume_of(const MeasuringBox& box) {
  return (box.max[0] - box.min[0]) * (box.max[1] - box.min[1]) * (box.max[2] - box.min[2]);
}

}  // namespace

NetworkResult conduct(const std::vector<Grain>& grains, const std::vector<Link>& links,
                      const std::vector<double>& conductance, const MeasuringBox& box, const Periods& periods) {
  const std::vector<Role> roles = roles_of(grains, links, box);
  const std::vector<double> temperature = temperatures_of(grains, links, conductance, roles, box.axis);
  const auto count = [&](Role role) { return static_cast<std::size_t>(std::count(roles.begin(), roles.end(), role)); };
  NetworkResult result{.held = count(Role::held), .free = count(Role::free), .floating = count(Role::floating)};
  const auto is_held_at = [&](std::size_t grain, int face) {
    const bool is_below = grains[grain].centre[box.axis] <= box.min[box.axis];
    return roles[grain] == Role::held && is_below == (face == 0);
  };
  double flux = 0.0;
  double heat[2] = {0.0, 0.0};  // into the cold held grains, out of the hot ones
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Link& link = links[l];
    const double along = link.difference[box.axis];
    const double power = conductance[l] * (temperature[link.second] - temperature[link.first]);  // (T.20)
    flux += power * along * share_inside(grains[link.first].centre, link.difference, box, periods);
    // Out of the hot held grains and into the cold ones, wherever they are.
    for (const int face : {0, 1}) {
      const bool first = is_held_at(link.first, face);
      if (first != is_held_at(link.second, face)) heat[face] += first == (face == 0) ? power : -power;
    }
  }
  result.conductivity = flux / volume_of(box);  // (T.21) for 1 K/m
  result.imbalance = heat[1] != 0.0 ? heat[0] / heat[1] - 1.0 : 0.0;
  return result;
}

double porosity_in(const std::vector<Grain>& grains, const MeasuringBox& box, const Periods& periods, int lines) {
  const std::size_t axis = box.axis;
  const std::array<std::size_t, 2> across = {(axis + 1) % 3, (axis + 2) % 3};
  const auto spacing = [&](std::size_t d) { return (box.max[d] - box.min[d]) / lines; };
  const double widths[2] = {spacing(across[0]), spacing(across[1])};
  double chords = 0.0;
  for (const Grain& g : grains) {
    // In a periodic direction a line beyond the box is one inside it, so no line is left out there.
    long range[2][2] = {};
    for (const int a : {0, 1}) {
      const std::size_t d = across[static_cast<std::size_t>(a)];
      double first = std::ceil((g.centre[d] - g.radius - box.min[d]) / widths[a] - 0.5);
      double last = std::floor((g.centre[d] + g.radius - box.min[d]) / widths[a] - 0.5);
      if (periods.length[d] <= 0.0) {
        first = std::clamp(first, 0.0, static_cast<double>(lines));
        last = std::clamp(last, -1.0, lines - 1.0);
      }
      range[a][0] = std::lround(first);
      range[a][1] = std::lround(last);
    }
    for (long i = range[0][0]; i <= range[0][1]; ++i) {
      const double x = box.min[across[0]] + (static_cast<double>(i) + 0.5) * widths[0] - g.centre[across[0]];
      for (long j = range[1][0]; j <= range[1][1]; ++j) {
        const double y = box.min[across[1]] + (static_cast<double>(j) + 0.5) * widths[1] - g.centre[across[1]];
        const double half = std::sqrt(std::max(0.0, g.radius * g.radius - x * x - y * y));
        const double low = std::max(box.min[axis], g.centre[axis] - half);
        const double high = std::min(box.max[axis], g.centre[axis] + half);
        chords += std::max(0.0, high - low);
      }
    }
  }
  return 1.0 - chords * widths[0] * widths[1] / volume_of(box);
}

}  // namespace repose::thermal
