#include "calibration/confidence_part.h"

#include <algorithm>
#include <cmath>

namespace repose {
namespace {

constexpr int most_windows = 12;
constexpr double much_smaller = 0.6;  // a window worth another lattice
constexpr double accuracy = 2e-3;     // of the ends, over the cell of the last lattice
constexpr Index none = -1;
constexpr int walk = 200;            // steps from a seed to a point
constexpr double most_turned = 4.0;  // steps that another parameter may go in one

/// Which nodes are connected with the cell of `seed` through nodes of T <= limit.
std::vector<char> connected(const LatticeResiduals& l, const Vector& seed, double limit) {
  std::vector<char> inside(static_cast<std::size_t>(l.lattice.size()), 0);
  std::vector<Index> next;
  const auto take = [&](const std::vector<Index>& nodes) {
    for (const Index node : nodes) {
      char& mark = inside[static_cast<std::size_t>(node)];
      if (mark != 0 || !(l.squares[node] <= limit)) continue;
      mark = 1;
      next.push_back(node);
    }
  };
  take(l.lattice.corners(seed));
  while (!next.empty()) {
    const Index node = next.back();
    next.pop_back();
    take(l.lattice.neighbours(node));
  }
  return inside;
}

/// The nodes inside that reach farthest down and up in each parameter; `none` when there is none.
struct Farthest {
  std::vector<Index> down, up;
};

Farthest farthest(const BoxLattice& lattice, const std::vector<char>& inside) {
  const auto d = static_cast<std::size_t>(lattice.dimensions());
  Farthest result = {.down = std::vector<Index>(d, none), .up = std::vector<Index>(d, none)};
  for (Index node = 0; node < lattice.size(); ++node) {
    if (inside[static_cast<std::size_t>(node)] == 0) continue;
    const std::vector<Index> place = lattice.places(node);
    for (std::size_t j = 0; j < d; ++j) {
      Index& down = result.down[j];
      Index& up = result.up[j];
      if (down == none || place[j] < lattice.places(down)[j]) down = node;
      if (up == none || place[j] > lattice.places(up)[j]) up = node;
    }
  }
  return result;
}

/// The window that holds all nodes inside with a cell around; about the seed when no node is inside.
BoxLattice smaller_window(const BoxLattice& lattice, const Farthest& ends, const Vector& seed) {
  BoxLattice window = lattice;
  for (Index j = 0; j < lattice.dimensions(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const bool found = ends.down[k] != none;
    const double cell = lattice.spacing()[j];
    window.lower[j] = std::max(0.0, (found ? lattice.point(ends.down[k])[j] : seed[j]) - cell);
    window.upper[j] = std::min(1.0, (found ? lattice.point(ends.up[k])[j] : seed[j]) + cell);
  }
  return window;
}

struct End {
  double at;
  bool open;
};

/// From `from` inside the region, as far as parameter `j` can go in a direction (+1, -1) with T <= limit.
End farthest_end(const Residuals& residuals, const Vector& from, Index j, double direction, double step, double limit) {
  const double edge = direction > 0.0 ? 1.0 : 0.0;
  Vector inside = from;
  const auto reaches = [&](double to) {
    Vector start = inside;
    start[j] = to;
    const LeastSquares low = descend(residuals, start, j);
    if (low.squares <= limit) inside = low.point;
    return low.squares <= limit;
  };
  double outside = inside[j];
  do {
    if (inside[j] == edge) return {edge, true};
    const double ahead = inside[j] + direction * step;
    outside = direction > 0.0 ? std::min(ahead, edge) : std::max(ahead, edge);
  } while (reaches(outside));
  while (std::fabs(outside - inside[j]) > std::max(accuracy * step, 1e-12)) {
    const double middle = 0.5 * (inside[j] + outside);
    if (!reaches(middle)) outside = middle;
  }
  return {inside[j], false};
}

/// The walk along parameter `j`.
bool walk_leads_to(const Residuals& residuals, const Vector& from, const Vector& to, Index j, double limit) {
  const double step = (to[j] - from[j]) / walk;
  if (std::fabs(step) < 1e-9) return false;
  Vector at = from;
  for (int k = 1; k <= walk; ++k) {
    Vector start = at;
    start[j] = k == walk ? to[j] : from[j] + k * step;
    const LeastSquares low = descend(residuals, start, j);
    if (!(low.squares <= limit)) return false;
    if ((low.point - at).cwiseAbs().maxCoeff() > most_turned * std::fabs(step)) return false;
    at = low.point;
  }
  return (at - to).cwiseAbs().maxCoeff() <= most_turned * std::fabs(step);
}

}  // namespace

bool leads_to(const Residuals& residuals, const ConfidencePart& part, const Vector& point, double limit) {
  if ((point.array() < part.lower.array()).any() || (point.array() > part.upper.array()).any()) return false;
  for (Index j = 0; j < point.size(); ++j) {
    if (walk_leads_to(residuals, part.seed, point, j, limit)) return true;
  }
  return false;
}

bool have_same_extent(const ConfidencePart& a, const ConfidencePart& b) {
  const Vector cell = a.lattice.spacing().cwiseMax(b.lattice.spacing());
  return ((a.lower - b.lower).cwiseAbs().array() <= cell.array()).all() &&
         ((a.upper - b.upper).cwiseAbs().array() <= cell.array()).all();
}

bool ConfidencePart::contains(const Vector& point) const {
  if ((point.array() < lower.array()).any() || (point.array() > upper.array()).any()) return false;
  const std::vector<Index> corners = lattice.corners(point);
  return std::any_of(corners.begin(), corners.end(),
                     [&](Index node) { return inside[static_cast<std::size_t>(node)] != 0; });
}

ConfidencePart confidence_part(const Residuals& residuals, const LatticeResiduals& over_box, const Vector& seed,
                               double limit) {
  LatticeResiduals window = over_box;
  ConfidencePart part;
  Farthest ends;
  for (int k = 0; k < most_windows; ++k) {
    part.lattice = window.lattice;
    part.inside = connected(window, seed, limit);
    ends = farthest(part.lattice, part.inside);
    const BoxLattice smaller = smaller_window(part.lattice, ends, seed);
    const Vector shares = (smaller.upper - smaller.lower).cwiseQuotient(part.lattice.upper - part.lattice.lower);
    if (shares.minCoeff() > much_smaller) break;
    window = evaluate(residuals, smaller);
  }
  const Index d = seed.size();
  part.seed = part.lower = part.upper = seed;
  const Vector step = part.lattice.spacing();
  for (Index j = 0; j < d; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const Vector low = ends.down[k] == none ? seed : part.lattice.point(ends.down[k]);
    const Vector high = ends.up[k] == none ? seed : part.lattice.point(ends.up[k]);
    const End below = farthest_end(residuals, low[j] < seed[j] ? low : seed, j, -1.0, step[j], limit);
    const End above = farthest_end(residuals, high[j] > seed[j] ? high : seed, j, 1.0, step[j], limit);
    part.lower[j] = below.at;
    part.upper[j] = above.at;
    part.open_below.push_back(below.open);
    part.open_above.push_back(above.open);
  }
  return part;
}

}  // namespace repose
