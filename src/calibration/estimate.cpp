#include "calibration/estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/distributions.h"
#include "base/error.h"
#include "calibration/confidence_part.h"
#include "calibration/nearest_point.h"
#include "calibration/posterior_estimate.h"

namespace repose {
namespace {

constexpr Index lattice_side[] = {0, 401, 61, 21};  // for each number of parameters
constexpr double exact = 1e-10;                     // a T at which all residuals are rounding

void check(const Misfit& misfit, double confidence) {
  if (misfit.parameters() < 1 || misfit.parameters() > 3) {
    throw DeckError(fmt::format("{} parameters: an estimate takes 1 to 3", misfit.parameters()));
  }
  if (misfit.observables() < misfit.parameters()) {
    throw DeckError(
        fmt::format("{} observables for {} parameters: there must be as many or more, since each leaves a "
                    "line of parameters that fit it",
                    misfit.observables(), misfit.parameters()));
  }
  check_confidence(confidence);
}

/// Covariance of the parameters (in units of the box) where the surfaces are as planes (C.16).
Matrix linearised_covariance(const Misfit& misfit, const Vector& point) {
  const Matrix slopes = misfit.slopes(point);
  const Matrix information = slopes.transpose() * misfit.look(point).covariance.ldlt().solve(slopes);
  const Index d = misfit.parameters();
  const Eigen::LLT<Matrix> factor(information);
  const double infinity = std::numeric_limits<double>::infinity();
  if (factor.info() != Eigen::Success || factor.rcond() < 1e-14) return Matrix::Constant(d, d, infinity);
  return factor.solve(Matrix::Identity(d, d));
}

CalibratedPoint calibrated_point(const Misfit& misfit, const LeastSquares& at, std::size_t part) {
  const std::vector<ParameterRange>& ranges = misfit.ranges();
  CalibratedPoint result = {.values = from_box(ranges, at.point),
                            .misfit = at.squares,
                            .standard_errors = {},
                            .covariance = linearised_covariance(misfit, at.point),
                            .part = part};
  for (Index i = 0; i < misfit.parameters(); ++i) {
    const ParameterRange& r = ranges[static_cast<std::size_t>(i)];
    result.covariance.row(i) *= r.upper - r.lower;
    result.covariance.col(i) *= r.upper - r.lower;
    result.standard_errors.push_back(std::sqrt(result.covariance(i, i)));
  }
  return result;
}

RegionPart in_units(const std::vector<ParameterRange>& ranges, const ConfidencePart& part) {
  const std::vector<double> lower = from_box(ranges, part.lower);
  const std::vector<double> upper = from_box(ranges, part.upper);
  RegionPart result;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    result.intervals.push_back({lower[i], upper[i], part.open_below[i], part.open_above[i]});
  }
  return result;
}

std::string verdict_of(const Estimate& e, bool square) {
  const char* what = square ? "crossing of the laboratory's contour lines" : "best fit to the laboratory's values";
  if (e.points.size() == 1) {
    return e.parts.size() == 1
               ? fmt::format("one {}", what)
               : fmt::format("one {}, but the confidence region has {} separate parts", what, e.parts.size());
  }
  if (!e.points.empty()) {
    return fmt::format(
        "{} points are each a {}, in {} connected part{} of the confidence region: these observables do "
        "not tell which is right",
        e.points.size(), what, e.parts.size(), e.parts.size() == 1 ? "" : "s");
  }
  return fmt::format("no {} within the ranges; the nearest point has T = {:.3g} and is {} (limit {:.3g})", what,
                     e.nearest.misfit, e.nearest.acceptable ? "within the errors" : "not acceptable", e.limit);
}

/// The greatest half-width of a part, in units of the box. Where the edge of the box cuts a part off, most when its
/// surfaces meet the laboratory beyond, what is left is narrow though nothing is known better: the half-width counts as
/// that of planes through the part's best point at least.
double half_width(const Misfit& misfit, const ConfidencePart& part, const Vector& best, double limit) {
  const Vector of_planes = (limit * linearised_covariance(misfit, best).diagonal()).cwiseSqrt().cwiseMin(0.5);
  return of_planes.cwiseMax(0.5 * (part.upper - part.lower)).maxCoeff();
}

}  // namespace

Estimate estimate(const Misfit& misfit, double confidence) {
  if (takes_posterior(misfit.ranges())) return posterior_estimate(misfit, confidence);
  check(misfit, confidence);
  const bool square = misfit.observables() == misfit.parameters();
  const Residuals residuals = [&](const Vector& point) { return misfit.residuals(point); };
  const LatticeResiduals over_box =
      evaluate(residuals, unit_lattice(misfit.parameters(), lattice_side[misfit.parameters()]));
  const std::vector<LeastSquares> minima = local_minima(residuals, over_box);

  Estimate e;
  e.confidence = confidence;
  e.limit = chi_squared_quantile(confidence, static_cast<double>(misfit.observables()));
  std::vector<ConfidencePart> parts;
  for (const LeastSquares& low : minima) {
    if (low.squares > e.limit) break;
    const auto holds = [&](const ConfidencePart& part) { return part.contains(low.point); };
    auto part = std::find_if(parts.begin(), parts.end(), holds);
    if (part == parts.end()) {
      parts.push_back(confidence_part(residuals, over_box, low.point, e.limit));
      part = parts.end() - 1;
      e.half_width = std::max(e.half_width.value_or(0.0), half_width(misfit, *part, low.point, e.limit));
    }
    // A lower point of the same part makes an inexact one no more than a dent.
    const auto index = static_cast<std::size_t>(part - parts.begin());
    const bool first = std::none_of(e.points.begin(), e.points.end(), [&](const auto& p) { return p.part == index; });
    if (low.squares <= exact || (!square && first)) e.points.push_back(calibrated_point(misfit, low, index));
  }
  for (const ConfidencePart& part : parts) e.parts.push_back(in_units(misfit.ranges(), part));

  e.nearest = nearest_point(misfit, minima.front(), e.limit);
  e.verdict = verdict_of(e, square);
  return e;
}

Estimate estimate(const std::vector<ParameterRange>& ranges, std::span<const std::vector<double>> runs,
                  std::span<const ObservableData> observables, double confidence) {
  return estimate(Misfit(ranges, runs, observables), confidence);
}

}  // namespace repose
