// Impacts against closed forms: Chung and Ooi 2011 (doi:10.1007/s10035-011-0277-0), tests 1 to 4 and 7.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "scene/particles/sphere_mass.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

struct Impact {
  double peak_overlap = 0.0;
  double peak_force = 0.0;
  double contact_time = 0.0;
};

/// Runs until the contact is over. `gap` tells the distance of the surfaces from the grains, `speed` the approach speed
/// of the first grain, whose mass is `mass`.
template <class Gap>
Impact follow_impact(Scene& scene, double dt, double mass, Gap&& gap) {
  Impact impact;
  std::int64_t touching = 0;
  Vec3 velocity = scene.grains()[0].velocity;
  for (int step = 0; step < 1000000; ++step) {
    scene.run(1);
    const std::vector<Grain> grains = scene.grains();
    const double overlap = -gap(grains);
    if (overlap > 0.0) {
      ++touching;
      impact.peak_overlap = std::max(impact.peak_overlap, overlap);
      impact.peak_force = std::max(impact.peak_force, mass * norm(grains[0].velocity - velocity) / dt);
    } else if (touching > 0) {
      break;
    }
    velocity = grains[0].velocity;
  }
  impact.contact_time = static_cast<double>(touching) * dt;
  return impact;
}

TEST(ChungOoi, Test1TwoElasticSpheres) {
  Coefficients c{48e9, 0.2, 2800.0, 1.0, 1.0, 0.35, 0.35, 0.0, 0.0};
  const double dt = 4e-9;
  const double r = 0.01;
  Scene scene(bare_deck(c, dt), {{{-r - 1e-6, 0, 0}, {10, 0, 0}, {}, r}, {{r + 1e-6, 0, 0}, {-10, 0, 0}, {}, r}});
  const Impact impact = follow_impact(scene, dt, sphere_mass(r, c.density), [&](const std::vector<Grain>& g) {
    return norm(g[0].position - g[1].position) - 2.0 * r;
  });
  EXPECT_NEAR(impact.peak_overlap, 274.11e-6, 0.01e-6);
  EXPECT_NEAR(impact.peak_force, 10696.9, 0.5);
  EXPECT_NEAR(impact.contact_time, 40.34e-6, 0.01e-6);
}

TEST(ChungOoi, Test2SphereOnRigidPlane) {
  Coefficients c{70e9, 0.3, 2699.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0};
  const double dt = 1e-7;
  const double r = 0.1;
  Deck deck = bare_deck(c, dt);
  deck.materials[1].youngs_modulus = 1e22;  // rigid
  deck.walls.push_back(floor_at(0.0));
  Scene scene(deck, {{{0, 0, r + 1e-6}, {0, 0, -0.2}, {}, r}});
  const Impact impact = follow_impact(scene, dt, sphere_mass(r, c.density),
                                      [&](const std::vector<Grain>& g) { return g[0].position.z - r; });
  EXPECT_NEAR(impact.peak_overlap, 49.72e-6, 0.01e-6);
  EXPECT_NEAR(impact.peak_force, 11369.9, 0.5);
  EXPECT_NEAR(impact.contact_time, 731.66e-6, 0.2e-6);
}

/// One grain of alumina onto a rigid plane at `angle` degrees from its normal, 3.9 m/s; the grain after the impact.
Grain after_impact(double restitution, double angle) {
  Coefficients c{380e9, 0.23, 4000.0, restitution, restitution, 0.092, 0.092, 0.0, 0.0};
  const double r = 0.0025;
  Deck deck = bare_deck(c, 2e-9);
  deck.materials[1].youngs_modulus = 1e22;
  deck.time.expected_speed = 4.0;
  deck.walls.push_back(floor_at(0.0));
  const double radians = angle * 3.141592653589793 / 180.0;
  const Vec3 v = {3.9 * std::sin(radians), 0.0, -3.9 * std::cos(radians)};
  Scene scene(deck, {{{0, 0, r + 1e-9}, v, {}, r}});
  bool touched = false;
  for (int step = 0; step < 100000; ++step) {
    scene.run(1);
    const bool touches = scene.grains()[0].position.z < r;
    if (touched && !touches) break;
    touched |= touches;
  }
  EXPECT_TRUE(touched);
  return scene.grains()[0];
}

TEST(ChungOoi, Test3ReboundRatioIsTheGivenRestitution) {
  for (const double e : {0.1, 0.3, 0.5, 0.6, 0.8, 0.9, 1.0}) {
    EXPECT_NEAR(after_impact(e, 0.0).velocity.z / 3.9, e, 1e-3) << "e = " << e;
  }
  EXPECT_LT(std::fabs(after_impact(0.0, 0.0).velocity.z) / 3.9, 2e-2);  // it need not part
}

TEST(ChungOoi, Test4ObliqueImpactWhileSliding) {
  const double e = 0.98;
  const double mu = 0.092;
  for (const double angle : {30.0, 50.0, 80.0}) {
    const double radians = angle * 3.141592653589793 / 180.0;
    const Grain g = after_impact(e, angle);
    const double v_n = 3.9 * std::cos(radians);
    EXPECT_NEAR(g.velocity.x / (3.9 * std::sin(radians)), 1.0 - mu * (1.0 + e) / std::tan(radians), 2e-3) << angle;
    const double spin = 2.5 * mu * (1.0 + e) * v_n / 0.0025;
    EXPECT_NEAR(g.spin.y, spin, 1e-2 * spin) << angle;
  }
}

TEST(ChungOoi, Test4FollowsTheMeasuredTangentialRestitution) {
  // Kharaz, Gorham and Salman 2001 (doi:10.1016/S0032-5910(01)00283-2): angle in degrees, tangential restitution
  const double measured[][2] = {{9.63, 0.673},  {20.08, 0.596}, {30.22, 0.688},
                                {39.30, 0.772}, {49.55, 0.847}, {59.84, 0.902}};
  for (const auto& [angle, ratio] : measured) {
    const double v_t = 3.9 * std::sin(angle * 3.141592653589793 / 180.0);
    EXPECT_NEAR(after_impact(0.98, angle).velocity.x / v_t, ratio, 0.06) << angle;
  }
}

TEST(ChungOoi, Test7SymmetricSpinIsKept) {
  Coefficients c{48e9, 0.2, 2800.0, 1.0, 1.0, 0.35, 0.35, 0.0, 0.0};
  const double r = 0.01;
  const Vec3 spin = {0.0, 0.0, 40.0};
  Scene scene(bare_deck(c, 2e-8),
              {{{-r - 1e-6, 0, 0}, {10, 0, 0}, spin, r}, {{r + 1e-6, 0, 0}, {-10, 0, 0}, -spin, r}});
  scene.run(4000);
  for (const Grain& g : scene.grains()) {
    EXPECT_GT(norm(g.position), r + 1e-6);  // they have parted
    EXPECT_NEAR(std::fabs(g.spin.z), 40.0, 1e-9);
    EXPECT_NEAR(g.velocity.y, 0.0, 1e-9);
    EXPECT_NEAR(g.velocity.z, 0.0, 1e-9);
  }
}

TEST(Pairs, KeepTheirMomentum) {
  Coefficients c;
  const double r = 0.00022;
  Scene scene(bare_deck(c, 1e-6), {{{0, 0, 0}, {0.1, 0.05, 0}, {20, -35, 50}, r},
                                   {{4.5e-4, 1e-4, 5e-5}, {-0.12, 0.01, 0.02}, {-60, 10, 5}, r}});
  const auto momentum = [&] {
    const std::vector<Grain> g = scene.grains();
    return g[0].velocity + g[1].velocity;
  };
  const Vec3 before = momentum();
  const Vec3 velocity_before = scene.grains()[0].velocity;
  scene.run(3000);
  EXPECT_GT(norm(scene.grains()[0].velocity - velocity_before), 0.05);  // they have collided
  EXPECT_LT(norm(momentum() - before), 1e-12);
}

}  // namespace
}  // namespace repose::test
