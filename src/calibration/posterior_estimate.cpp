#include "calibration/posterior_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "base/distributions.h"
#include "base/error.h"
#include "calibration/nearest_point.h"

namespace repose {
namespace {

constexpr std::size_t starts = 10;  // of the descents to the best point

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

/// The least of those below the samples of the highest density.
LeastSquares least(const Residuals& residuals, const Misfit& misfit, const Posterior& posterior) {
  std::vector<Index> order(static_cast<std::size_t>(posterior.samples.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return posterior.log_density[a] > posterior.log_density[b]; });
  LeastSquares best;
  for (std::size_t k = 0; k < std::min(starts, order.size()); ++k) {
    const Vector values = posterior.samples.row(order[k]).transpose();
    const Vector start = to_box(misfit.ranges(), {values.data(), static_cast<std::size_t>(values.size())});
    const LeastSquares found = descend(residuals, start.cwiseMax(0.0).cwiseMin(1.0));
    if (k == 0 || found.squares < best.squares) best = found;
  }
  return best;
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
  const std::string what =
      fmt::format("posterior of {} parameter{} from {} observable{}", misfit.parameters(),
                  misfit.parameters() == 1 ? "" : "s", misfit.observables(), misfit.observables() == 1 ? "" : "s");
  if (open.empty()) return what;
  return fmt::format("{}, which do not determine {}", what, fmt::join(open, ", "));
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
  const LeastSquares best = least(of_all, misfit, *e.posterior);
  e.nearest = nearest_point(misfit, descend(of_observables, best.point), e.limit);
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
