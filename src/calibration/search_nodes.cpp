#include "calibration/search_nodes.h"

#include <algorithm>
#include <vector>

#include "base/philox.h"
#include "calibration/lattice.h"

namespace repose {
namespace {

// Nodes along each parameter, for each number of parameters: of lattices over the box and over a part of the region, on
// which the doubt is summed, and of those from which points are chosen.
constexpr Index sum_over_box[] = {0, 301, 31, 13};
constexpr Index sum_over_part[] = {0, 61, 15, 9};
constexpr Index choice_over_box[] = {0, 101, 21, 11};
constexpr Index choice_over_part[] = {0, 9, 5, 3};

// The same with a posterior, which more dimensions than lattices can bear may have: samples of it, and numbers over the
// box.
constexpr Index sum_of_posterior = 800;
constexpr Index choice_of_posterior = 200;
constexpr Index choice_of_box = 200;

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

/// So many samples of the posterior at equal distances in their list, in units of the box.
Matrix thinned(const Misfit& misfit, const Posterior& posterior, Index count) {
  const Index all = posterior.samples.rows();
  Matrix points(std::min(count, all), posterior.samples.cols());
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector values = posterior.samples.row(i * all / points.rows()).transpose();
    points.row(i) = to_box(misfit.ranges(), {values.data(), static_cast<std::size_t>(values.size())}).transpose();
  }
  return points;
}

Matrix posterior_choices(const Misfit& misfit, const Posterior& posterior) {
  const Matrix of_posterior = thinned(misfit, posterior, choice_of_posterior);
  Matrix points(of_posterior.rows() + choice_of_box, of_posterior.cols());
  points.topRows(of_posterior.rows()) = of_posterior;
  for (Index i = 0; i < choice_of_box; ++i) {
    for (Index j = 0; j < points.cols(); ++j) {
      points(of_posterior.rows() + i, j) =
          uniform(0, static_cast<std::uint64_t>(i), RandomStream::posterior, static_cast<std::uint32_t>(j));
    }
  }
  return points;
}

}  // namespace

SearchNodes nodes_of_sum(const Misfit& misfit, const Estimate& estimate) {
  if (estimate.posterior) {
    const Matrix points = thinned(misfit, *estimate.posterior, sum_of_posterior);
    return {points, Vector::Constant(points.rows(), 1.0 / static_cast<double>(points.rows()))};
  }
  return nodes_over(misfit, estimate, sum_over_box, sum_over_part);
}

Matrix candidates(const Misfit& misfit, const Estimate& estimate) {
  Matrix points = estimate.posterior ? posterior_choices(misfit, *estimate.posterior)
                                     : nodes_over(misfit, estimate, choice_over_box, choice_over_part).points;
  const Index fresh = points.rows();
  points.conservativeResize(fresh + misfit.runs().rows(), points.cols());
  points.bottomRows(misfit.runs().rows()) = misfit.runs();
  return points;
}

}  // namespace repose
