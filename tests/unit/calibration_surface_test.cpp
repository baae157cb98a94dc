// Surfaces of observables: transforms, units, coverage of their own interval, what is refused.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/response_surface.h"
#include "calibration_samples.h"
#include "calibration_stand_ins.h"

namespace repose {
namespace {

TEST(Transform, MeanInUnitsIsThatOfTheValues) {
  // Two equally likely values on each scale: their mean and variance are known exactly.
  const double a = transformed(Transform::square_root, 3.0);
  const double b = transformed(Transform::square_root, 11.0);
  EXPECT_NEAR(mean_in_units(Transform::square_root, 0.5 * (a + b), 0.25 * (a - b) * (a - b)), 7.0, 1e-13);
  EXPECT_EQ(mean_in_units(Transform::none, 7.0, 2.0), 7.0);
  EXPECT_NEAR(mean_in_units(Transform::logarithm, 1.0, 0.5), std::exp(1.25), 1e-13);
}

TEST(Transform, BackAndForth) {
  for (const Transform t : {Transform::none, Transform::square_root, Transform::logarithm}) {
    for (const double value : {0.8, 5.0, 700.0}) {
      const double mean = transformed_mean(t, value, 0.2);
      EXPECT_NEAR(mean_in_units(t, mean, 0.2) / value, 1.0, 1e-12);
      const double slope = (transformed_mean(t, value + 1e-4, 0.2) - transformed_mean(t, value - 1e-4, 0.2)) / 2e-4;
      EXPECT_NEAR(slope_of_transform(t, mean, 0.2) / slope, 1.0, 1e-6);
    }
  }
}

TEST(ResponseSurface, SpeaksInUnits) {
  const Matrix points = unit_grid(5, 4);
  const std::vector<double> values = values_at(points, [](double x, double y) { return 400.0 + 100.0 * x * y; });
  for (const Transform t : {Transform::none, Transform::square_root, Transform::logarithm}) {
    const ResponseSurface surface("counts", t, points, values);
    EXPECT_NEAR(surface.mean(vector_of({0.5, 0.5})), 425.0, 0.5);
    EXPECT_LT(surface.deviation(vector_of({0.5, 0.5})), 1.0);
    // The level of a mean is where the surface has that mean.
    const double level = surface.scaled_level(surface.mean(vector_of({0.3, 0.9})));
    EXPECT_NEAR(level, surface.process().at(vector_of({0.3, 0.9})).mean, 1e-9);
  }
}

TEST(ResponseSurface, NoiseOfCountsIsPoissons) {
  const Matrix points = unit_grid(6, 10);
  Draw draw(5);
  const auto mean = [](double x, double y) { return 20.0 + 380.0 * x * x * (0.5 + 0.5 * y); };
  const std::vector<double> values = values_at(points, [&](double x, double y) { return draw.poisson(mean(x, y)); });
  const ResponseSurface surface("counts", Transform::square_root, points, values);
  for (const double x : {0.1, 0.5, 0.9}) {
    const double expected = mean(x, 0.5);
    EXPECT_NEAR(surface.noise_deviation(vector_of({x, 0.5})) / std::sqrt(expected), 1.0,
                0.1);  // 324 degrees of freedom
    EXPECT_NEAR(surface.mean(vector_of({x, 0.5})), expected, 4.0 * surface.deviation(vector_of({x, 0.5})));
  }
}

// Of 400 new surfaces 95 % hold a true value in their interval at places chosen anew: the binomial's 4 deviations
// about.
TEST(ResponseSurface, IntervalCoversTheTruth) {
  const StandIn s = friction_stand_in();
  Draw draw(11);
  int covered = 0;
  int asked = 0;
  for (int i = 0; i < 40; ++i) {
    Campaign c = start_of(s, laboratory_of(s, hidden_in(s, draw), draw));
    add_grid(c, s, 5, 2, draw);
    const Matrix points = to_box(s.ranges, c.points);
    for (std::size_t k = 0; k < 2; ++k) {
      const ResponseSurface surface("observable", s.transform, points, c.observables[k].values);
      for (int j = 0; j < 5; ++j, ++asked) {
        const std::vector<double> place = hidden_in(s, draw);
        const Vector at = to_box(s.ranges, place);
        const double truth = s.response[k](place[0], place[1]);
        if (std::fabs(surface.mean(at) - truth) <= 1.96 * surface.deviation(at)) ++covered;
      }
    }
  }
  ASSERT_EQ(asked, 400);
  EXPECT_GE(covered, 362);
  EXPECT_LE(covered, 397);
}

TEST(ResponseSurface, RunsWithoutAValueAreLeftOut) {
  const Matrix points = unit_grid(4);
  std::vector<double> values = values_at(points, [](double x, double y) { return x + y; });
  values.back() = std::numeric_limits<double>::quiet_NaN();
  const ResponseSurface surface("angle", Transform::none, points, values);
  EXPECT_EQ(surface.process().data().size(), 15);
  EXPECT_NEAR(surface.mean(vector_of({0.4, 0.4})), 0.8, 0.01);
}

TEST(ResponseSurface, RefusesWhatIsNoSurface) {
  EXPECT_THROW(ResponseSurface("mass", Transform::none, rows({{0.0}, {0.5}, {1.0}}), std::vector{1.0, 2.0, 3.0}),
               DeckError);
  EXPECT_THROW(ResponseSurface("mass", Transform::logarithm, unit_grid(2), std::vector{1.0, 2.0, 3.0, 0.0}), DeckError);
  EXPECT_THROW(ResponseSurface("area", Transform::square_root, unit_grid(2), std::vector{1.0, 2.0, 3.0, -5.0}),
               DeckError);
}

}  // namespace
}  // namespace repose
