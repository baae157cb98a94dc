// The guards of a whole simulation: the same error on all ranks, naming the culprits.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "contact/hertz.h"
#include "guard_samples.h"
#include "scene/particles/sphere_mass.h"

namespace repose::test {
namespace {

// At 40 m/s grains as soft as these go through one another: 4/15 E_eff sqrt(R_eff) d^2.5 x 2 = m_eff v^2 / 2 would need
// an overlap of more than a diameter.
TEST(Guards, GrainsShotAtEachOtherAreNamed) {
  Deck deck = bare_deck({}, 1e-6);
  deck.time.expected_speed = 40.0;
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.1, 0.25, 0.0}, {20.0, 0.0, 0.0}, {}, radius});
  grains.push_back({{0.1021, 0.25, 0.0}, {-20.0, 0.0, 0.0}, {}, radius});
  Scene scene(deck, grains);
  const std::string message = physics_error(scene, 1000);
  // 0.1 mm of gap and 0.3 mm of overlap, at 40 m/s: step 10 or 11
  const bool in_time = message.find("step 10:") == 0 || message.find("step 11:") == 0;
  EXPECT_TRUE(in_time) << message;
  expect_parts(message, {"particles 17 and 18", "(0.1002", "0.25", "guards.max_overlap = 0.30", "time.step"});
}

TEST(Guards, AWallHitTooHardIsNamed) {
  Deck deck = bare_deck({}, 1e-6);
  deck.time.expected_speed = 40.0;
  deck.walls.push_back(floor_at(-0.1));
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.3, 0.2, -0.0989}, {0.0, 0.0, -40.0}, {}, radius});
  Scene scene(deck, grains);
  expect_parts(physics_error(scene, 1000),
               {"particle 17 is pressed through wall floor", "(0.3, 0.2, -0.0993", "guards.max_overlap"});
}

/// A ceiling that comes down at 1 m/s on a grain, number 17, that lies on a floor.
Deck press() {
  Deck deck = bare_deck({}, 1e-6);
  deck.walls = {floor_at(-0.1), floor_at(-0.098)};
  deck.walls[1].name = "ram";
  MotionDeck down;
  down.velocity = {0.0, 0.0, -1.0};
  deck.walls[1].motions = {down};
  return deck;
}

// The overlaps at both walls grow alike, to 0.3 mm after 0.6 mm of way: 600 steps.
TEST(Guards, AGrainPressedThroughAWallIsNamed) {
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.3, 0.2, -0.099}, {}, {}, radius});
  const std::string message = physics_error(press(), grains, 1000);
  expect_parts(message,
               {": particle 17 is pressed through wall ", "they overlap by 0.30 of its radius at (0.3, 0.2, -0.099"});
  EXPECT_NEAR(std::stoi("0" + message.substr(std::min<std::size_t>(5, message.size()))), 600, 20) << message;
}

// Held particles are not stopped by any force.
TEST(Guards, AGrainPushedThroughAWallByAHeldBallIsNamed) {
  Deck deck = bare_deck({}, 1e-6);
  deck.walls = {floor_at(-0.1)};
  ParticlesDeck ball;
  ball.type = ParticlesType::csv;
  ball.file = "ball.csv";
  MotionDeck down;
  down.velocity = {0.0, 0.0, -1.0};
  ball.motions = {down};
  deck.particles = {ball};
  const std::string message = physics_error_of([&] {
    Scene scene(deck, {{{0.3, 0.2, -0.099}, {}, {}, radius}}, best_vector_level(),
                {{"ball.csv", "x,y,z,radius,material\n0.3,0.2,-0.088,0.01,grain\n"}});
    scene.simulation().begin_phase("only");
    scene.run(1000);
  });
  expect_parts(message, {"overlap by 0.30 of"});
  const bool named = message.find("particle 1 is pressed through wall floor") != std::string::npos ||
                     message.find("particles 0 and 1 overlap") != std::string::npos;
  EXPECT_TRUE(named) << message;
}

/// A wall as thin as any.
WallDeck disc_at(double height) {
  WallDeck disc = floor_at(height);
  disc.name = "disc";
  disc.type = WallType::disc;
  disc.centre = {0.3, 0.2, height};
  disc.radius = 0.01;
  return disc;
}

// At 2.5 radii per step a grain can be on one side of a disc and then on the other.
TEST(Guards, AGrainShotThroughADiscIsNamed) {
  Deck deck = bare_deck({}, 1e-6);
  deck.time.expected_speed = 2500.0;
  deck.walls = {disc_at(-0.1)};
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.3, 0.2, -0.09875}, {0.0, 0.0, -2500.0}, {}, radius});
  expect_parts(physics_error(deck, grains, 10),
               {"step 0: particle 17 from (0.3, 0.2, -0.09625)", "moves at 2.5e+03 m/s",
                "2.5 of its radius in one step", "shorten time.step to 1.0e-07 s"});
}

// 0.2 mm per step and step: 0.1, 0.3 and then 0.5 mm in one step, which is the bound.
TEST(Guards, AGrainThatGathersTooMuchSpeedIsNamedBeforeItGoesThrough) {
  Deck deck = bare_deck({}, 1e-6);
  deck.gravity = {0.0, 0.0, -2e8};
  deck.time.expected_speed = 2500.0;
  deck.walls = {disc_at(-0.01)};
  expect_parts(physics_error(deck, {{{0.3, 0.2, 0.0}, {}, {}, radius}}, 100),
               {"step 3: particle 0 from (0.3, 0.2, -0.0004)", "moves at 500 m/s", "0.5 of its radius"});
}

// With the first step it would be beyond the domain, where it must not count as one that has left.
TEST(Guards, AGrainThatFliesOutOfTheDomainInOneStepHasNotLeft) {
  Deck deck = bare_deck({}, 1e-6);
  deck.gravity = {0.0, 0.0, -1e15};
  expect_parts(physics_error(deck, bystanders(17), 3), {"step 1: particle ", "from (", "moves at 5e+08 m/s"});
}

TEST(Guards, AVelocityThatOverflowsIsNamed) {
  Deck deck = bare_deck({}, 1e-6);
  deck.gravity = {0.0, 0.0, -1e308};
  expect_parts(physics_error(deck, {{{0.3, 0.2, 0.1}, {}, {}, radius}}, 3),
               {"step 1: particle 0 last listed at (0.3, 0.2, 0.1)", "a position that is not finite"});
  deck.gravity = {0.0, 0.0, -1e304};
  deck.domain = {{-1e305, -1e305, -1e305}, {1e305, 1e305, 1e305}};
  expect_parts(physics_error(deck, bystanders(3), 3), {"step 1: particle ", "not finite, or too large to be squared"});
}

// It touches nothing, so only a look at all particles can find it.
TEST(Guards, ASpinBeyondMeasureIsNamed) {
  std::vector<Grain> grains = bystanders(17);
  grains[11].spin = {0.0, 1e200, 0.0};
  expect_parts(physics_error(bare_deck({}, 1e-6), grains, 3),
               {"step 0: particle 11 at (0.22, 0.5, 0.02) has a spin that is not finite"});
}

// At 60 m/s each the dashpots press with more than four times the force of the springs at the greatest overlap, long
// before that is reached.
TEST(Guards, AForceBeyondTheFixedPointRangeIsNamed) {
  Coefficients dead;
  dead.restitution_pp = dead.restitution_pw = 0.01;
  Deck deck = bare_deck(dead, 1e-7);
  deck.time.expected_speed = 120.0;
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.1, 0.25, 0.0}, {60.0, 0.0, 0.0}, {}, radius});
  grains.push_back({{0.10201, 0.25, 0.0}, {-60.0, 0.0, 0.0}, {}, radius});
  expect_parts(physics_error(deck, grains, 100), {"step ", "the contact force of particles 17 and 18 at (0.1",
                                                  "fixed-point", "particle 17 moves at", "time.step"});
  grains.pop_back();
  grains.back() = {{0.3, 0.2, -0.09899}, {0.0, 0.0, -120.0}, {}, radius};
  deck.walls = {floor_at(-0.1)};
  expect_parts(physics_error(deck, grains, 100),
               {"step ", "the contact force of particle 17 and wall floor at (0.3, 0.2, -0.09", "fixed-point"});
}

// 2600 held grains at one place, which one grain runs into: each contact presses with 0.85 of what one may, and all
// together with more than half of what the sum holds, 2048 times that.
TEST(Guards, ASumOfForcesThatComesNearItsRangeIsNamed) {
  constexpr int held = 2600;
  Coefficients c;
  c.restitution_pp = 0.05;
  Deck deck = bare_deck(c, 2.5e-6);
  const MaterialTable materials(deck);
  const PairParameters& pair = materials.pair(0, 0);
  int exponent = 0;  // of four times the greatest force
  std::frexp(4.0 * materials.greatest_force(0, radius, 0.3 * radius), &exponent);
  const double overlap = 0.05 * radius;
  ContactGeometry contact = {};
  contact.overlap = overlap;
  contact.radius_eff = 0.5 * radius;
  contact.mass_eff = sphere_mass(radius, c.density);
  const ContactStiffness k = hertz_stiffness(pair, contact, contact_radius(contact));
  const double speed = (0.85 * std::ldexp(1.0, exponent) - k.normal * overlap) / k.normal_damping;
  deck.time.expected_speed = speed;
  ParticlesDeck block;
  block.type = ParticlesType::csv;
  block.file = "held.csv";
  block.fixed = true;
  deck.particles = {block};
  std::string csv = "x,y,z,radius,material\n";
  for (int n = 0; n < held; ++n) csv += "0,0,0,0.001,grain\n";
  const double start = 2.0 * radius - overlap + speed * deck.time.step;  // touches after the first step
  ASSERT_GT(start, 2.0 * radius);
  const std::string message = physics_error_of([&] {
    Scene scene(deck, {{{start, 0.0, 0.0}, {-speed, 0.0, 0.0}, {}, radius}}, best_vector_level(), {{"held.csv", csv}});
    scene.run(3);
  });
  expect_parts(message, {"step 1: the forces on particle 2600 at (0.00195, 0, 0)",
                         "more than half of what their fixed-point sum"});
}

/// Seventeen walls at so many radii from the origin.
std::vector<WallDeck> walls_around(double radii) {
  std::vector<WallDeck> walls;
  for (int w = 0; w < 17; ++w) {
    const double angle = 0.3 * w;
    WallDeck wall = floor_at(0.0);
    wall.name = "wall " + std::to_string(w);
    wall.normal = {std::cos(angle), std::sin(angle), 0.0};
    wall.point = radii * radius * wall.normal;
    walls.push_back(wall);
  }
  return walls;
}

TEST(Guards, AGrainWithTooManyTouchesIsNamed) {
  const std::vector<Grain> grain = {{{0.0, 0.0, 0.0}, {}, {}, radius}};
  const std::vector<std::string> named = {"step 0: particle 0 at (0, 0, 0) touches walls in more than 16 places"};
  Deck deck = bare_deck({}, 1e-6);
  deck.walls = walls_around(0.95);
  expect_parts(physics_error(deck, grain, 2), named);
  deck.walls = walls_around(1.05);
  EXPECT_EQ(physics_error(deck, grain, 2), "");
  deck.contact.cohesion = Cohesion::capillary;  // the bridges break at 0.1 mm
  deck.pairs[1].surface_tension = 0.07;
  deck.pairs[1].bridge_volume = 1e-12;
  expect_parts(physics_error(deck, grain, 2), named);
}

TEST(Guards, AWallThatMovesTooFarInAStepIsRefused) {
  Deck deck = press();
  deck.time.expected_speed = 500.0;
  deck.walls[1].motions[0].velocity = {0.0, 0.0, -501.0};
  std::string message;
  try {
    const Scene scene(deck, bystanders(2));
  } catch (const DeckError& error) {
    message = error.what();
  }
  expect_parts(message, {"wall \"ram\"", "0.000501 m", "0.5 of the smallest radius 0.001 m", "shorten time.step"});
  deck.walls[1].motions[0].velocity.z = -499.0;
  EXPECT_NO_THROW(Scene(deck, bystanders(2)));
}

TEST(Guards, HealthyCollisionsPass) {
  Deck deck = bare_deck({}, 1e-6);
  std::vector<Grain> grains = bystanders(17);
  grains.push_back({{0.1, 0.25, 0.0}, {0.5, 0.0, 0.0}, {}, radius});
  grains.push_back({{0.1021, 0.25, 0.0}, {-0.5, 0.0, 0.0}, {}, radius});
  Scene scene(deck, grains);
  EXPECT_EQ(physics_error(scene, 1000), "");
  EXPECT_LT(scene.grains()[17].velocity.x, -0.1);  // they did bounce
}

}  // namespace
}  // namespace repose::test
