// Processes over levels against closed forms: one level is plain kriging, several are the recursive form, and what the
// likelihood, the weights and the noise say.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/level_likelihood.h"
#include "calibration/level_process.h"
#include "calibration/level_surface.h"
#include "calibration/likelihood.h"
#include "calibration/misfit.h"
#include "calibration_level_stand_ins.h"
#include "calibration_samples.h"

namespace repose {
namespace {

double cheap(double x, double y) { return std::sin(3.0 * x) + x * y * y; }
double dear(double x, double y) { return 2.0 * cheap(x, y) + 3.0; }

/// With a scatter that is no random number.
Replicates runs_of(const Matrix& points, double (*function)(double, double), double scatter) {
  std::vector<double> values = values_at(points, function);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += scatter * std::sin(37.0 * static_cast<double>(i));
  return replicates_of(points, values);
}

LevelParameters parameters(double rho, double length, double variance, double noise) {
  return {.rho = rho,
          .lengths = vector_of({length, 1.2 * length}),
          .added_variance = variance,
          .noise = vector_of({std::log(noise), 0.3, -0.2})};
}

const Matrix few = rows({{0.1, 0.2}, {0.9, 0.3}, {0.4, 0.8}, {0.7, 0.6}, {0.2, 0.9}});
const Matrix places = rows({{0.33, 0.41}, {0.9, 0.1}, {0.05, 0.7}});

TEST(LevelProcess, OfOneLevelIsPlainKriging) {
  const Replicates data = runs_of(unit_grid(4, 2), cheap, 0.05);
  const GaussianProcess plain(data, {.lengths = vector_of({0.6, 0.9}), .noise_ratio = 0.02});
  const LevelParameters h = {.rho = 0.0,
                             .lengths = vector_of({0.6, 0.9}),
                             .added_variance = plain.signal_variance(),
                             .noise = vector_of({std::log(plain.noise_variance() - 1e-9), 0.0, 0.0})};
  const LevelProcess process({data}, {h});
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector at = places.row(i).transpose();
    EXPECT_NEAR(process.at(at).mean, plain.at(at).mean, 1e-10);
    EXPECT_NEAR(process.at(at).deviation, plain.at(at).deviation, 1e-10);
    EXPECT_NEAR((process.weights(at)[0] - plain.weights(at)).norm(), 0.0, 1e-10);
  }
  EXPECT_NEAR((process.covariance(0, places, 0, few) - plain.covariance(places, few)).norm(), 0.0, 1e-10);
}

/// A level given the one below, by the recursive form: the mean and covariance of the level below given its own runs
/// are the prior of this one.
struct Recursive {
  const LevelProcess& below;
  const Replicates& data;
  LevelParameters h;

  Matrix terms(const Matrix& at) const {
    Matrix result = Matrix::Ones(at.rows(), 2);  // too few points for a plane
    for (Index i = 0; i < at.rows(); ++i) result(i, 0) = below.mean(at.row(i).transpose());
    return result;
  }
  Matrix prior(const Matrix& a, const Matrix& b) const {
    return h.rho * h.rho * below.covariance(0, a, 0, b) + h.added_variance * MaternKernel{h.lengths}.between(a, b);
  }
  /// Mean in the first column, covariance in the others.
  Matrix given_runs(const Matrix& at) const {
    Matrix v = prior(data.points, data.points);
    for (Index i = 0; i < data.size(); ++i) {
      v(i, i) += h.noise_variance(data.points.row(i).transpose()) / data.count[i];
    }
    const Matrix inverse = v.inverse();
    const Matrix f = terms(data.points);
    Matrix information = f.transpose() * inverse * f;
    information(0, 0) += 1.0 / (rho_scatter * rho_scatter);
    const Matrix g = information.inverse();
    const Vector beta = g * f.transpose() * inverse * data.mean;
    const Matrix near = prior(data.points, at);
    const Matrix excess = terms(at).transpose() - f.transpose() * inverse * near;
    Matrix result(at.rows(), 1 + at.rows());
    result.col(0) = terms(at) * beta + near.transpose() * inverse * (data.mean - f * beta);
    result.rightCols(at.rows()) = prior(at, at) - near.transpose() * inverse * near + excess.transpose() * g * excess;
    return result;
  }
};

TEST(LevelProcess, OfAllRunsTogetherIsTheRecursiveForm) {
  const Replicates low = runs_of(unit_grid(4, 2), cheap, 0.05);
  const Replicates high = runs_of(few, dear, 0.1);
  const LevelParameters h_low = parameters(0.0, 0.7, 0.8, 0.003);
  const LevelParameters h_high = parameters(1.9, 0.5, 0.1, 0.01);
  const LevelProcess process({low, high}, {h_low, h_high});
  const LevelProcess below({low}, {h_low});
  const Matrix expected = Recursive{below, high, h_high}.given_runs(places);
  const Matrix covariance = process.covariance(1, places, 1, places);
  for (Index i = 0; i < places.rows(); ++i) {
    EXPECT_NEAR(process.mean(places.row(i).transpose()), expected(i, 0), 1e-9);
    EXPECT_NEAR(process.at(places.row(i).transpose()).mean, expected(i, 0), 1e-9);
    // The surface's deviation has the product of both uncertainties besides (C.27).
    const double low_deviation = below.at(places.row(i).transpose()).deviation;
    const double product = process.rho_deviation(1) * low_deviation;
    const double deviation = process.at(places.row(i).transpose()).deviation;
    EXPECT_NEAR(deviation * deviation, expected(i, 1 + i) + product * product, 1e-9);
  }
  EXPECT_NEAR((covariance - expected.rightCols(3)).cwiseAbs().maxCoeff(), 0.0, 1e-9);
}

TEST(LevelProcess, LearnsTheLowLevelFromTheHighOne) {
  const LevelParameters h_low = parameters(0.0, 0.7, 0.8, 0.003);
  const LevelProcess process({runs_of(unit_grid(3), cheap, 0.0), runs_of(few, dear, 0.0)},
                             {h_low, parameters(2.0, 0.7, 1e-4, 1e-4)});
  const LevelProcess alone({runs_of(unit_grid(3), cheap, 0.0)}, {h_low});
  const Matrix point = few.row(3);
  EXPECT_LT(process.covariance(0, point, 0, point)(0, 0), 0.7 * alone.covariance(0, point, 0, point)(0, 0));
  EXPECT_NEAR((process.covariance(0, places, 1, few) - process.covariance(1, few, 0, places).transpose()).norm(), 0.0,
              1e-9);
}

TEST(LevelProcess, FindsAMultipleOfTheLevelBelow) {
  const LevelProcess process({runs_of(unit_grid(6), cheap, 0.0), runs_of(few, dear, 0.0)});
  EXPECT_NEAR(process.parameters(1).rho, 2.0, 0.02);
  EXPECT_LT(process.rho_deviation(1), 0.1);
  for (Index i = 0; i < places.rows(); ++i) {
    EXPECT_NEAR(process.mean(places.row(i).transpose()), dear(places(i, 0), places(i, 1)), 0.02);
  }
}

TEST(LevelProcess, AFlatLevelBelowTellsNothing) {
  const auto flat = [](double, double) { return 0.0; };
  const LevelProcess process({runs_of(unit_grid(4), flat, 0.0), runs_of(unit_grid(4), dear, 0.0)});
  const LevelProcess alone({runs_of(unit_grid(4), dear, 0.0)});
  const Vector at = vector_of({0.4, 0.4});
  EXPECT_TRUE(std::isfinite(process.at(at).deviation));
  EXPECT_NEAR(process.mean(at), alone.mean(at), 0.05);
}

// Weights are what the mean takes of the values: with rho at its fixed point, by differences.
TEST(LevelProcess, WeightsAreThoseOfItsValues) {
  const Replicates low = runs_of(unit_grid(4), cheap, 0.05);
  const Replicates high = runs_of(few, dear, 0.1);
  const LevelProcess fitted({low, high});
  const std::vector<LevelParameters> held = {fitted.parameters(0), fitted.parameters(1)};
  const Vector at = vector_of({0.35, 0.55});
  const std::vector<Vector> weights = fitted.weights(at);
  constexpr double step = 1e-4;
  for (const std::size_t level : {0U, 1U}) {
    for (const Index i : {0, 3}) {
      std::vector<Replicates> changed = {low, high};
      changed[level].mean[i] += step;
      const LevelProcess more(changed, held);
      EXPECT_NEAR((more.mean(at) - fitted.mean(at)) / step, weights[level][i], 2e-3) << level << " " << i;
    }
  }
}

struct LevelDeviance : testing::Test {
  Replicates low = runs_of(unit_grid(4, 2), cheap, 0.05);
  Replicates high = runs_of(few.replicate(2, 1), dear, 0.1);
  LevelProcess process = LevelProcess({low}, {parameters(0.0, 0.7, 0.8, 0.003)});
  BelowLevel below;
  Vector x = vector_of({-0.4, 0.2, -1.0, -3.0, 0.5, -0.3});

  void SetUp() override {
    below.mean.resize(high.size());
    for (Index i = 0; i < high.size(); ++i) below.mean[i] = process.mean(high.points.row(i).transpose());
    below.covariance = process.covariance(0, high.points, 0, high.points);
    below.noise = process.parameters(0).noise;
  }

  /// Against differences, at two noises of which the second is near its floor.
  void expect_gradient(const Replicates& runs) {
    Vector gradient, ignored;
    const auto deviance = [&](const Vector& at) { return level_deviance(runs, below, 3.6, at, ignored); };
    for (const double noise : {-3.0, -20.0}) {
      x[3] = noise;
      const double rounding = 1e-15 * std::fabs(level_deviance(runs, below, 3.6, x, gradient)) / 1e-5;
      for (Index j = 0; j < x.size(); ++j) {
        Vector before = x;
        Vector after = x;
        before[j] -= 1e-5;
        after[j] += 1e-5;
        const double slope = (deviance(after) - deviance(before)) / 2e-5;
        EXPECT_NEAR(gradient[j], slope, rounding + 1e-5 * (1.0 + std::fabs(slope))) << j << " at " << noise;
      }
    }
  }
};

TEST_F(LevelDeviance, HasTheGradientItSays) { expect_gradient(high); }
TEST_F(LevelDeviance, HasTheGradientItSaysWithOneSeed) { expect_gradient(runs_of(few, dear, 0.1)); }

// Five points on a smooth surface do not make runs certain that scatter below.
TEST_F(LevelDeviance, WithoutASecondSeedTheScatterIsThatOfTheLevelBelow) {
  const double rho = 1.5;
  const Replicates smooth = replicates_of(few, values_at(few, [&](double a, double b) {
                                            return rho * process.mean(vector_of({a, b}));
                                          }));
  below.noise = vector_of({-3.0, 0.4, -0.2});
  const LevelParameters alone = most_likely_level(smooth, {below.mean, below.covariance, {}});
  const LevelParameters with_below = most_likely_level(smooth, below);
  EXPECT_NEAR(with_below.rho, rho, 0.1);
  const Vector middle = vector_of({0.5, 0.5});
  const double scatter_below = rho * std::exp(0.5 * below.noise[0]);
  EXPECT_LT(std::sqrt(alone.noise_variance(middle)), 0.1 * scatter_below);
  EXPECT_GT(std::sqrt(with_below.noise_variance(middle)), 0.4 * scatter_below);
  EXPECT_LT(std::sqrt(with_below.noise_variance(middle)), 1.2 * scatter_below);
}

// Runs together at a point are worth the same runs one by one, at points that hardly differ.
TEST_F(LevelDeviance, OfReplicatesIsThatOfTheirRuns) {
  std::vector<double> values;
  for (std::size_t run = 0; run < high.point_of_run.size(); ++run) {
    values.push_back(high.mean[high.point_of_run[run]] + high.rest_of_run[run]);
  }
  Matrix apart = few.replicate(2, 1);
  apart.bottomRows(few.rows()).array() += 1e-7;
  const Replicates single = replicates_of(apart, values);
  ASSERT_EQ(single.size(), 2 * high.size());
  BelowLevel of_single;
  of_single.mean = below.mean.replicate(2, 1);
  of_single.covariance = below.covariance.replicate(2, 2);
  Vector ignored;
  Vector other = x;
  other[3] += 0.7;
  other[4] -= 0.4;
  const double together =
      level_deviance(high, below, 3.6, x, ignored) - level_deviance(high, below, 3.6, other, ignored);
  const double one_by_one =
      level_deviance(single, of_single, 3.6, x, ignored) - level_deviance(single, of_single, 3.6, other, ignored);
  EXPECT_NEAR(together, one_by_one, 1e-4);
}

// A scatter that falls to the quarter over the first parameter. Of 64 points with 8 seeds the slope of ln(variance) has
// an error of about 0.23.
TEST(LevelNoise, FollowsTheScatterOfTheSeeds) {
  const Matrix points = unit_grid(8, 8);
  Draw draw(7);
  const std::vector<double> values =
      values_at(points, [&](double x, double y) { return cheap(x, y) + 0.2 * std::exp2(-2.0 * x) * draw.normal(); });
  const LevelProcess process({replicates_of(points, values)});
  const auto scatter = [&](double x) { return std::sqrt(process.parameters(0).noise_variance(vector_of({x, 0.5}))); };
  EXPECT_NEAR(scatter(0.0) / 0.2, 1.0, 0.15);
  EXPECT_NEAR(scatter(1.0) / 0.05, 1.0, 0.15);
}

TEST(LevelSurface, SpeaksInUnitsOfTheLastLevel) {
  Matrix points(36 + few.rows(), 2);
  points << unit_grid(6), few;
  RunLevels levels{.count = 2, .of_run = std::vector<std::size_t>(36, 0)};
  levels.of_run.resize(36 + static_cast<std::size_t>(few.rows()), 1);
  for (const Transform t : {Transform::none, Transform::square_root, Transform::logarithm}) {
    std::vector<double> values = values_at(points, [](double x, double y) { return 400.0 + 100.0 * x * y; });
    for (std::size_t i = 0; i < 36; ++i) values[i] *= 0.1;
    const LevelSurface surface("counts", t, points, values, levels);
    const Vector at = vector_of({0.5, 0.5});
    EXPECT_NEAR(surface.mean(at), 425.0, 1.0);
    EXPECT_LT(surface.deviation(at), 5.0);
    // Values without noise make a covariance with a condition of 1e9: sums in another order differ by that.
    EXPECT_NEAR(surface.level_of(surface.mean(at), at), surface.at(at).mean, 1e-5);
    EXPECT_NEAR(surface.rho(1), t == Transform::none ? 10.0 : t == Transform::square_root ? std::sqrt(10.0) : 1.0, 0.2);
    const Vector slope = surface.gradient(at);
    EXPECT_GT(slope[0], 0.0);
    EXPECT_NEAR(slope[0] / slope[1], 1.0, 0.05);
  }
}

TEST(LevelSurface, TellsWhatALevelExplainsOverUpToSixParameters) {
  for (const std::size_t parameters : {std::size_t{4}, std::size_t{5}, std::size_t{6}}) {
    std::vector<ParameterRange> ranges;
    for (std::size_t k = 0; k < parameters; ++k) ranges.push_back({"p" + std::to_string(k), 0.0, 1.0});
    const std::vector<std::vector<double>> design = start_design(ranges, 12, 1);
    const auto d = static_cast<Index>(parameters);
    Matrix points(24, d);
    RunLevels levels = {.count = 2, .of_run = {}};
    std::vector<double> values;
    for (Index run = 0; run < 24; ++run) {
      const std::vector<double>& point = design[static_cast<std::size_t>(run % 12)];
      for (Index j = 0; j < d; ++j) points(run, j) = point[static_cast<std::size_t>(j)];
      levels.of_run.push_back(run < 12 ? 0 : 1);
      values.push_back((run < 12 ? 1.0 : 2.0) * (point[0] + point[1] * point[2]));
    }
    const LevelSurface surface("mass", Transform::none, points, values, levels);
    EXPECT_GT(surface.explained(1), 0.8) << parameters;
    EXPECT_LE(surface.explained(1), 1.0) << parameters;
  }
}

TEST(LevelSurface, EveryLevelNeedsItsPoints) {
  const RunLevels levels{.count = 2, .of_run = {0, 0, 0, 0, 1, 1, 1}};
  Matrix points(7, 2);
  points << unit_grid(2), few.topRows(3);
  EXPECT_THROW(LevelSurface("mass", Transform::none, points, std::vector<double>{1, 2, 3, 4, 5, 6, 7}, levels),
               DeckError);
}

TEST(Discrepancy, WidensTheDifferenceByItsVariance) {
  const StandIn s = friction_stand_in();
  Draw draw(8);
  Campaign c = start_of(s, laboratory_of(s, {0.6, 0.3}, draw));
  add_grid(c, s, 4, 2, draw);
  const Misfit without(s.ranges, c.points, c.observables);
  c.observables[0].discrepancy = 0.3;
  const Misfit with(s.ranges, c.points, c.observables);
  const Vector at = vector_of({0.4, 0.4});
  const double scale = with.surface(0).deviation_of(0.0, 1.0, at);
  const Matrix difference = with.look(at).covariance - without.look(at).covariance;
  EXPECT_NEAR(difference(0, 0), 0.09 * scale * scale, 1e-12);
  EXPECT_NEAR(difference.squaredNorm(), difference(0, 0) * difference(0, 0), 1e-20);
  EXPECT_LT(with(at), without(at));
  c.observables[0].discrepancy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Misfit(s.ranges, c.points, c.observables), DeckError);
}

}  // namespace
}  // namespace repose
