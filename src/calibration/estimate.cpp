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

constexpr double exact = 1e-10;           // a T at which all residuals are rounding
constexpr double no_information = 1e-12;  // of the greatest: what the slopes tell along a level direction

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

/// What the slopes of the surfaces tell of the parameters (in units of the box): the inverse of their covariance.
Matrix information_at(const Misfit& misfit, const Vector& point) {
  const Matrix slopes = misfit.slopes(point);
  return slopes.transpose() * misfit.look(point).covariance.ldlt().solve(slopes);
}

/// Covariance of the parameters (in units of the box) where the surfaces are as planes (C.16).
Matrix linearised_covariance(const Misfit& misfit, const Vector& point) {
  const Index d = misfit.parameters();
  const Eigen::LLT<Matrix> factor(information_at(misfit, point));
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

/// Of the parameters' directions those in which the surfaces are level at a point, as columns.
Matrix level_directions(const Misfit& misfit, const Vector& point) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(information_at(misfit, point));
  const double least = no_information * solver.eigenvalues().cwiseAbs().maxCoeff();
  const Index count = (solver.eigenvalues().array() <= least).count();
  return solver.eigenvectors().leftCols(count);
}

/// Whether the surfaces meet the laboratory at a point and not along a line or a plane.
bool is_one_point(const CalibratedPoint& point) { return std::isfinite(point.covariance(0, 0)); }

/// At the points where no standard error is finite: which parameters the observables do not tell there.
std::string untold_text(const Misfit& misfit, const Estimate& e) {
  constexpr double share = 1e-6;  // of a direction
  std::vector<Matrix> level;
  for (const CalibratedPoint& point : e.points) {
    if (!is_one_point(point)) level.push_back(level_directions(misfit, to_box(misfit.ranges(), point.values)));
  }
  std::string names;
  for (std::size_t j = 0; j < misfit.ranges().size(); ++j) {
    const auto is_untold = [&](const Matrix& ways) { return ways.row(static_cast<Index>(j)).squaredNorm() > share; };
    if (std::none_of(level.begin(), level.end(), is_untold)) continue;
    names += (names.empty() ? "" : ", ") + misfit.ranges()[j].name;
  }
  return names.empty() ? "" : "; one point of many that fit: these observables do not tell " + names;
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

/// The part of the region that a point is in, which is added to the others if it is none of them.
std::size_t part_of(const Residuals& residuals, const LatticeResiduals& over_box, const Vector& point, double limit,
                    std::vector<ConfidencePart>& parts) {
  const auto place = [&](auto is_it) {
    return static_cast<std::size_t>(std::find_if(parts.begin(), parts.end(), is_it) - parts.begin());
  };
  std::size_t index = place([&](const ConfidencePart& part) { return part.contains(point); });
  if (index < parts.size()) return index;
  index = place([&](const ConfidencePart& part) { return leads_to(residuals, part, point, limit); });
  if (index < parts.size()) return index;
  const ConfidencePart fresh = confidence_part(residuals, over_box, point, limit);
  index = place([&](const ConfidencePart& part) { return have_same_extent(part, fresh); });
  if (index == parts.size()) parts.push_back(fresh);
  return index;
}

}  // namespace

Estimate estimate(const Misfit& misfit, double confidence) {
  if (takes_posterior(misfit.ranges())) return posterior_estimate(misfit, confidence);
  check(misfit, confidence);
  const bool square = misfit.observables() == misfit.parameters();
  const Residuals residuals = [&](const Vector& point) { return misfit.residuals(point); };
  const LatticeResiduals over_box = evaluate_over_box(residuals, misfit.parameters());
  const std::vector<LeastSquares> minima = local_minima(residuals, over_box);

  Estimate e;
  e.confidence = confidence;
  e.limit = chi_squared_quantile(confidence, static_cast<double>(misfit.observables()));
  std::vector<ConfidencePart> parts;
  for (const LeastSquares& low : minima) {
    if (low.squares > e.limit) break;
    const std::size_t known = parts.size();
    const std::size_t index = part_of(residuals, over_box, low.point, e.limit, parts);
    if (index == known) {
      e.half_width = std::max(e.half_width.value_or(0.0), half_width(misfit, parts[index], low.point, e.limit));
    }
    // A lower point of the same part makes an inexact one no more than a dent.
    const bool first = std::none_of(e.points.begin(), e.points.end(), [&](const auto& p) { return p.part == index; });
    if (low.squares > exact && (square || !first)) continue;
    CalibratedPoint point = calibrated_point(misfit, low, index);
    if (first || is_one_point(point)) e.points.push_back(std::move(point));
  }
  for (const ConfidencePart& part : parts) e.parts.push_back(in_units(misfit.ranges(), part));

  e.nearest = nearest_point(misfit, minima.front(), e.limit);
  e.verdict = verdict_of(e, square) + untold_text(misfit, e);
  return e;
}

Estimate estimate(const std::vector<ParameterRange>& ranges, std::span<const std::vector<double>> runs,
                  std::span<const ObservableData> observables, double confidence) {
  return estimate(Misfit(ranges, runs, observables), confidence);
}

}  // namespace repose
