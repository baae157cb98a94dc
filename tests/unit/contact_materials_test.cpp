// The pair table against its definitions.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/particles/damping.h"
#include "scene/particles/materials.h"

namespace repose::test {
namespace {

TEST(DampingRatio, FollowsItsDefinition) {
  for (int k = 1; k < 100; ++k) {
    const double e = 0.01 * k;
    const double log_e = std::log(e);
    EXPECT_NEAR(damping_ratio(e), log_e / std::sqrt(log_e * log_e + 9.869604401089358), 1e-15) << e;
  }
  EXPECT_NEAR(damping_ratio(0.5), -0.2154537, 1e-7);  // ln 2 = 0.6931472 over 3.2171506
}

TEST(DampingRatio, HasItsLimits) {
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_EQ(damping_ratio(0.0), -1.0);
  EXPECT_GT(damping_ratio(1e-300), -1.0);
  EXPECT_LT(damping_ratio(1e-300), -0.99);
}

Deck two_materials() {
  Deck deck;
  deck.materials = {{"soft", 1e7, 0.25, 1000.0}, {"stiff", 4e7, 0.5, 2000.0}};
  deck.pairs = {{{0.3, 0.1, 0.2}, {"soft", "soft"}}, {{1.0, 0.4, 0.5}, {"stiff", "soft"}}};
  return deck;
}

TEST(MaterialTable, EffectiveModuliByHand) {
  const MaterialTable table(two_materials());
  // 1/E_eff = 0.9375/1e7 + 0.75/4e7 = 1.125e-7; 1/G_eff = 2 x 1.75 x 1.25/1e7 + 2 x 1.5 x 1.5/4e7 = 5.5e-7
  EXPECT_NEAR(table.pair(0, 1).youngs_modulus_eff, 1.0 / 1.125e-7, 1e-8);
  EXPECT_NEAR(table.pair(0, 1).shear_modulus_eff, 1.0 / 5.5e-7, 1e-8);
  EXPECT_NEAR(table.pair(0, 1).tangential_damping_ratio, std::sqrt(4.0 * 1.125 / 5.5), 1e-15);
  EXPECT_NEAR(table.pair(0, 0).youngs_modulus_eff, 0.5e7 / 0.9375, 1e-8);
}

TEST(MaterialTable, IsSymmetricButForTheDensities) {
  const MaterialTable table(two_materials());
  const PairParameters& ab = table.pair(0, 1);
  const PairParameters& ba = table.pair(1, 0);
  EXPECT_EQ(ab.youngs_modulus_eff, ba.youngs_modulus_eff);
  EXPECT_EQ(ab.shear_modulus_eff, ba.shear_modulus_eff);
  EXPECT_EQ(ab.tangential_damping_ratio, ba.tangential_damping_ratio);
  for (const PairParameters* pair : {&ab, &ba}) {
    EXPECT_EQ(pair->damping_ratio, 0.0);
    EXPECT_EQ(pair->sliding_friction, 0.4);
    EXPECT_EQ(pair->rolling_friction, 0.5);
  }
  EXPECT_EQ(ab.density_first, 1000.0);
  EXPECT_EQ(ab.density_second, 2000.0);
  EXPECT_EQ(ba.density_first, 2000.0);
  EXPECT_EQ(ba.density_second, 1000.0);
}

TEST(DampingWithoutAttraction, SolvesTheClosedForm) {
  for (const double e : {0.05, 0.1, 0.135, 0.136, 0.2, 0.5, 0.9, 0.999}) {
    const double zeta = -damping_ratio_without_attraction(e);
    const double loss = zeta < 1.0 ? 2.0 * zeta * std::acos(zeta) / std::sqrt(1.0 - zeta * zeta)
                                   : 2.0 * zeta * std::acosh(zeta) / std::sqrt(zeta * zeta - 1.0);
    EXPECT_NEAR(std::exp(-loss), e, 1e-13) << e;  // ill-conditioned near zeta = 1, in acos
    EXPECT_GT(zeta, -damping_ratio(e)) << e;      // the pull that is cut has slowed the rebound
  }
  EXPECT_EQ(damping_ratio_without_attraction(1.0), 0.0);
  EXPECT_NEAR(damping_ratio_without_attraction(std::exp(-2.0)), -1.0, 1e-13);  // critical
}

TEST(MaterialTable, KnowsTheGreatestForce) {
  Deck deck = two_materials();
  const MaterialTable hertz(deck);
  const double stiffest = hertz.pair(0, 1).youngs_modulus_eff;  // 4/3 E_eff sqrt(R delta) delta
  EXPECT_NEAR(hertz.greatest_force(0, 1e-3, 4e-5), 4.0 / 3.0 * stiffest * 2e-4 * 4e-5, 1e-15 * stiffest);
  EXPECT_EQ(hertz.index_of("stiff"), 1);
  deck.contact.normal_law = NormalLaw::hooke;
  deck.contact.attraction = false;
  for (PairDeck& pair : deck.pairs) {
    pair.hooke_stiffness = 1000.0;
    pair.restitution = 0.1;
  }
  const double zeta = -damping_ratio_without_attraction(0.1);
  EXPECT_GT(zeta, 1.1);
  EXPECT_NEAR(MaterialTable(deck).greatest_force(0, 1e-3, 4e-5), zeta * 0.04, 1e-15);
}

}  // namespace
}  // namespace repose::test
