// A single grain on a plane: sliding, rolling, holding. Closed forms of rigid-body mechanics.
#include <cmath>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double g = 9.81;
constexpr double radius = 0.00022;

/// A grain at rest on the floor z = 0 under gravity tilted by atan(slope) towards +x; the overlap carries its weight.
Scene grain_on_plane(const Coefficients& c, double slope, const Vec3& velocity, const Vec3& spin) {
  Deck deck = bare_deck(c, 1e-6);
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  deck.gravity = {g * slope * cosine, 0.0, -g * cosine};
  deck.walls.push_back(floor_at(0.0));
  const double e_eff = c.youngs_modulus / (2.0 * (1.0 - c.poisson_ratio * c.poisson_ratio));
  const double mass = c.density * 4.0 / 3.0 * 3.141592653589793 * radius * radius * radius;
  const double overlap = std::pow(mass * g * cosine / (4.0 / 3.0 * e_eff * std::sqrt(radius)), 2.0 / 3.0);
  return Scene(deck, {{{0.0, 0.0, radius - overlap}, velocity, spin, radius}});
}

TEST(Rolling, SlidingBallRollsAtFiveSeventhsOfItsSpeed) {
  Coefficients c;
  c.sliding_pw = 0.3;
  c.rolling_pw = 0.0;
  const double u0 = 0.05;
  const double roll_time = 2.0 * u0 / (7.0 * c.sliding_pw * g);
  Scene scene = grain_on_plane(c, 0.0, {u0, 0.0, 0.0}, {});
  scene.run(100);  // at the very start the dashpot brakes beyond Coulomb's limit, as the law has it
  const double u1 = scene.grains()[0].velocity.x;
  scene.run(2000);
  const double u2 = scene.grains()[0].velocity.x;
  EXPECT_NEAR((u1 - u2) / 0.002, c.sliding_pw * g, 1e-3 * c.sliding_pw * g);  // it slides
  scene.run(static_cast<std::int64_t>(2.0 * roll_time / 1e-6));
  const Grain ball = scene.grains()[0];
  EXPECT_NEAR(ball.velocity.x, 5.0 / 7.0 * u0, 1e-3 * u0);
  EXPECT_NEAR(ball.spin.y * radius, 5.0 / 7.0 * u0, 1e-3 * u0);
}

TEST(Rolling, SaturatedRollingMomentDeceleratesByFiveSeventhsMuRG) {
  Coefficients c;
  const double u0 = 0.05;
  Scene scene = grain_on_plane(c, 0.0, {u0, 0.0, 0.0}, {0.0, u0 / radius, 0.0});
  scene.run(5000);  // past the build-up of the springs
  const double u1 = scene.grains()[0].velocity.x;
  scene.run(20000);
  const double u2 = scene.grains()[0].velocity.x;
  const double deceleration = 5.0 / 7.0 * c.rolling_pw * g;
  EXPECT_NEAR((u1 - u2) / 0.02, deceleration, 0.01 * deceleration);
}

TEST(Rolling, HoldsOnASlopeBelowTheRollingFriction) {
  Coefficients c;
  Scene scene = grain_on_plane(c, 0.9 * c.rolling_pw, {}, {});
  scene.run(300000);
  EXPECT_LT(std::fabs(scene.grains()[0].position.x), 0.02 * radius);  // the give of the springs
}

TEST(Rolling, RollsDownASlopeAboveTheRollingFriction) {
  Coefficients c;
  const double slope = 1.5 * c.rolling_pw;
  Scene scene = grain_on_plane(c, slope, {}, {});
  scene.run(20000);
  const double u1 = scene.grains()[0].velocity.x;
  scene.run(100000);
  const double u2 = scene.grains()[0].velocity.x;
  const double acceleration = 5.0 / 7.0 * g * (slope - c.rolling_pw) / std::sqrt(1.0 + slope * slope);
  EXPECT_NEAR((u2 - u1) / 0.1, acceleration, 0.01 * acceleration);
}

/// Two triangles in the plane z = 0.
const char* const belt_stl = R"(solid belt
facet normal 0 0 1
outer loop
vertex -0.01 -0.01 0
vertex 0.02 -0.01 0
vertex 0.02 0.01 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex -0.01 -0.01 0
vertex 0.02 0.01 0
vertex -0.01 0.01 0
endloop
endfacet
endsolid belt
)";

/// A grain laid on a floor whose surface runs; 2/7 of its speed is where sliding ends: m v = mu m g t, I w = mu m g R
/// t, v + w R = V.
TEST(Conveyor, TakesALaidBallToTwoSeventhsOfItsSpeed) {
  Coefficients c;
  c.sliding_pw = 0.3;
  c.rolling_pw = 0.0;
  const double speed = 0.05;
  for (const bool is_mesh : {false, true}) {
    SCOPED_TRACE(is_mesh);
    Deck deck = bare_deck(c, 1e-6);
    deck.gravity = {0.0, 0.0, -g};
    WallDeck belt = floor_at(0.0);
    if (is_mesh) {
      belt.type = WallType::mesh;
      belt.file = "belt.stl";
    }
    MotionDeck motion;
    motion.type = MotionType::conveyor;
    motion.velocity = {0.6 * speed, 0.0, 0.8 * speed};
    motion.phases = {"runs"};
    belt.motions.push_back(motion);
    deck.walls.push_back(belt);
    Scene scene(deck, {{{0.0, 0.0, radius}, {}, {}, radius}}, best_vector_level(), {{"belt.stl", belt_stl}});
    EXPECT_FALSE(scene.simulation().walls()[0].travels);
    scene.simulation().begin_phase("rests");
    scene.run(5000);
    EXPECT_EQ(scene.grains()[0].velocity.x, 0.0);
    scene.simulation().begin_phase("runs");
    scene.run(20000);
    const Grain ball = scene.grains()[0];
    EXPECT_NEAR(ball.velocity.x, 2.0 / 7.0 * speed, 1e-3 * speed);  // the speed along the belt, not its x
    EXPECT_NEAR(ball.velocity.x + radius * -ball.spin.y, speed, 1e-3 * speed);
    EXPECT_NEAR(ball.position.z, radius, 0.01 * radius);
    scene.simulation().begin_phase("rests");
    scene.run(20000);
    EXPECT_NEAR(scene.grains()[0].velocity.x, 0.0, 1e-3 * speed);  // as it has taken its spin, it gives it back
  }
}

}  // namespace
}  // namespace repose::test
