#include "calibration/acquisition.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
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

struct Nodes {
  Matrix points;  ///< one per row
  Vector volume;  ///< of the box, for each
};

void append(Nodes& nodes, const BoxLattice& lattice) {
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

/// The shares of the runs nearest to a point that have a value of the observable.
double chance_of_value(const Misfit& misfit, const ResponseSurface& surface, const Vector& point) {
  const Vector distance = (misfit.runs().rowwise() - point.transpose()).rowwise().norm();
  const double least = distance.minCoeff();
  double runs = 0.0;
  double with_value = 0.0;
  for (Index run = 0; run < distance.size(); ++run) {
    if (distance[run] > least + 1e-9) continue;
    runs += 1.0;
    if (surface.process().data().point_of_run[static_cast<std::size_t>(run)] >= 0) with_value += 1.0;
  }
  return with_value / runs;
}

/// One surface over the nodes of the sum and over the candidates, as it will be after the points chosen so far.
struct Outlook {
  Matrix across;    ///< covariance of the surface at the nodes (down) with that at the candidates (across)
  Matrix between;   ///< of the candidates
  Vector variance;  ///< at the nodes
  Vector chance;    ///< of a value, at the candidates
  double laboratory;
  double noise;  ///< variance of the mean of a point's runs

  /// What runs at a candidate take from the weighted doubt (C.18).
  double gain(Index candidate, const Vector& weight) const {
    const Vector change = across.col(candidate).cwiseAbs2() / (between(candidate, candidate) + noise + 1e-300);
    const Vector total = variance.array() + laboratory + 1e-18;
    return chance[candidate] * weight.dot(change.cwiseQuotient(total));
  }
  void choose(Index candidate) {
    if (chance[candidate] < 0.5) return;
    const double total = between(candidate, candidate) + noise + 1e-300;
    const Vector down = across.col(candidate);
    const Vector there = between.col(candidate);
    variance -= down.cwiseAbs2() / total;  // (C.17)
    variance = variance.cwiseMax(0.0);
    across -= down * there.transpose() / total;
    between -= there * there.transpose() / total;
  }
};

Outlook outlook(const Misfit& misfit, std::size_t k, const Matrix& nodes, const Matrix& candidates, double seeds) {
  const ResponseSurface& surface = misfit.surfaces()[k];
  const GaussianProcess& process = surface.process();
  Outlook o = {.across = process.covariance(nodes, candidates),
               .between = process.covariance(candidates, candidates),
               .variance = Vector(nodes.rows()),
               .chance = Vector(candidates.rows()),
               .laboratory = misfit.laboratory_variance(k),
               .noise = process.noise_variance() / seeds};
  for (Index i = 0; i < nodes.rows(); ++i) {
    const double deviation = process.at(nodes.row(i).transpose()).deviation;
    o.variance[i] = deviation * deviation;
  }
  for (Index i = 0; i < candidates.rows(); ++i) {
    o.chance[i] = chance_of_value(misfit, surface, candidates.row(i).transpose());
  }
  return o;
}

}  // namespace

std::vector<std::vector<double>> next_points(const Misfit& misfit, const Estimate& estimate, std::size_t points,
                                             std::size_t seeds_per_point) {
  if (points == 0 || seeds_per_point == 0) throw DeckError("a batch needs a point and a seed or more");
  const Index d = misfit.parameters();
  Nodes nodes;
  Nodes candidates;
  append(nodes, unit_lattice(d, sum_over_box[d]));
  append(candidates, unit_lattice(d, choice_over_box[d]));
  for (BoxLattice window : windows(misfit, estimate)) {
    window.side = sum_over_part[d];
    append(nodes, window);
    window.side = choice_over_part[d];
    append(candidates, window);
  }
  const Index fresh = candidates.points.rows();
  candidates.points.conservativeResize(fresh + misfit.runs().rows(), d);
  candidates.points.bottomRows(misfit.runs().rows()) = misfit.runs();

  // Relative to the least misfit: where nothing fits, near what fits best.
  Vector weight = nodes.volume;
  for (Index i = 0; i < weight.size(); ++i) {
    weight[i] *= std::exp(0.5 * (estimate.nearest.misfit - misfit(nodes.points.row(i).transpose())));
  }
  std::vector<Outlook> outlooks;
  for (std::size_t k = 0; k < misfit.surfaces().size(); ++k) {
    outlooks.push_back(outlook(misfit, k, nodes.points, candidates.points, static_cast<double>(seeds_per_point)));
  }
  std::vector<std::vector<double>> chosen;
  while (chosen.size() < points) {
    Vector gain = Vector::Zero(candidates.points.rows());
    for (Index i = 0; i < gain.size(); ++i) {
      for (const Outlook& o : outlooks) gain[i] += o.gain(i, weight);
    }
    Index best = 0;
    gain.maxCoeff(&best);
    for (Outlook& o : outlooks) o.choose(best);
    chosen.push_back(from_box(misfit.ranges(), candidates.points.row(best).transpose()));
  }
  return chosen;
}

}  // namespace repose
