#include "calibration/acquisition.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "calibration/search_nodes.h"

namespace repose {
namespace {

/// What could be run: a row of points, and its level.
struct Choices {
  Matrix points;
  std::vector<std::size_t> level;
  Vector cost;

  Index size() const { return points.rows(); }
};

/// Every candidate at every level, level after level.
Choices choices_of(const Misfit& misfit, const Estimate& estimate, const BatchPlan& batch) {
  const Matrix points = candidates(misfit, estimate);
  const Index n = points.rows();
  Choices c;
  c.points = points.replicate(static_cast<Index>(misfit.levels()), 1);
  c.cost.resize(c.points.rows());
  for (Index i = 0; i < c.points.rows(); ++i) {
    const auto level = static_cast<std::size_t>(i / n);
    c.level.push_back(level);
    const LevelPoint point = {level, from_box(misfit.ranges(), c.points.row(i).transpose())};
    c.cost[i] = batch.cost(point);
  }
  return c;
}

/// The share of the runs of a level, of those asked for observable `k`, nearest to a point that have a value of it.
double chance_of_value(const Misfit& misfit, Index k, std::size_t level, const Vector& point) {
  const ObservableSurface& surface = misfit.surface(k);
  const auto is_asked = [&](Index run) { return misfit.level_of(run) == level && misfit.is_asked(run, k); };
  const Vector distance = (misfit.runs().rowwise() - point.transpose()).rowwise().norm();
  double least = std::numeric_limits<double>::infinity();
  for (Index run = 0; run < distance.size(); ++run) {
    if (is_asked(run)) least = std::min(least, distance[run]);
  }
  double runs = 0.0;
  double with_value = 0.0;
  for (Index run = 0; run < distance.size(); ++run) {
    if (!is_asked(run) || distance[run] > least + 1e-9) continue;
    runs += 1.0;
    if (surface.data(level).point_of_run[static_cast<std::size_t>(run)] >= 0) with_value += 1.0;
  }
  return with_value / runs;
}

/// One surface over the nodes of the sum and over the choices, as it will be after those chosen so far.
struct Outlook {
  Matrix across;    ///< covariance of the surface at the nodes (down) with its levels at the choices (across)
  Matrix between;   ///< of the choices
  Vector variance;  ///< at the nodes
  Vector chance;    ///< of a value, at the choices
  Vector noise;     ///< variance of the mean of a choice's runs
  Vector least;     ///< variance at the nodes that no run narrows

  /// What runs at a choice take from the weighted doubt (C.18).
  double gain(Index choice, const Vector& weight) const {
    const Vector change = across.col(choice).cwiseAbs2() / (between(choice, choice) + noise[choice] + 1e-300);
    const Vector total = (variance + least).array() + 1e-18;
    return chance[choice] * weight.dot(change.cwiseQuotient(total));
  }
  void choose(Index choice) {
    if (!(chance[choice] > 0.0)) return;
    const double total = between(choice, choice) + noise[choice] / chance[choice] + 1e-300;
    const Vector down = across.col(choice);
    const Vector there = between.col(choice);
    variance -= down.cwiseAbs2() / total;  // (C.17)
    variance = variance.cwiseMax(0.0);
    across -= down * there.transpose() / total;
    between -= there * there.transpose() / total;
  }
};

Outlook outlook(const Misfit& misfit, Index k, const Matrix& nodes, const Choices& choices,
                const std::vector<std::size_t>& seeds) {
  const ObservableSurface& surface = misfit.surface(k);
  const Index each = choices.size() / static_cast<Index>(misfit.levels());
  const Matrix points = choices.points.topRows(each);
  Outlook o = {.across = Matrix(nodes.rows(), choices.size()),
               .between = Matrix(choices.size(), choices.size()),
               .variance = Vector(nodes.rows()),
               .chance = Vector(choices.size()),
               .noise = Vector(choices.size()),
               .least = Vector(nodes.rows())};
  for (std::size_t a = 0; a < misfit.levels(); ++a) {
    const Index first = static_cast<Index>(a) * each;
    o.across.middleCols(first, each) = surface.covariance(misfit.levels() - 1, nodes, a, points);
    for (std::size_t b = 0; b < misfit.levels(); ++b) {
      o.between.block(first, static_cast<Index>(b) * each, each, each) = surface.covariance(a, points, b, points);
    }
  }
  for (Index i = 0; i < nodes.rows(); ++i) {
    const Vector point = nodes.row(i).transpose();
    const double deviation = surface.at(point).deviation;
    o.variance[i] = deviation * deviation;
    o.least[i] = misfit.least_variance(k, point);
  }
  for (Index i = 0; i < choices.size(); ++i) {
    const std::size_t level = choices.level[static_cast<std::size_t>(i)];
    const Vector point = choices.points.row(i).transpose();
    o.chance[i] = chance_of_value(misfit, k, level, point);
    o.noise[i] = surface.noise_variance(level, point) /
                 static_cast<double>(seeds[misfit.experiment(k) * misfit.levels() + level]);
  }
  return o;
}

/// The choice with the greatest gain per cost of those that the budget takes; -1: none.
Index best_choice(const std::vector<Outlook>& outlooks, const Vector& weight, const Vector& cost, double budget) {
  Index best = -1;
  double most = -1.0;
  for (Index i = 0; i < cost.size(); ++i) {
    if (cost[i] > budget) continue;
    double gain = 0.0;
    for (const Outlook& o : outlooks) gain += o.gain(i, weight);
    if (gain / cost[i] <= most) continue;
    most = gain / cost[i];
    best = i;
  }
  return best;
}

}  // namespace

std::vector<LevelPoint> next_level_points(const Misfit& misfit, const Estimate& estimate, const BatchPlan& batch) {
  const SearchNodes nodes = nodes_of_sum(misfit, estimate);
  const Choices choices = choices_of(misfit, estimate, batch);
  Vector weight = nodes.volume;
  // Samples stand where the parameters may be. Else relative to the least misfit: where nothing fits, near what fits
  // best.
  for (Index i = 0; i < weight.size() && !estimate.posterior; ++i) {
    weight[i] *= std::exp(0.5 * (estimate.nearest.misfit - misfit(nodes.points.row(i).transpose())));
  }
  std::vector<Outlook> outlooks;
  for (Index k = 0; k < misfit.observables(); ++k) {
    outlooks.push_back(outlook(misfit, k, nodes.points, choices, batch.seeds));
  }
  std::vector<LevelPoint> chosen;
  double left = batch.budget;
  while (chosen.size() < batch.points) {
    const Index best = best_choice(outlooks, weight, choices.cost, left);
    if (best < 0) break;
    for (Outlook& o : outlooks) o.choose(best);
    left -= choices.cost[best];
    chosen.push_back({choices.level[static_cast<std::size_t>(best)],
                      from_box(misfit.ranges(), choices.points.row(best).transpose())});
  }
  return chosen;
}

std::vector<std::vector<double>> next_points(const Misfit& misfit, const Estimate& estimate, std::size_t points,
                                             std::size_t seeds_per_point) {
  if (points == 0 || seeds_per_point == 0) throw DeckError("a batch needs a point and a seed or more");
  BatchPlan batch;
  batch.points = points;
  batch.seeds = {seeds_per_point};
  batch.cost = [](const LevelPoint&) { return 1.0; };
  std::vector<std::vector<double>> result;
  for (LevelPoint& point : next_level_points(misfit, estimate, batch)) result.push_back(std::move(point.values));
  return result;
}

}  // namespace repose
