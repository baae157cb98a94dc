#include "calibration/search_nodes.h"

#include <algorithm>
#include <vector>

#include "calibration/lattice.h"

namespace repose {
namespace {

// Nodes along each parameter, for each number of parameters: of lattices over the box and over a part of the region, on
// which the doubt is summed, and of those from which points are chosen.
constexpr Index sum_over_box[] = {0, 301, 31, 13};
constexpr Index sum_over_part[] = {0, 61, 15, 9};
constexpr Index choice_over_box[] = {0, 101, 21, 11};
constexpr Index choice_over_part[] = {0, 9, 5, 3};

constexpr double least_half_width = 0.02;  // of a window, in the box
constexpr double nearest_half_width = 0.1;

void append(SearchNodes& nodes, const BoxLattice& lattice) {
  const Index before = nodes.points.rows();
  const Index d = lattice.dimensions();
  nodes.points.conservativeResize(before + lattice.size(), d);
  nodes.volume.conservativeResize(before + lattice.size());
  for (Index node = 0; node < lattice.size(); ++node) {
    nodes.points.row(before + node) = lattice.point(node).transpose();
    nodes.volume[before + node] = lattice.spacing().prod();
  }
}

/// A window about each part of the region with half its extent around, or about the nearest point: where the region is
/// small a lattice over the box would miss it.
std::vector<BoxLattice> windows(const Misfit& misfit, const Estimate& estimate) {
  const Index d = misfit.parameters();
  std::vector<BoxLattice> result;
  for (const RegionPart& part : estimate.parts) {
    BoxLattice window = unit_lattice(d, 2);
    for (Index j = 0; j < d; ++j) {
      const ParameterRange& range = misfit.ranges()[static_cast<std::size_t>(j)];
      const ConfidenceInterval& interval = part.intervals[static_cast<std::size_t>(j)];
      const double width = range.upper - range.lower;
      const double half = std::max((interval.upper - interval.lower) / width, least_half_width);
      const double middle = (0.5 * (interval.lower + interval.upper) - range.lower) / width;
      window.lower[j] = std::max(0.0, middle - half);
      window.upper[j] = std::min(1.0, middle + half);
    }
    result.push_back(window);
  }
  if (result.empty()) {
    const Vector nearest = to_box(misfit.ranges(), estimate.nearest.values);
    result.push_back({.lower = (nearest.array() - nearest_half_width).cwiseMax(0.0),
                      .upper = (nearest.array() + nearest_half_width).cwiseMin(1.0),
                      .side = 2});
  }
  return result;
}

SearchNodes nodes_over(const Misfit& misfit, const Estimate& estimate, const Index* over_box, const Index* over_part) {
  const Index d = misfit.parameters();
  SearchNodes nodes;
  append(nodes, unit_lattice(d, over_box[d]));
  for (BoxLattice window : windows(misfit, estimate)) {
    window.side = over_part[d];
    append(nodes, window);
  }
  return nodes;
}

}  // namespace

SearchNodes nodes_of_sum(const Misfit& misfit, const Estimate& estimate) {
  return nodes_over(misfit, estimate, sum_over_box, sum_over_part);
}

Matrix candidates(const Misfit& misfit, const Estimate& estimate) {
  Matrix points = nodes_over(misfit, estimate, choice_over_box, choice_over_part).points;
  const Index fresh = points.rows();
  points.conservativeResize(fresh + misfit.runs().rows(), points.cols());
  points.bottomRows(misfit.runs().rows()) = misfit.runs();
  return points;
}

}  // namespace repose
