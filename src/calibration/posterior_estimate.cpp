#include "calibration/posterior_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "base/distributions.h"
#include "base/error.h"
#include "calibration/local_minima.h"
#include "calibration/nearest_point.h"

namespace repose {
namespace {

constexpr std::size_t starts = 10;        // of the descents to the best point
constexpr std::size_t other_starts = 20;  // of those to the nearest one
constexpr double apart = 0.1;             // of the box: these, in a parameter at least
constexpr Index most_on_lattice = 3;      // parameters of which a lattice over the box can be looked at
constexpr double gain = 0.01;             // of T: less does not make another point a better one

void check(const Misfit& misfit, double confidence) {
  const auto parameters = static_cast<std::size_t>(misfit.parameters());
  if (parameters < 1 || parameters > most_parameters) {
    throw DeckError(fmt::format("{} parameters: an estimate takes 1 to {}", parameters, most_parameters));
  }
  check_confidence(confidence);
}

/// The residuals of the observables, and each prior that is not uniform as one more.
Vector residuals_with_priors(const Misfit& misfit, const Vector& point) {
  const Vector z = misfit.residuals(point);
  const std::vector<double> values = from_box(misfit.ranges(), point);
  Vector all(z.size() + point.size());
  all.head(z.size()) = z;
  for (Index j = 0; j < point.size(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    all[z.size() + j] = off_prior(misfit.ranges()[k], values[k]);
  }
  return all;
}

/// A point of the parameters' units in the box.
Vector in_box(const Misfit& misfit, const Vector& values) {
  const Vector point = to_box(misfit.ranges(), {values.data(), static_cast<std::size_t>(values.size())});
  return point.cwiseMax(0.0).cwiseMin(1.0);
}

/// The least of those below the samples of the highest density.
LeastSquares most_likely(const Residuals& residuals, const Misfit& misfit, const Posterior& posterior) {
  std::vector<Index> order(static_cast<std::size_t>(posterior.samples.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return posterior.log_density[a] > posterior.log_density[b]; });
  LeastSquares best;
  for (std::size_t k = 0; k < std::min(starts, order.size()); ++k) {
    const LeastSquares found = descend(residuals, in_box(misfit, posterior.samples.row(order[k]).transpose()));
    if (k == 0 || found.squares < best.squares) best = found;
  }
  return best;
}

/// Samples and runs of least T that are apart from one another: a prior may have drawn all samples away from where the
/// laboratory is met.
std::vector<Vector> spread_starts(const Residuals& residuals, const Misfit& misfit, const Posterior& posterior) {
  std::vector<LeastSquares> all;
  const auto add = [&](const Vector& point) { all.push_back({point, residuals(point).squaredNorm()}); };
  for (Index i = 0; i < posterior.samples.rows(); ++i) add(in_box(misfit, posterior.samples.row(i).transpose()));
  for (Index i = 0; i < misfit.runs().rows(); ++i) add(misfit.runs().row(i).transpose().cwiseMax(0.0).cwiseMin(1.0));
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.squares < b.squares; });
  std::vector<Vector> chosen;
  for (const LeastSquares& one : all) {
    const auto is_near = [&](const Vector& other) { return (one.point - other).cwiseAbs().maxCoeff() < apart; };
    if (std::none_of(chosen.begin(), chosen.end(), is_near)) chosen.push_back(one.point);
    if (chosen.size() == other_starts) break;
  }
  return chosen;
}

/// The least T in the box as far as descents from many places find it; `known` unless there is a clearly lower one.
LeastSquares least_of_box(const Residuals& residuals, const Misfit& misfit, const Posterior& posterior,
                          const LeastSquares& known) {
  LeastSquares least = known;
  const auto take = [&](const LeastSquares& found) {
    if (found.squares < least.squares - gain) least = found;
  };
  if (known.squares < gain) return known;
  if (misfit.parameters() <= most_on_lattice) {
    take(local_minima(residuals, evaluate_over_box(residuals, misfit.parameters())).front());
  }
  for (const Vector& start : spread_starts(residuals, misfit, posterior)) take(descend(residuals, start));
  return least;
}

CalibratedPoint calibrated_point(const Misfit& misfit, const Posterior& posterior, const Vector& at) {
  CalibratedPoint point = {.values = from_box(misfit.ranges(), at),
                           .misfit = misfit(at),
                           .standard_errors = {},
                           .covariance = posterior.covariance,
                           .part = 0};
  for (const Marginal& m : posterior.marginals) point.standard_errors.push_back(m.deviation);
  return point;
}

std::string verdict_of(const Misfit& misfit, const Estimate& e) {
  if (!e.nearest.acceptable) {
    return fmt::format(
        "no parameters within the ranges meet the laboratory: the nearest point has T = {:.3g} (limit "
        "{:.3g})",
        e.nearest.misfit, e.limit);
  }
  std::vector<std::string> open;
  for (std::size_t j = 0; j < misfit.ranges().size(); ++j) {
    if (!e.posterior->marginals[j].determined) open.push_back(misfit.ranges()[j].name);
  }
  std::string what =
      fmt::format("posterior of {} parameter{} from {} observable{}", misfit.parameters(),
                  misfit.parameters() == 1 ? "" : "s", misfit.observables(), misfit.observables() == 1 ? "" : "s");
  if (!open.empty()) what += fmt::format(", which do not determine {}", fmt::join(open, ", "));
  const double best = e.points.front().misfit;
  if (best <= e.limit) return what;
  return what + fmt::format("; the priors draw the best point off the laboratory, to T = {:.3g} (limit {:.3g})", best,
                            e.limit);
}

}  // namespace

bool takes_posterior(std::span<const ParameterRange> ranges) {
  return ranges.size() > 3 || std::any_of(ranges.begin(), ranges.end(), [](const ParameterRange& range) {
           return range.prior.kind != PriorKind::uniform;
         });
}

Estimate posterior_estimate(const Misfit& misfit, double confidence) {
  check(misfit, confidence);
  Estimate e;
  e.confidence = confidence;
  e.limit = chi_squared_quantile(confidence, static_cast<double>(misfit.observables()));
  e.posterior = posterior_of(misfit, confidence);
  const Residuals of_observables = [&](const Vector& point) { return misfit.residuals(point); };
  const Residuals of_all = [&](const Vector& point) { return residuals_with_priors(misfit, point); };
  LeastSquares best = most_likely(of_all, misfit, *e.posterior);
  const LeastSquares nearest = least_of_box(of_observables, misfit, *e.posterior, descend(of_observables, best.point));
  const LeastSquares other = descend(of_all, nearest.point);
  if (other.squares < best.squares - gain) best = other;
  e.nearest = nearest_point(misfit, nearest, e.limit);
  if (e.nearest.acceptable) {
    e.points.push_back(calibrated_point(misfit, *e.posterior, best.point));
    RegionPart& part = e.parts.emplace_back();
    double widest = 0.0;
    for (std::size_t j = 0; j < misfit.ranges().size(); ++j) {
      const ConfidenceInterval& interval = e.posterior->marginals[j].interval;
      part.intervals.push_back(interval);
      const ParameterRange& range = misfit.ranges()[j];
      widest = std::max(widest, 0.5 * (interval.upper - interval.lower) / (range.upper - range.lower));
    }
    e.half_width = widest;
  }
  e.verdict = verdict_of(misfit, e);
  return e;
}

}  // namespace repose
