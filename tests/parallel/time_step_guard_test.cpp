// The criteria of the time step with the speeds that come to be: a warning, and the same error on all ranks.
#include "guard_samples.h"

namespace repose::test {
namespace {

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
  scene.run(20000);
  EXPECT_GT(scene.simulation().counters().rebuilds, 2);
  EXPECT_FALSE(scene.simulation().take_warning().has_value());
}

TEST(TimeStepGuard, WhatGoesOnTooFastIsWarnedOf) {
  const std::vector<Grain> grains = {{{0, 0, 0}, {0.1, 0, 0}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}};
  Scene before(at_hertz_limit(0.1), grains);
  Particles particles = before.simulation().particles();
  for (std::size_t i = 0; i < particles.owned; ++i) particles.record[i].velocity = 8.0 * particles.record[i].velocity;
  Scene after(at_hertz_limit(0.1), grains);
  after.simulation().restore(std::move(particles), before.simulation().contact_memory(),
                             before.simulation().left_here());
  const std::optional<std::string> warning = after.simulation().take_warning();
  ASSERT_TRUE(warning.has_value());
  expect_parts(*warning, {"0.8 m/s", "1.52 times", "expected 0.1 m/s"});
}

TEST(TimeStepGuard, WithinTheFractionItIsSilent) {
  Scene scene(at_hertz_limit(0.1), {{{0, 0, 0}, {0.1, 0, 0}, {}, radius}, {{0.5, 0, 0}, {}, {}, radius}});
  scene.run(20000);
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

// A grain that gathers speed on its way: warned of at a rebuild, an error in the step that is too fast.
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
