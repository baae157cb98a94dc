#include "calibration/posterior.h"

#include <algorithm>
#include <cmath>

namespace repose {
namespace {

constexpr double as_wide = 0.9;        // of the prior's deviation: the observables have not told of the parameter
constexpr double least_overlap = 0.7;  // with the prior; with less they have told, however wide it is
constexpr int bins = 20;               // of the range, or of the prior
constexpr double cut_off = 0.1;  // of the greatest bin: what the range has cut off a density that is more at its end

double log_prior_of(const std::vector<ParameterRange>& ranges, const Vector& point) {
  const std::vector<double> values = from_box(ranges, point);
  double sum = 0.0;
  for (std::size_t j = 0; j < ranges.size(); ++j) sum += log_prior(ranges[j], values[j]);
  return sum;
}

Samples samples_of(const Misfit& misfit, const SamplePlan& plan) {
  const std::vector<ParameterRange>& ranges = misfit.ranges();
  BoxDensity density;
  density.draw = [&](const Vector& shares) {
    std::vector<double> values;
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      values.push_back(prior_quantile(ranges[j], shares[static_cast<Index>(j)]));
    }
    return to_box(ranges, values);
  };
  density.log_prior = [&](const Vector& point) { return log_prior_of(ranges, point); };
  density.log_likelihood = [&](const Vector& point) { return misfit.log_likelihood(point); };
  return sample_density(density, misfit.parameters(), plan);
}

/// The value of sorted ones with this share below it.
double quantile_of(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::vector<double> sorted(const Eigen::Ref<const Vector>& values) {
  std::vector<double> result(values.begin(), values.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t bin_of(const ParameterRange& range, double value) {
  const double place = bins * (value - range.lower) / (range.upper - range.lower);
  return static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, bins - 1));
}

std::vector<int> histogram(const ParameterRange& range, const std::vector<double>& values) {
  std::vector<int> counts(bins, 0);
  for (const double value : values) ++counts[bin_of(range, value)];
  return counts;
}

/// How much samples and prior have in common: the area below both densities, by bins that have equal shares of the
/// prior.
double overlap_with_prior(const ParameterRange& range, const std::vector<double>& sorted) {
  double common = 0.0;
  auto from = sorted.begin();
  for (int k = 1; k <= bins; ++k) {
    const double end = prior_quantile(range, static_cast<double>(k) / bins);
    const auto to = k == bins ? sorted.end() : std::lower_bound(from, sorted.end(), end);
    common += std::min(1.0 / bins, static_cast<double>(to - from) / static_cast<double>(sorted.size()));
    from = to;
  }
  return common;
}

/// Whether the density goes on at the lower and at the upper end of the range.
void mark_open_ends(ConfidenceInterval& interval, const std::vector<int>& counts) {
  const double least = cut_off * *std::max_element(counts.begin(), counts.end());
  interval.open_below = counts.front() > least;
  interval.open_above = counts.back() > least;
}

Marginal marginal_of(const ParameterRange& range, const Eigen::Ref<const Vector>& samples, double confidence) {
  const std::vector<double> values = sorted(samples);
  Marginal m;
  m.mean = samples.mean();
  m.deviation = std::sqrt((samples.array() - m.mean).square().mean());
  m.median = quantile_of(values, 0.5);
  m.interval.lower = quantile_of(values, 0.5 * (1.0 - confidence));
  m.interval.upper = quantile_of(values, 0.5 * (1.0 + confidence));
  const std::vector<int> counts = histogram(range, values);
  mark_open_ends(m.interval, counts);
  const auto first = counts.begin() + static_cast<std::ptrdiff_t>(bin_of(range, m.interval.lower));
  const auto last = counts.begin() + static_cast<std::ptrdiff_t>(bin_of(range, m.interval.upper));
  m.separate = std::find(first, last, 0) != last;
  m.prior_deviation = prior_deviation(range);
  m.off_prior = off_prior(range, m.mean);
  m.determined = m.deviation < as_wide * m.prior_deviation || overlap_with_prior(range, values) < least_overlap;
  return m;
}

}  // namespace

double log_posterior(const Misfit& misfit, const Vector& point) {
  return log_prior_of(misfit.ranges(), point) + misfit.log_likelihood(point);
}

Posterior posterior_of(const Misfit& misfit, double confidence, const SamplePlan& plan) {
  const Samples drawn = samples_of(misfit, plan);
  const std::vector<ParameterRange>& ranges = misfit.ranges();
  Posterior p;
  p.samples = drawn.points;
  for (Index j = 0; j < drawn.points.cols(); ++j) {
    const ParameterRange& range = ranges[static_cast<std::size_t>(j)];
    p.samples.col(j) = range.lower + (range.upper - range.lower) * drawn.points.col(j).array();
    p.marginals.push_back(marginal_of(range, p.samples.col(j), confidence));
  }
  p.log_density = drawn.log_density;
  p.confidence = confidence;
  p.limit = quantile_of(sorted(drawn.log_density), 1.0 - confidence);
  const Matrix about = p.samples.rowwise() - p.samples.colwise().mean();
  p.covariance = about.transpose() * about / static_cast<double>(about.rows());
  const Vector deviations = p.covariance.diagonal().cwiseSqrt();
  p.correlations = p.covariance.cwiseQuotient(deviations * deviations.transpose());
  p.stages = drawn.stages;
  p.acceptance = drawn.acceptance;
  return p;
}

}  // namespace repose
