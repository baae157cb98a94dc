// Priors, and posteriors that are known in closed form.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/distributions.h"
#include "base/error.h"
#include "calibration/estimate.h"
#include "calibration/normal_equivalent.h"
#include "calibration/posterior_estimate.h"
#include "calibration/start_design.h"

namespace repose {
namespace {

TEST(Prior, NormalWithinItsRange) {
  const ParameterRange wide = {"e", 0.0, 1.0, {PriorKind::normal, 0.5, 0.05}};
  EXPECT_NEAR(prior_quantile(wide, 0.975), 0.5 + 1.959964 * 0.05, 1e-6);
  EXPECT_NEAR(prior_in_range(wide), 1.0, 1e-12);
  EXPECT_NEAR(prior_deviation(wide), 0.05, 1e-4);
  EXPECT_NEAR(log_prior(wide, 0.6) - log_prior(wide, 0.5), -2.0, 1e-12);
  EXPECT_NEAR(off_prior(wide, 0.4), -2.0, 1e-12);
  // Cut at one deviation to either side: s^2 (1 - 2 phi(1) / (2 Phi(1) - 1)).
  const ParameterRange cut = {"e", 0.4, 0.6, {PriorKind::normal, 0.5, 0.1}};
  const double share = 0.6826895;
  EXPECT_NEAR(prior_in_range(cut), share, 1e-6);
  EXPECT_NEAR(prior_deviation(cut), 0.1 * std::sqrt(1.0 - 2.0 * 0.2419707 / share), 1e-5);
  EXPECT_NEAR(prior_quantile(cut, 0.0), 0.4, 1e-12);
  EXPECT_NEAR(prior_quantile(cut, 1.0), 0.6, 1e-12);
  // Half of it is a half-normal distribution: median 0.6745 deviations.
  EXPECT_NEAR(prior_quantile({"e", 0.5, 5.0, {PriorKind::normal, 0.5, 0.1}}, 0.5), 0.5 + 0.06744898, 1e-7);
}

// Of mean 2 and deviation 1: ln has the variance ln(1 + 1/4) and the mean ln 2 - half of it.
TEST(Prior, LognormalByItsMeanAndDeviation) {
  const ParameterRange range = {"k", 1e-3, 1e3, {PriorKind::lognormal, 2.0, 1.0}};
  const double variance = std::log(1.25);
  const double middle = std::log(2.0) - 0.5 * variance;
  EXPECT_NEAR(prior_quantile(range, 0.5), std::exp(middle), 1e-9);
  EXPECT_NEAR(prior_quantile(range, 0.9), std::exp(middle + 1.2815516 * std::sqrt(variance)), 1e-6);
  EXPECT_NEAR(prior_deviation(range), 1.0, 5e-4);
  EXPECT_NEAR(off_prior(range, std::exp(middle - std::sqrt(variance))), -1.0, 1e-12);
  // Greatest at exp(mean - variance) of ln, and as a density it falls by 1/x beside the normal part.
  const double mode = std::exp(middle - variance);
  EXPECT_GT(log_prior(range, mode), log_prior(range, 1.01 * mode));
  EXPECT_GT(log_prior(range, mode), log_prior(range, 0.99 * mode));
  EXPECT_EQ(log_prior(range, 0.0), -std::numeric_limits<double>::infinity());
}

TEST(Prior, UniformIsTheRange) {
  const ParameterRange range = {"mu", 0.2, 0.6};
  EXPECT_NEAR(prior_quantile(range, 0.25), 0.3, 1e-12);
  EXPECT_NEAR(prior_deviation(range), 0.4 / std::sqrt(12.0), 1e-6);
  EXPECT_EQ(log_prior(range, 0.3), log_prior(range, 0.5));
  EXPECT_EQ(off_prior(range, 0.3), 0.0);
}

TEST(NormalEquivalent, SlopeIsThatOfTheFunction) {
  for (const double freedom : {0.7, 1.0, 2.5, 3.0, 5.4, 6.0, 20.0, 1e10}) {
    for (const double t : {-40.0, -4.0, -0.3, 0.0, 1e-4, 0.5, 2.0, 12.0}) {
      const double step = 1e-5;
      const double slope = (normal_equivalent(t + step, freedom) - normal_equivalent(t - step, freedom)) / (2.0 * step);
      EXPECT_NEAR(log_slope_of_normal_equivalent(t, freedom), std::log(slope), 1e-6) << t << " " << freedom;
    }
  }
}

/// An observable of a known function at the points of a design, free of noise.
template <class Function>
ObservableData observable(const char* name, const std::vector<std::vector<double>>& runs, double laboratory,
                          double deviation, Function function) {
  ObservableData o = {.name = name,
                      .transform = Transform::none,
                      .laboratory = {.value = laboratory, .deviation = deviation},
                      .values = {}};
  for (const std::vector<double>& run : runs) o.values.push_back(function(run));
  return o;
}

// Planes and normal priors: the posterior is normal with the information J^T S^-1 J + P^-1. Nothing tells of the third
// parameter, which keeps its prior.
TEST(Posterior, OfPlanesWithNormalPriors) {
  const std::vector<ParameterRange> ranges = {{"x", 0.0, 1.0, {PriorKind::normal, 0.5, 0.06}},
                                              {"y", 0.0, 2.0, {PriorKind::normal, 1.1, 0.08}},
                                              {"z", -1.0, 1.0, {PriorKind::normal, 0.1, 0.15}}};
  const auto runs = start_design(ranges, 30, 1);
  const std::vector<ObservableData> observables = {
      observable("sum", runs, 1.6, 0.05, [](const auto& p) { return p[0] + p[1]; }),
      observable("difference", runs, -0.4, 0.2, [](const auto& p) { return p[0] - p[1]; })};
  const Misfit misfit(ranges, runs, observables);
  ASSERT_TRUE(takes_posterior(ranges));
  const Estimate e = estimate(misfit, 0.95);
  ASSERT_TRUE(e.posterior);

  Matrix slopes(2, 2);
  slopes << 1.0, 1.0, 1.0, -1.0;
  const Matrix weight = Eigen::Vector2d(1.0 / (0.05 * 0.05), 1.0 / (0.2 * 0.2)).asDiagonal();
  const Matrix before = Eigen::Vector2d(1.0 / (0.06 * 0.06), 1.0 / (0.08 * 0.08)).asDiagonal();
  const Matrix covariance = (slopes.transpose() * weight * slopes + before).inverse();
  const Vector mean =
      covariance * (slopes.transpose() * weight * Eigen::Vector2d(1.6, -0.4) + before * Eigen::Vector2d(0.5, 1.1));
  for (Index j = 0; j < 2; ++j) {
    const Marginal& m = e.posterior->marginals[static_cast<std::size_t>(j)];
    const double deviation = std::sqrt(covariance(j, j));
    EXPECT_NEAR(m.mean, mean[j], 0.12 * deviation) << j;
    EXPECT_NEAR(m.deviation / deviation, 1.0, 0.12) << j;
    EXPECT_NEAR(m.interval.lower, mean[j] - 1.96 * deviation, 0.25 * deviation) << j;
    EXPECT_NEAR(m.interval.upper, mean[j] + 1.96 * deviation, 0.25 * deviation) << j;
    EXPECT_TRUE(m.determined);
    EXPECT_NEAR(e.points[0].values[static_cast<std::size_t>(j)], mean[j], 1e-3 * deviation) << j;
  }
  EXPECT_NEAR(e.posterior->correlations(0, 1), covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1)), 0.08);
  const Marginal& z = e.posterior->marginals[2];
  EXPECT_NEAR(z.mean, 0.1, 0.02);
  EXPECT_NEAR(z.deviation, 0.15, 0.018);
  EXPECT_FALSE(z.determined);
  EXPECT_NEAR(e.points[0].values[2], 0.1, 1e-3);
  EXPECT_EQ(e.verdict, "posterior of 3 parameters from 2 observables, which do not determine z");
  // The region of the highest density is the ellipsoid of chi-squared with three degrees of freedom.
  const auto density_at = [&](double deviations) {
    const std::vector<double> point = {mean[0], mean[1], 0.1 + deviations * 0.15};
    return log_posterior(misfit, to_box(ranges, point));
  };
  EXPECT_NEAR(density_at(0.0) - e.posterior->limit, 0.5 * 7.8147, 0.3);
  EXPECT_TRUE(e.posterior->covers(density_at(2.6)));
  EXPECT_FALSE(e.posterior->covers(density_at(3.0)));
}

// An observable that is ln x: the posterior of ln x is normal.
TEST(Posterior, OfALognormalPrior) {
  const std::vector<ParameterRange> ranges = {{"x", 0.3, 8.0, {PriorKind::lognormal, 2.0, 1.0}}};
  const auto runs = start_design(ranges, 40, 1);
  const std::vector<ObservableData> observables = {
      observable("ln", runs, 0.2, 0.3, [](const auto& p) { return std::log(p[0]); })};
  const Estimate e = estimate(ranges, runs, observables, 0.9);
  const double before = std::log(1.25);
  const double variance = 1.0 / (1.0 / before + 1.0 / 0.09);
  const double middle = variance * ((std::log(2.0) - 0.5 * before) / before + 0.2 / 0.09);
  const Marginal& m = e.posterior->marginals[0];
  EXPECT_NEAR(std::log(m.median), middle, 0.12 * std::sqrt(variance));
  EXPECT_NEAR(std::log(m.interval.upper), middle + 1.645 * std::sqrt(variance), 0.2 * std::sqrt(variance));
  EXPECT_NEAR(std::log(m.interval.lower), middle - 1.645 * std::sqrt(variance), 0.2 * std::sqrt(variance));
  EXPECT_NEAR(std::log(e.points[0].values[0]), middle, 0.01);
}

// Of a sum alone each parameter is open to the ends, and both go together.
TEST(Posterior, SaysWhatIsOpenAndWhatGoesTogether) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 1.0}, {"b", 0.0, 1.0}, {"c", 0.0, 1.0}, {"d", 0.0, 1.0}};
  const auto runs = start_design(ranges, 40, 1);
  const std::vector<ObservableData> observables = {
      observable("a + b", runs, 1.0, 0.02, [](const auto& p) { return p[0] + p[1]; }),
      observable("c", runs, 0.5, 0.05, [](const auto& p) { return p[2]; })};
  const Estimate e = estimate(ranges, runs, observables, 0.95);
  const Posterior& p = *e.posterior;
  EXPECT_LT(p.correlations(0, 1), -0.97);
  EXPECT_TRUE(p.marginals[0].interval.open_below && p.marginals[0].interval.open_above);
  EXPECT_FALSE(p.marginals[2].interval.open_below || p.marginals[2].interval.open_above);
  EXPECT_NEAR(p.marginals[2].deviation, 0.05, 0.006);
  EXPECT_TRUE(p.marginals[2].determined);
  EXPECT_FALSE(p.marginals[3].determined);
  EXPECT_NEAR(p.marginals[3].deviation, 1.0 / std::sqrt(12.0), 0.02);
  EXPECT_NEAR(*e.half_width, 0.475, 0.02);
  EXPECT_NE(e.verdict.find("do not determine a, b, d"), std::string::npos) << e.verdict;
}

TEST(Posterior, SaysThatNothingFits) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 1.0, {PriorKind::normal, 0.5, 0.2}}};
  const std::vector<std::vector<double>> runs = {{0.0}, {0.2}, {0.4}, {0.6}, {0.8}, {1.0}};
  const std::vector<ObservableData> observables = {
      observable("a", runs, 1.5, 0.05, [](const auto& p) { return p[0]; })};
  const Estimate e = estimate(ranges, runs, observables, 0.95);
  EXPECT_TRUE(e.points.empty() && e.parts.empty());
  EXPECT_FALSE(e.half_width);
  EXPECT_FALSE(e.nearest.acceptable);
  EXPECT_NEAR(e.nearest.values[0], 1.0, 1e-6);
  EXPECT_NEAR(e.nearest.off_by[0], -10.0, 0.1);
  EXPECT_NE(e.verdict.find("no parameters within the ranges"), std::string::npos) << e.verdict;
}

// All samples are where the prior is, far from where the laboratory is met.
TEST(Posterior, FindsWhatFitsFarFromThePrior) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 1.0, {PriorKind::normal, 0.25, 0.06}}};
  std::vector<std::vector<double>> runs;
  for (int i = 0; i <= 20; ++i) runs.push_back({0.05 * i});
  const auto hills = [](const auto& p) {
    const auto hill = [&](double at) { return std::exp(-std::pow((p[0] - at) / 0.12, 2)); };
    return hill(0.25) + 1.6 * hill(0.8);
  };
  const Estimate e = estimate(ranges, runs, std::vector{observable("f", runs, 1.35, 0.1, hills)}, 0.95);
  EXPECT_TRUE(e.nearest.acceptable) << e.verdict;
  EXPECT_LT(e.nearest.misfit, 1e-10);
  EXPECT_NEAR(std::fabs(e.nearest.values[0] - 0.8), 0.12 * std::sqrt(std::log(1.6 / 1.35)), 5e-3);
  ASSERT_EQ(e.points.size(), 1U);
  EXPECT_NEAR(e.points[0].values[0], 0.25, 0.02);
  EXPECT_NE(e.verdict.find("the priors draw the best point off the laboratory"), std::string::npos) << e.verdict;
}

// Of two narrow maxima the deviation is as great as that of the prior; yet the observable tells of the parameter.
TEST(Posterior, OfTwoNarrowMaximaIsDetermined) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 1.0, {PriorKind::normal, 0.5, 0.4}}};
  std::vector<std::vector<double>> runs;
  for (int i = 0; i <= 20; ++i) runs.push_back({0.05 * i});
  const auto bowl = [](const auto& p) { return (p[0] - 0.5) * (p[0] - 0.5); };
  const Estimate e = estimate(ranges, runs, std::vector{observable("f", runs, 0.1225, 0.005, bowl)}, 0.95);
  const Marginal& m = e.posterior->marginals[0];
  EXPECT_GT(m.deviation, m.prior_deviation);
  EXPECT_TRUE(m.determined);
  EXPECT_TRUE(m.separate);
  EXPECT_EQ(e.verdict, "posterior of 1 parameter from 1 observable");
}

TEST(Posterior, RefusesSevenParameters) {
  std::vector<ParameterRange> ranges;
  for (int j = 0; j < 7; ++j) ranges.push_back({"p" + std::to_string(j), 0.0, 1.0});
  const auto runs = start_design(ranges, 12, 1);
  const std::vector<ObservableData> observables = {
      observable("a", runs, 0.5, 0.05, [](const auto& p) { return p[0]; })};
  EXPECT_THROW(estimate(ranges, runs, observables, 0.95), DeckError);
}

}  // namespace
}  // namespace repose
