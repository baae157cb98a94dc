// The guards of a whole simulation: the same error on all ranks, naming the culprits.
#include <gtest/gtest.h>

#include "base/error.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;

/// Runs until a PhysicsError; its message must be the same on all ranks. Empty when none comes.
std::string physics_error(Scene& scene, std::int64_t steps) {
  std::string message;
  try {
    scene.run(steps);
  } catch (const PhysicsError& error) {
    message = error.what();
  }
  std::string of_root = message;
  scene.simulation().comm().broadcast(of_root);
  EXPECT_EQ(message, of_root);
  return message;
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
  expect_parts(physics_error(scene, 1000), {"particle 17 and wall floor", "(0.3, 0.2, -0.0993", "guards.max_overlap"});
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
  EXPECT_TRUE(warning.has_value());                                                   // on every rank
  expect_parts(warning.value_or(""), {"0.8 m/s", "1.52 times", "expected 0.1 m/s"});  // 8^(1/5) = 1.516
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
  expect_parts(message, {"step 0", "3.3 m/s", "time.expected_speed"});  // 33^(1/5) = 2.01
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

}  // namespace
}  // namespace repose::test
