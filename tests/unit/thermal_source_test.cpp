// The dimensionless rise of a transient plane source and the functions below it, against closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "base/distributions.h"
#include "base/math.h"
#include "thermal/plane_source/source_function.h"
#include "thermal/plane_source/synthetic_transient.h"
#include "thermal_samples.h"

namespace repose::thermal {
namespace {

/// Abramowitz and Stegun, table 9.8, and the two expansions where they meet.
TEST(ScaledBessel, MeetsTables) {
  EXPECT_NEAR(scaled_bessel(0, 0.0), 1.0, 1e-15);
  EXPECT_NEAR(scaled_bessel(1, 0.0), 0.0, 1e-15);
  EXPECT_NEAR(scaled_bessel(0, 1.0), 0.4657596076, 1e-10);
  EXPECT_NEAR(scaled_bessel(1, 1.0), 0.2079104154, 1e-10);
  EXPECT_NEAR(scaled_bessel(0, 10.0), 0.1278333372, 1e-10);
  EXPECT_NEAR(scaled_bessel(1, 10.0), 0.1212626814, 1e-10);
  for (const int order : {0, 1})
    EXPECT_NEAR(scaled_bessel(order, 30.0), scaled_bessel(order, std::nextafter(30.0, 0.0)), 1e-14);
}

/// The values given with the project's reference data, and 4/(3 sqrt(pi)) - 1/(4 tau) towards infinity.
TEST(SourceFunction, OfADiscMeetsTheClosedForm) {
  const SourceFunction disc = SourceFunction::disc();
  const double values[][2] = {{0.1, 0.094365}, {0.5, 0.363750}, {1.0, 0.520773}, {2.0, 0.629778}, {5.0, 0.702419}};
  for (const auto& [tau, d] : values) EXPECT_NEAR(disc(tau), d, 1e-6) << tau;
  EXPECT_NEAR(disc(100.0), 4.0 / (3.0 * std::sqrt(pi)) - 1.0 / 400.0, 1e-6);
  EXPECT_NEAR(disc(1e-5), 1e-5 - 1e-10 / std::sqrt(pi), 1e-15);  // below the table
  EXPECT_NEAR(disc(1.1e-4), 1.1e-4 - 1.21e-8 / std::sqrt(pi), 1e-12);
}

TEST(SourceFunction, HasItsDerivative) {
  for (const SourceFunction& d : {SourceFunction::disc(), SourceFunction::of_rings(10, 0.01)}) {
    for (const double tau : {0.02, 0.3, 0.7, 3.0}) {
      const double step = 1e-4 * tau;
      EXPECT_NEAR((d(tau + step) - d(tau - step)) / (2.0 * step), d.derivative(tau), 1e-7 * d.derivative(tau)) << tau;
    }
  }
}

/// (T.2) as it is printed, with the Bessel function of the standard library and the trapezium rule over ln(sigma).
TEST(SourceFunction, OfFewRingsIsItsIntegral) {
  const double cutoff = 0.05;
  constexpr int steps = 20'000;
  const double width = std::log(1.0 / cutoff) / steps;
  for (const int m : {1, 3}) {
    double integral = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const double sigma = cutoff * std::exp(width * i);
      const double a = 4.0 * m * m * sigma * sigma;
      double sum = 0.0;
      for (int l = 1; l <= m; ++l)
        for (int k = 1; k <= m; ++k)
          sum += l * k * std::exp(-(l * l + k * k) / a) * std::cyl_bessel_i(0.0, 2.0 * l * k / a);
      integral += (i == 0 || i == steps ? 0.5 : 1.0) * width * sum / sigma;
    }
    integral /= m * m * (m + 1.0) * (m + 1.0);
    EXPECT_NEAR(SourceFunction::of_rings(m, cutoff)(1.0), integral, 1e-8) << m;
  }
}

/// Many rings are a disc but for a constant, the line sources' own: the difference between two times is that of a disc.
/// The rings lie at 1/m, 2/m, ... 1, so their weight is that of a disc larger by about 1/(2m): 1 % for m = 50.
TEST(SourceFunction, OfManyRingsTendsToTheDisc) {
  const SourceFunction disc = SourceFunction::disc();
  double last = 1.0;
  for (const std::int64_t m : {5, 20, 50}) {
    const SourceFunction rings = SourceFunction::of_rings(m, 0.5 / static_cast<double>(m));
    const double error = std::abs((rings(1.0) - rings(0.3)) / (disc(1.0) - disc(0.3)) - 1.0);
    EXPECT_LT(error, 0.5 / static_cast<double>(m)) << m;
    EXPECT_LT(error, 0.5 * last) << m;
    last = error;
  }
}

/// The integrand is 1/(2 (m + 1) sqrt(pi) sigma) for small sigma: so much more for each factor of the cutoff, at any
/// time alike. The next term of the integrand is worth 1.7e-6 here.
TEST(SourceFunction, CutoffAddsAConstant) {
  const SourceFunction wide = SourceFunction::of_rings(10, 0.01);
  const SourceFunction narrow = SourceFunction::of_rings(10, 0.001);
  for (const double tau : {0.2, 0.7, 2.0})
    EXPECT_NEAR(narrow(tau) - wide(tau), std::log(10.0) / (22.0 * std::sqrt(pi)), 2e-6) << tau;
}

/// Quantiles of printed tables, and the closed forms of one and two degrees of freedom.
TEST(Student, MeetsTables) {
  EXPECT_NEAR(student_quantile(0.975, 187.0), 1.9727, 1e-4);
  EXPECT_NEAR(student_quantile(0.975, 4.0), 2.776445, 1e-6);
  EXPECT_NEAR(student_quantile(0.05, 10.0), -1.812461, 1e-6);
  EXPECT_NEAR(student_quantile(0.975, 1e7), 1.959964, 1e-6);
  EXPECT_NEAR(student_cdf(1.7, 1.0), 0.5 + std::atan(1.7) / pi, 1e-13);
  EXPECT_NEAR(student_cdf(-1.7, 2.0), 0.5 - 1.7 / (2.0 * std::sqrt(2.0 + 1.7 * 1.7)), 1e-13);
}

/// A slab between a constant flux and a constant temperature: q b/k in the end, 2 q sqrt(alpha t/pi)/k at first.
TEST(SyntheticTransient, ContactIsASlab) {
  SyntheticTransient s = steel().measurement;
  s.insulation = kapton();
  const double flux = s.power / (2.0 * pi * s.radius * s.radius);
  const Insulation& slab = s.insulation;
  EXPECT_NEAR(contact_rise(s, 10.0), flux * slab.thickness / slab.conductivity, 1e-12);
  const double early = 1e-3 * slab.thickness * slab.thickness / slab.diffusivity;
  EXPECT_NEAR(contact_rise(s, early), 2.0 * flux * std::sqrt(slab.diffusivity * early / pi) / slab.conductivity, 1e-6);
}

}  // namespace
}  // namespace repose::thermal
