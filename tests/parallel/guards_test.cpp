// The guards of a whole simulation: the same error on all ranks, naming the culprits.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "contact/hertz.h"
#include "scene/sphere.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;

/// Runs until a PhysicsError; its message must be the same on all ranks. Empty when none comes.
template <class Work>
std::string physics_error_of(const Work& work) {
  std::string message;
  try {
    work();
  } catch (const PhysicsError& error) {
    message = error.what();
  }
  std::string of_root = message;
  Communicator(MPI_COMM_WORLD).broadcast(of_root);
  EXPECT_EQ(message, of_root);
  return message;
}
std::string physics_error(Scene& scene, std::int64_t steps) {
  return physics_error_of([&] { scene.run(steps); });
}
/// The same, the set-up included.
std::string physics_error(const Deck& deck, const std::vector<Grain>& grains, std::int64_t steps) {
  return physics_error_of([&] {
    Scene scene(deck, grains);
    scene.simulation().begin_phase("only");
    scene.run(steps);
  });
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
  }
}

/// Grains at rest, far apart, so that every rank owns some.
std::vector<Grain> bystanders(int count) {
  std::vector<Grain> grains;
  for (int k = 0; k < count; ++k) grains.push_back({{0.02 * k, 0.5, 0.01 * (k % 3)}, {}, {}, radius});
  return grains;
}

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
  const ContactGeometry contact = {.normal = {},
                                   .overlap = overlap,
                                   .radius_eff = 0.5 * radius,
                                   .mass_eff = sphere_mass(radius, c.density),
                                   .normal_velocity = 0.0,
                                   .tangential_velocity = {},
                                   .rolling_velocity = {},
                                   .velocity_normal = {}};
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

TEST(Guards, AGrainWithTooManyTouchesIsNamed) {
  Deck deck = bare_deck({}, 1e-6);
  for (int w = 0; w < 17; ++w) {
    const double angle = 0.3 * w;
    WallDeck wall = floor_at(0.0);
    wall.name = "wall " + std::to_string(w);
    wall.normal = {std::cos(angle), std::sin(angle), 0.0};
    wall.point = {0.95 * radius * wall.normal.x, 0.95 * radius * wall.normal.y, 0.0};
    deck.walls.push_back(wall);
  }
  expect_parts(physics_error(deck, {{{0.0, 0.0, 0.0}, {}, {}, radius}}, 2),
               {"step 0: particle 0 at (0, 0, 0) touches walls in more than 16 places"});
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

/// A lone pair of approaching grains whose step is just within the Hertz criterion at `expected` m/s.
Deck at_hertz_limit(double expected) {
  Deck deck = bare_deck({}, unset);
  deck.time.expected_speed = expected;
  deck.time.rayleigh_fraction = 1.0;  // out of the way
  return deck;
}

TEST(TimeStepGuard, BeyondTheFractionItWarnsOnce) {
  Scene scene(at_hertz_limit(0.1), {{{0, 0, 0}, {0.8, 0, 0}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}});
  EXPECT_EQ(scene.simulation().time_step().criterion, "hertz");
  const std::optional<std::string> warning = scene.simulation().take_warning();
  EXPECT_TRUE(warning.has_value());  // on every rank
  expect_parts(warning.value_or(""),
               {"step 0: particle 0 at (0, 0, 0)", "0.8 m/s", "1.52 times", "expected 0.1 m/s"});  // 8^(1/5) = 1.516
  scene.run(2000);
  EXPECT_GT(scene.simulation().counters().rebuilds, 2);
  EXPECT_FALSE(scene.simulation().take_warning().has_value());
}

TEST(TimeStepGuard, WithinTheFractionItIsSilent) {
  Scene scene(at_hertz_limit(0.1), {{{0, 0, 0}, {0.1, 0, 0}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}});
  scene.run(2000);
  EXPECT_GT(scene.simulation().counters().rebuilds, 2);
  EXPECT_FALSE(scene.simulation().take_warning().has_value());
}

TEST(TimeStepGuard, BeyondTwiceTheFractionItStops) {
  std::string message;
  try {
    Scene scene(at_hertz_limit(0.1), {{{0, 0, 0}, {3.3, 0, 0}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}});
  } catch (const PhysicsError& error) {
    message = error.what();
  }
  expect_parts(message, {"step 0: particle 0 at (0, 0, 0)", "3.3 m/s", "time.expected_speed"});  // 33^(1/5) = 2.01
}

// A grain that gathers speed on its way: the criteria are looked at again at the rebuilds.
TEST(TimeStepGuard, GatheringSpeedIsNoticed) {
  Deck deck = at_hertz_limit(0.1);
  deck.gravity = {0.0, 0.0, -100.0};
  Scene scene(deck, {{{0, 0, 0}, {}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}});
  const double dt = scene.simulation().time_step().step;
  const std::string message = physics_error(scene, static_cast<std::int64_t>(0.05 / dt));  // to 5 m/s
  expect_parts(message, {"time.expected_speed", "times its criterion"});
  EXPECT_TRUE(scene.simulation().take_warning().has_value());
  const double speed = 100.0 * scene.simulation().time();
  EXPECT_GT(speed, 3.2);  // 2^5 times the expected speed
  EXPECT_LT(speed, 4.5);
}

/// One grain per 2 ms, which enters downwards at `speed` m/s, with a time step for 0.1 m/s.
Deck pour_at(double speed, double gravity) {
  Deck deck = at_hertz_limit(0.1);
  deck.gravity = {0.0, 0.0, -gravity};
  ParticlesDeck pour;
  pour.type = ParticlesType::pour;
  pour.material = "grain";
  pour.diameter = 2.0 * radius;
  pour.count = 20;
  pour.region = RegionShape::disc;
  pour.radius = 10.0 * radius;
  pour.particle_rate = 500.0;
  pour.interval = 2e-3;
  pour.velocity = {0.0, 0.0, -speed};
  deck.particles = {pour};
  return deck;
}

TEST(TimeStepGuard, GrainsThatComeInTooFastStopIt) {
  Deck deck = pour_at(3.3, 0.0);
  const std::vector<Grain> one = {{{0.5, 0, 0}, {}, {}, radius}};
  const std::string message = physics_error(deck, one, 1000);
  expect_parts(message,
               {": particle 0 at (", "moves at 3.3 m/s", "2.01 times its criterion", "time.expected_speed to 3.3"});
  EXPECT_EQ(message.find("step 0:"), std::string::npos) << message;
  EXPECT_EQ(physics_error(pour_at(0.1, 0.0), one, 1000), "");
}

TEST(TimeStepGuard, GrainsThatFallAfterTheyCameInStopIt) {
  const std::string message = physics_error(pour_at(0.1, 300.0), {{{0.5, 0, 0}, {0, 0, 0}, {}, radius}}, 1000);
  expect_parts(message, {": particle ", " at (", "times its criterion", "time.expected_speed"});
}

}  // namespace
}  // namespace repose::test
