#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/math.h"
#include "base/philox.h"

namespace repose {
namespace {

// Units in the last place between a double and the true value, known to more digits.
double ulps(double value, long double truth) {
  const double rounded = static_cast<double>(truth);
  const double ulp = std::nextafter(std::fabs(rounded), std::numeric_limits<double>::infinity()) - std::fabs(rounded);
  return static_cast<double>(std::fabs(static_cast<long double>(value) - truth)) / ulp;
}

double draw(std::uint64_t i, std::uint32_t k) { return uniform(7, i, RandomStream::insertion_jitter, k); }

TEST(LogReproducible, AgreesWithTheLibraryOverAllMagnitudes) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double x = std::ldexp(1.0 + draw(i, 0), static_cast<int>(2000.0 * draw(i, 1)) - 1000);
    worst = std::fmax(worst, ulps(log_reproducible(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LE(worst, 2.0);
}

TEST(LogReproducible, AgreesWithTheLibraryNearOneAndBelow) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double near_one = 1.0 + std::ldexp(draw(i, 0) - 0.5, -static_cast<int>(50.0 * draw(i, 1)));
    const double restitution = draw(i, 2) + 1e-6;
    worst = std::fmax(worst, ulps(log_reproducible(restitution), std::log(static_cast<long double>(restitution))));
    if (near_one == 1.0) continue;
    worst = std::fmax(worst, ulps(log_reproducible(near_one), std::log(static_cast<long double>(near_one))));
  }
  EXPECT_LE(worst, 2.0);
}

TEST(LogReproducible, IsExactWhereTheLogarithmIs) { EXPECT_EQ(log_reproducible(1.0), 0.0); }

TEST(ExpReproducible, AgreesWithTheLibrary) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double wide = 1400.0 * (draw(i, 0) - 0.5);
    const double narrow = std::ldexp(draw(i, 1) - 0.5, -static_cast<int>(50.0 * draw(i, 2)));
    for (const double x : {wide, narrow}) {
      worst = std::fmax(worst, ulps(exp_reproducible(x), std::exp(static_cast<long double>(x))));
    }
  }
  EXPECT_LE(worst, 2.0);
  EXPECT_EQ(exp_reproducible(0.0), 1.0);
}

TEST(FifthRoot, AgreesWithTheLibraryOverAllMagnitudes) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double x = std::ldexp(1.0 + draw(i, 0), static_cast<int>(2000.0 * draw(i, 1)) - 1000);
    worst = std::fmax(worst, ulps(fifth_root(x), std::pow(static_cast<long double>(x), 0.2L)));
  }
  EXPECT_LE(worst, 2.0);
}

TEST(FifthRoot, IsExactForFifthPowers) {
  EXPECT_EQ(fifth_root(1.0), 1.0);
  EXPECT_EQ(fifth_root(32.0), 2.0);
  EXPECT_EQ(fifth_root(243.0), 3.0);
  EXPECT_EQ(fifth_root(0x1p-50), 0x1p-10);
}

TEST(AtanReproducible, AgreesWithTheLibrary) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double x = std::ldexp(2.0 * draw(i, 0) - 1.0, static_cast<int>(200.0 * draw(i, 1)) - 100);
    const double near_one = 4.0 * (draw(i, 2) - 0.5);
    for (const double y : {x, near_one}) {
      worst = std::fmax(worst, ulps(atan_reproducible(y), std::atan(static_cast<long double>(y))));
    }
  }
  EXPECT_LE(worst, 2.0);
  EXPECT_EQ(atan_reproducible(0.0), 0.0);
  EXPECT_EQ(atan_reproducible(std::numeric_limits<double>::infinity()), 0.5 * pi);
  EXPECT_EQ(atan_reproducible(-std::numeric_limits<double>::infinity()), -0.5 * pi);
  EXPECT_EQ(atan_reproducible(-1.0), -atan_reproducible(1.0));
}

TEST(WholePower, MultipliesSoOften) {
  EXPECT_EQ(whole_power(3.0, 0.0), 1.0);
  EXPECT_EQ(whole_power(3.0, 5.0), 243.0);
  EXPECT_EQ(whole_power(2.0, 100.0), 0x1p100);
  EXPECT_NEAR(whole_power(1.0 + 1e-9, 1e9), 2.718281827, 1e-6);
  EXPECT_EQ(whole_power(2.0, 2e18), std::numeric_limits<double>::infinity());
}

TEST(SinCosReproducible, AgreesWithTheLibrary) {
  double worst = 0.0;     // ulps, where neither is near a zero beyond the first
  double greatest = 0.0;  // absolute error, anywhere
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double small = std::ldexp(2.0 * draw(i, 0) - 1.0, -static_cast<int>(40.0 * draw(i, 1)));
    const double large = 2e5 * (draw(i, 2) - 0.5);
    for (const double x : {small, large}) {
      const auto [sine, cosine] = sin_cos_reproducible(x);
      const long double true_sine = std::sin(static_cast<long double>(x));
      const long double true_cosine = std::cos(static_cast<long double>(x));
      greatest = std::fmax(greatest, static_cast<double>(std::fabs(sine - true_sine)));
      greatest = std::fmax(greatest, static_cast<double>(std::fabs(cosine - true_cosine)));
      if (x == small || std::fabs(true_sine) > 0.01) worst = std::fmax(worst, ulps(sine, true_sine));
      if (std::fabs(true_cosine) > 0.01) worst = std::fmax(worst, ulps(cosine, true_cosine));
    }
  }
  EXPECT_LE(worst, 2.0);
  EXPECT_LE(greatest, 2e-16);
}

TEST(SinCosReproducible, KnowsTheQuadrants) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const auto [sine, cosine] = sin_cos_reproducible(quarter * (pi / 2.0) + 0.3);
    EXPECT_NEAR(sine, std::sin(quarter * (pi / 2.0) + 0.3), 1e-15);
    EXPECT_NEAR(cosine, std::cos(quarter * (pi / 2.0) + 0.3), 1e-15);
  }
  EXPECT_EQ(sin_cos_reproducible(0.0).sine, 0.0);
  EXPECT_EQ(sin_cos_reproducible(0.0).cosine, 1.0);
}

}  // namespace
}  // namespace repose
