// Guards, exits, warnings and lists of a whole simulation, on all ranks.
#include <numeric>

#include <gtest/gtest.h>

#include "base/error.h"
#include "measurement/discharged_mass.h"
#include "measurement/state_hash.h"
#include "scene/sphere.h"
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

// At 40 m/s grains as soft as these go through one another: 4/15 E_eff sqrt(R_eff) d^2.5 x 2 = m_eff v^2 / 2 would need an
// overlap of more than a diameter.
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
  EXPECT_TRUE(warning.has_value());  // on every rank
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

// ---- leaving ----

std::int64_t inside(const Simulation& s) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < s.particles().owned; ++i) count += is_parked(s.particles().record[i]) ? 0 : 1;
  return s.comm().sum(count);
}

std::vector<std::int64_t> left(const Simulation& s) {
  std::vector<std::int64_t> count(s.left_here().particles.begin(), s.left_here().particles.end());
  s.comm().sum_elements(std::span(count));
  return count;
}

/// Two grains leave through each face, one after the other, and three stay.
std::vector<Grain> leavers() {
  std::vector<Grain> grains = {{{0, 0, 0}, {}, {}, radius}, {{0.02, 0, 0}, {}, {}, radius}, {{0, 0.02, 0}, {}, {}, radius}};
  const Vec3 ways[6] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (const Vec3& way : ways) {
    grains.push_back({0.049 * way, way, {}, radius});
    grains.push_back({0.044 * way, way, {}, 1.5 * radius});
  }
  return grains;
}

TEST(Exits, EveryFaceIsCountedAndNothingIsLost) {
  Deck deck = bare_deck({}, 1e-5);
  deck.domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  Scene scene(deck, leavers());
  Simulation& s = scene.simulation();
  for (int step = 0; step < 800; ++step) {
    scene.run(1);
    const std::vector<std::int64_t> gone = left(s);
    EXPECT_EQ(inside(s) + std::accumulate(gone.begin(), gone.end(), std::int64_t{0}), s.inserted()) << "step " << step;
    if (step == 300) {
      EXPECT_EQ(gone, (std::vector<std::int64_t>(6, 1)));
    }
  }
  EXPECT_EQ(left(s), (std::vector<std::int64_t>(6, 2)));
  EXPECT_EQ(inside(s), 3);

  const double mass = sphere_mass(radius, 3592.0);
  const double each = mass * (1.0 + 1.5 * 1.5 * 1.5);
  const double unit = s.mass_unit().kilograms(1);
  // All but what has left by the top counts as discharged; rounding: half a unit for each grain, 2^-53 of the sum.
  EXPECT_NEAR(discharged_mass(s.comm(), -1.0, s.materials(), s.mass_unit(), s.particles(), s.left_here()), 5.0 * each,
              20.0 * unit + 1e-15 * each);
  EXPECT_NEAR(total_mass(s.comm(), s.materials(), s.mass_unit(), s.particles(), s.left_here()), 5.0 * each + 3.0 * mass,
              20.0 * unit + 1e-15 * each);
}

// Grains that roll off the edge of the domain on an infinite floor, which passes through the place of the parked.
TEST(Exits, RollingOffAnInfiniteFloor) {
  Deck deck = bare_deck({}, 1e-5);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  deck.walls.push_back(floor_at(0.0));
  std::vector<Grain> grains;
  for (int k = 0; k < 10; ++k) grains.push_back({{0.048, -0.02 + 0.004 * k, radius}, {0.5, 0, 0}, {}, radius});
  for (int k = 0; k < 10; ++k) grains.push_back({{-0.03, -0.02 + 0.004 * k, radius}, {}, {}, radius});
  Scene scene(deck, grains);
  EXPECT_EQ(physics_error(scene, 1500), "");
  EXPECT_EQ(left(scene.simulation()), (std::vector<std::int64_t>{0, 10, 0, 0, 0, 0}));
  EXPECT_EQ(inside(scene.simulation()), 10);
}

// ---- lists ----

constexpr int rows = 8;

/// Rows in which a grain at 0.5 m/s hits one at rest, which then hits a third, 0.7 radii further on; far away grains at 2
/// m/s hit nothing. On several ranks the two groups are on different ones. `gap` m before the first collision.
std::vector<Grain> cradles_and_travellers(double gap) {
  std::vector<Grain> grains;
  const double r = 2.2e-4;
  for (int k = 0; k < rows; ++k) {
    const double y = 0.002 * k;
    grains.push_back({{-2.0 * r - gap, y, 0.0}, {0.5, 0.0, 0.0}, {}, r});
    grains.push_back({{0.0, y, 0.0}, {}, {}, r});
    grains.push_back({{2.7 * r, y, 0.0}, {}, {}, r});
  }
  for (int k = 0; k < 3 * rows; ++k) grains.push_back({{5.0, 0.002 * k, 0.0}, {2.0, 0.0, 0.0}, {}, r});
  return grains;
}

Coefficients elastic() {
  Coefficients c;
  c.youngs_modulus = 1e7;
  c.restitution_pp = 1.0;
  return c;
}

// While the travellers use up their inner skins every few steps, and new inner lists are made for all, the grains of the
// other rank must not get further than their outer skins unseen.
TEST(Lists, NoContactIsMissedBesideFasterGrainsElsewhere) {
  for (int phase = 0; phase < 10; ++phase) {  // of the first collision, between two rebuilds
    Scene scene(bare_deck(elastic(), 4e-6), cradles_and_travellers(2e-5 + 3e-5 * phase));
    scene.run(400);
    const std::vector<Grain> grains = scene.grains();
    for (std::size_t row = 0; row < rows; ++row) {
      // Equal elastic grains hand on their speed; what is lost to the discrete steps is far below 6 %.
      EXPECT_NEAR(grains[3 * row + 1].velocity.x, 0.0, 0.03) << "row " << row << ", phase " << phase;
      EXPECT_NEAR(grains[3 * row + 2].velocity.x, 0.5, 0.03) << "row " << row << ", phase " << phase;
    }
  }
}

std::string hash_of(const Simulation& s) { return state_hash(s.comm(), s.particles(), s.pairs(), s.wall_contacts()); }

TEST(Lists, SameBitsAsWithListsOfEverything) {
  Deck everything = bare_deck(elastic(), 4e-6);
  everything.neighbours.skin = 10.0;
  everything.neighbours.inner_skin = 5.0;
  for (int phase = 0; phase < 10; ++phase) {
    const std::vector<Grain> grains = cradles_and_travellers(2e-5 + 3e-5 * phase);
    Scene usual(bare_deck(elastic(), 4e-6), grains);
    Scene wide(everything, grains);
    usual.run(400);
    wide.run(400);
    EXPECT_EQ(hash_of(usual.simulation()), hash_of(wide.simulation())) << "phase " << phase;
  }
}

}  // namespace
}  // namespace repose::test
