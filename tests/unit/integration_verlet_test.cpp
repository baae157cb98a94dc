// Velocity Verlet and the scales of the force sums against values worked out by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "contact/fixed_point.h"
#include "integration/velocity_verlet.h"
#include "scene/materials.h"
#include "scene/sphere.h"

namespace repose::test {
namespace {

/// One owned grain and one ghost; a unit of the force sum gives 2^-10 m/s2, one of the torque sum 2^-5 rad/s2.
Particles grain_and_ghost() {
  Particles p;
  p.record = {{{1.0, 2.0, 3.0}, 0.5, {0.5, 0.0, -0.25}, 1.0, {8.0, 0.0, 0.0}, 1.0},
              {{4.0, 5.0, 6.0}, 0.5, {1.0, 1.0, 1.0}, 1.0, {1.0, 1.0, 1.0}, 1.0}};
  p.id = {0, 1};
  p.material = {0, 0};
  p.owned = 1;
  p.force_to_acceleration = {0x1p-10};
  p.torque_to_acceleration = {0x1p-5};
  p.sum = {{{1024, -2048, 512, 0}, {64, -32, 0, 0}}, {{1024, 1024, 1024, 0}, {64, 64, 64, 0}}};
  return p;
}

// Powers of two throughout: exact.
TEST(VelocityVerlet, HalfAKick) {
  Particles p = grain_and_ghost();
  kick_half_step({0.0, 0.0, -8.0}, 0.5, p);
  EXPECT_EQ(p.record[0].velocity, (Vec3{0.5 + 0.25 * 1.0, 0.25 * -2.0, -0.25 + 0.25 * (0.5 - 8.0)}));
  EXPECT_EQ(p.record[0].spin, (Vec3{8.0 + 0.25 * 2.0, 0.25 * -1.0, 0.0}));
  EXPECT_EQ(p.record[0].position, (Vec3{1.0, 2.0, 3.0}));
  EXPECT_EQ(p.record[1].velocity, (Vec3{1.0, 1.0, 1.0}));
  EXPECT_EQ(p.record[1].spin, (Vec3{1.0, 1.0, 1.0}));
}

TEST(VelocityVerlet, Drift) {
  Particles p = grain_and_ghost();
  drift(0.5, p);
  EXPECT_EQ(p.record[0].position, (Vec3{1.25, 2.0, 2.875}));
  EXPECT_EQ(p.record[0].velocity, (Vec3{0.5, 0.0, -0.25}));
  EXPECT_EQ(p.record[1].position, (Vec3{4.0, 5.0, 6.0}));
}

// A constant acceleration is integrated exactly: x = v t + a t^2 / 2.
TEST(VelocityVerlet, FreeFallIsExact) {
  Particles p = grain_and_ghost();
  p.sum[0] = {};
  const double dt = 0x1p-7;
  for (int step = 0; step < 128; ++step) {
    kick_half_step({0.0, 0.0, -8.0}, dt, p);
    drift(dt, p);
    kick_half_step({0.0, 0.0, -8.0}, dt, p);
  }
  EXPECT_EQ(p.record[0].position, (Vec3{1.5, 2.0, 3.0 - 0.25 - 4.0}));
  EXPECT_EQ(p.record[0].velocity, (Vec3{0.5, 0.0, -8.25}));
}

MaterialTable soft_and_stiff() {
  Deck deck;
  deck.materials = {{"soft", 1e7, 0.25, 1000.0}, {"stiff", 4e9, 0.5, 2000.0}};
  deck.pairs = {{{"soft", "soft"}, 0.3, 0.1, 0.2}, {{"stiff", "soft"}, 1.0, 0.4, 0.5}};
  return MaterialTable(deck);
}

TEST(FixedPointScales, ArePowersOfTwoThatHoldTheGreatestForce) {
  const MaterialTable materials = soft_and_stiff();
  for (const double radius : {1e-5, 2.2e-4, 1e-3, 0.05}) {
    Particles p;
    p.record = {{{}, radius, {}, 0.0, {}, 0.0}};
    p.material = {0};
    p.owned = 1;
    set_fixed_point_scales(materials, 0.3, p);
    const double force_scale = p.record[0].force_scale;
    const double torque_scale = p.record[0].torque_scale;
    int exponent = 0;
    EXPECT_EQ(std::frexp(force_scale, &exponent), 0.5);
    EXPECT_EQ(std::frexp(torque_scale, &exponent), 0.5);
    // Hertz's force on a wall of the stiffest partner, at 0.3 of the radius, four times over: at least 50, below 51
    // bits
    const double stiffness = materials.pair(0, 1).youngs_modulus_eff;
    const double force = 4.0 * 4.0 / 3.0 * stiffness * std::sqrt(0.3) * 0.3 * radius * radius;
    for (const double most : {force * force_scale, force * radius * torque_scale}) {
      EXPECT_LT(most, 0x1p+51);
      EXPECT_GE(most, 0x1p+50 * (1.0 - 1e-12));
    }
    std::int64_t sum = 0;
    EXPECT_TRUE(add_fixed_point(to_fixed_point(force, force_scale), sum));
    EXPECT_NEAR(static_cast<double>(sum) * p.force_to_acceleration[0], force / sphere_mass(radius, 1000.0),
                1e-14 * force / sphere_mass(radius, 1000.0));
    const double inertia = 0.4 * sphere_mass(radius, 1000.0) * radius * radius;
    EXPECT_NEAR(p.torque_to_acceleration[0] * torque_scale * inertia, 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace repose::test
