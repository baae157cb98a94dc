#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/insertion/grain_sizes.h"
#include "scene/particles/sphere_mass.h"
#include "scene/sizes/size_distribution.h"
#include "scene/sizes/size_report.h"

namespace repose {
namespace {

constexpr double density = 2500.0;
const char* const sieves = "diameter_um,cumulative_mass\n200,0\n300,12\n400,40\n550,85\n700,100\n";

ParticlesDeck block(SizesType type, Weighting by) {
  ParticlesDeck deck;
  SizesDeck& s = deck.sizes;
  s.enabled = true;
  s.type = type;
  s.by = by;
  s.median = 400e-6;
  s.geometric_deviation = 1.4;
  s.scale = 450e-6;
  s.shape = 3.0;
  s.min_diameter = 200e-6;
  s.max_diameter = 700e-6;
  if (type == SizesType::classes) {
    s.diameters = {250e-6, 400e-6, 600e-6};
    s.shares = {20, 50, 30};
  }
  return deck;
}

SizeDistribution distribution(const ParticlesDeck& deck) {
  return make_size_distribution(
      deck, [](const std::string&) { return sieves; }, "block");
}

/// Share of the mass below a diameter, as the deck says it, by the library's functions.
double lognormal_below(const SizesDeck& s, double d) {
  const auto below = [&](double x) {
    return 0.5 * std::erfc(-std::log(x / s.median) / std::log(s.geometric_deviation) / std::sqrt(2.0));
  };
  return (below(d) - below(s.min_diameter)) / (below(s.max_diameter) - below(s.min_diameter));
}
double weibull_below(const SizesDeck& s, double d) {
  const auto above = [&](double x) { return std::exp(-std::pow(x / s.scale, s.shape)); };
  return (above(s.min_diameter) - above(d)) / (above(s.min_diameter) - above(s.max_diameter));
}

// 2000 bins of 0.06 % width each, straight inside: a quantile is off by less than a tenth of a bin.
constexpr double bin_error = 1e-4 * 700e-6;

TEST(SizeDistribution, MassQuantilesInvertTheLawByMass) {
  const ParticlesDeck lognormal = block(SizesType::lognormal, Weighting::mass);
  const ParticlesDeck weibull = block(SizesType::weibull, Weighting::mass);
  for (const double u : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    EXPECT_NEAR(lognormal_below(lognormal.sizes, distribution(lognormal).mass_quantile(u)), u, 1e-6);
    EXPECT_NEAR(weibull_below(weibull.sizes, distribution(weibull).mass_quantile(u)), u, 1e-6);
  }
}

TEST(SizeDistribution, QuantilesInvertTheLawByNumber) {
  const ParticlesDeck lognormal = block(SizesType::lognormal, Weighting::number);
  const ParticlesDeck weibull = block(SizesType::weibull, Weighting::number);
  for (const double u : {0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    EXPECT_NEAR(lognormal_below(lognormal.sizes, distribution(lognormal).quantile(u)), u, 1e-6);
    EXPECT_NEAR(weibull_below(weibull.sizes, distribution(weibull).quantile(u)), u, 1e-6);
  }
}

// Hatch and Choate 1929: a distribution lognormal by mass is lognormal by number, of the same deviation, with the
// median divided by exp(3 ln^2 sigma). Ends far out.
TEST(SizeDistribution, LognormalByMassIsLognormalByNumber) {
  ParticlesDeck by_mass = block(SizesType::lognormal, Weighting::mass);
  by_mass.sizes.min_diameter = 20e-6;
  by_mass.sizes.max_diameter = 4e-3;
  ParticlesDeck by_number = by_mass;
  const double sigma = std::log(by_mass.sizes.geometric_deviation);
  by_number.sizes.by = Weighting::number;
  by_number.sizes.median *= std::exp(-3.0 * sigma * sigma);
  const SizeDistribution a = distribution(by_mass);
  const SizeDistribution b = distribution(by_number);
  for (const double u : {0.01, 0.1, 0.5, 0.9, 0.99}) {
    EXPECT_NEAR(a.quantile(u), b.quantile(u), bin_error);
    EXPECT_NEAR(a.mass_quantile(u), b.mass_quantile(u), bin_error);
  }
  EXPECT_NEAR(a.mean(), by_number.sizes.median * std::exp(0.5 * sigma * sigma), bin_error);
  EXPECT_NEAR(a.mean_volume() / (pi / 6.0 * std::pow(by_number.sizes.median, 3) * std::exp(4.5 * sigma * sigma)), 1.0,
              1e-5);
}

TEST(SizeDistribution, UniformInClosedForm) {
  const SizeDistribution by_number = distribution(block(SizesType::uniform, Weighting::number));
  EXPECT_DOUBLE_EQ(by_number.quantile(0.25), 325e-6);
  EXPECT_DOUBLE_EQ(by_number.mean(), 450e-6);
  EXPECT_NEAR(by_number.mass_quantile(0.5), std::pow(0.5 * (std::pow(200.0, 4) + std::pow(700.0, 4)), 0.25) * 1e-6,
              1e-18);
  const SizeDistribution by_mass = distribution(block(SizesType::uniform, Weighting::mass));
  EXPECT_DOUBLE_EQ(by_mass.mass_quantile(0.25), 325e-6);
  const double below_300 = (std::pow(2.0, -2) - std::pow(3.0, -2)) / (std::pow(2.0, -2) - std::pow(7.0, -2));
  EXPECT_NEAR(by_mass.quantile(below_300), 300e-6, 1e-18);
}

TEST(SizeDistribution, ClassesByMassAreRarerTheLarger) {
  const SizeDistribution d = distribution(block(SizesType::classes, Weighting::mass));
  const double n[] = {20 / std::pow(2.5, 3), 50 / std::pow(4.0, 3), 30 / std::pow(6.0, 3)};
  const double total = n[0] + n[1] + n[2];
  EXPECT_EQ(d.quantile(0.999 * n[0] / total), 250e-6);
  EXPECT_EQ(d.quantile(1.001 * n[0] / total), 400e-6);
  EXPECT_EQ(d.quantile(1.001 * (n[0] + n[1]) / total), 600e-6);
  EXPECT_EQ(d.mass_quantile(0.19), 250e-6);
  EXPECT_EQ(d.mass_quantile(0.69), 400e-6);
}

TEST(SizeDistribution, TableKeepsItsCurveAndCanBeCut) {
  ParticlesDeck deck = block(SizesType::csv, Weighting::mass);
  deck.sizes.min_diameter = deck.sizes.max_diameter = unset;
  EXPECT_NEAR(distribution(deck).mass_quantile(0.40), 400e-6, 1e-18);
  EXPECT_NEAR(distribution(deck).mass_quantile(0.625), 475e-6, 1e-18);
  deck.sizes.min_diameter = 250e-6;
  deck.sizes.max_diameter = 550e-6;
  const SizeDistribution cut = distribution(deck);
  EXPECT_EQ(cut.smallest(), 250e-6);
  EXPECT_EQ(cut.largest(), 550e-6);
  EXPECT_NEAR(cut.mass_quantile(6.0 / 79.0), 300e-6, 1e-18);
  deck.sizes.min_diameter = 800e-6;
  deck.sizes.max_diameter = unset;
  EXPECT_THROW(distribution(deck), DeckError);
}

TEST(SizeDistribution, NothingBetweenTheEndsIsAnError) {
  ParticlesDeck deck = block(SizesType::lognormal, Weighting::mass);
  deck.sizes.geometric_deviation = 1.001;
  deck.sizes.min_diameter = 600e-6;
  EXPECT_THROW(distribution(deck), DeckError);
}

/// Standard error of a share of the mass in a sample: of a ratio of two sums.
double share_error(const std::vector<double>& radii, const SizeClass& c, double share) {
  double squares = 0.0;
  double total = 0.0;
  for (const double r : radii) {
    const double volume = r * r * r;
    const bool inside = c.from == c.to ? 2.0 * r == c.to : 2.0 * r > c.from && 2.0 * r <= c.to;
    squares += std::pow(volume * ((inside ? 1.0 : 0.0) - share), 2);
    total += volume;
  }
  return std::sqrt(squares) / total;
}

TEST(RealisedSizes, AgreeWithinTheSamplingErrorForEveryType) {
  for (const SizesType type :
       {SizesType::classes, SizesType::lognormal, SizesType::weibull, SizesType::uniform, SizesType::csv}) {
    for (const Weighting by : {Weighting::mass, Weighting::number}) {
      ParticlesDeck deck = block(type, by);
      deck.count = 20000;
      const SizeDistribution asked = distribution(deck);
      const std::vector<double> radii = draw_radii(deck, asked, density, 17, 1, "block");
      ASSERT_EQ(radii.size(), 20000U);
      const SizeReport report = report_sizes("block", asked, radii);
      ASSERT_EQ(report.classes.size(), type == SizesType::classes ? 3U : 10U);
      double squares = 0.0;
      for (const double r : radii) squares += std::pow(2.0 * r - asked.mean(), 2);
      const double mean_error = std::sqrt(squares) / 20000.0;
      EXPECT_LT(std::fabs(report.realised.mean - report.asked.mean), 4.0 * mean_error) << static_cast<int>(type);
      for (std::size_t k = 0; k < report.classes.size(); ++k) {
        const double share = report.asked.mass_shares[k];
        EXPECT_LT(std::fabs(report.realised.mass_shares[k] - share), 4.0 * share_error(radii, report.classes[k], share))
            << static_cast<int>(type) << " class " << k;
      }
      // d50 lies where its share of the mass, known to the error of one half, is 0.5
      const double half_error = share_error(radii, {0.0, report.asked.d50}, 0.5);
      EXPECT_GE(report.realised.d50, asked.mass_quantile(0.5 - 4.0 * half_error));
      EXPECT_LE(report.realised.d50, asked.mass_quantile(0.5 + 4.0 * half_error));
    }
  }
}

TEST(RealisedSizes, MassIsExactToHalfAParticle) {
  ParticlesDeck deck = block(SizesType::lognormal, Weighting::mass);
  deck.mass = 1e-4;
  const std::vector<double> radii = draw_radii(deck, distribution(deck), density, 0, 1, "block");
  double mass = 0.0;
  for (const double r : radii) mass += sphere_mass(r, density);
  EXPECT_LE(std::fabs(mass - 1e-4), 0.5 * sphere_mass(350e-6, density));
  deck.mass = 1e-12;
  EXPECT_THROW(draw_radii(deck, distribution(deck), density, 0, 1, "block"), DeckError);
}

TEST(RealisedSizes, ASizeBelongsToItsNumber) {
  ParticlesDeck deck = block(SizesType::weibull, Weighting::mass);
  deck.count = 100;
  const std::vector<double> from_0 = draw_radii(deck, distribution(deck), density, 0, 1, "block");
  const std::vector<double> from_10 = draw_radii(deck, distribution(deck), density, 10, 1, "block");
  EXPECT_EQ(from_0[10], from_10[0]);
  EXPECT_EQ(from_0[99], from_10[89]);
  EXPECT_NE(from_0[10], draw_radii(deck, distribution(deck), density, 10, 2, "block")[0]);
}

}  // namespace
}  // namespace repose
