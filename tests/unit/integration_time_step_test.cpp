// The time-step criteria against values worked out by hand, and what is said when they are violated.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "deck_error.h"
#include "integration/time_step.h"
#include "scene/particles/sphere_mass.h"

namespace repose::test {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

TEST(RayleighTime, ByHand) {
  // G = 1e7/2.5 = 4e6 Pa, sqrt(2500/4e6) = 0.025, 0.1631 x 0.25 + 0.8766 = 0.917375 (thesis eq. 2.24)
  EXPECT_NEAR(rayleigh_time(1e-3, {"m", 1e7, 0.25, 2500.0}), 7.853981633974e-5 / 0.917375, 1e-17);
}

TEST(HertzTime, ByHand) {
  // m^2 / (R E^2 v) = 1e-12 / (1e-3 x 1e12 x 0.1) = 1e-20, whose fifth root is 1e-4 (thesis eq. 2.25)
  EXPECT_NEAR(hertz_time(1e-3, 1e-6, 1e6, 0.1), 2.87e-4, 1e-18);
  EXPECT_NEAR(hertz_time(1e-3, 1e-6, 1e6, 3.2), 1.435e-4, 1e-18);  // 32 times the speed: half the time
}

Deck two_materials() {
  Deck deck;
  deck.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  deck.materials = {{"grain", 1e7, 0.25, 2500.0}, {"steel", 2e11, 0.3, 7800.0}};
  deck.pairs = {{{0.5, 0.5, 0.1}, {"grain", "grain"}}, {{0.5, 0.5, 0.1}, {"grain", "steel"}}};
  return deck;
}

struct Limits {
  double rayleigh;
  double hertz;
};

/// A grain of 1 mm among its like and at a wall of steel.
Limits limits_by_hand(const MaterialTable& materials, double speed) {
  const double mass = sphere_mass(1e-3, 2500.0);
  const double among = hertz_time(0.5e-3, 0.5 * mass, materials.pair(0, 0).youngs_modulus_eff, speed);
  const double at_wall = hertz_time(1e-3, mass, materials.pair(0, 1).youngs_modulus_eff, speed);
  return {rayleigh_time(1e-3, materials[0]), std::min(among, at_wall)};
}

TEST(ChooseTimeStep, TakesTheShorterCriterion) {
  Deck deck = two_materials();
  const MaterialTable materials(deck);
  const SmallestRadii radii{{1e-3, none}};
  const Limits limits = limits_by_hand(materials, 2.0);
  TimeStep step = choose_time_step(deck, materials, radii, 2.0);
  EXPECT_NEAR(step.rayleigh_limit, 0.20 * limits.rayleigh, 1e-18);
  EXPECT_NEAR(step.hertz_limit, 0.10 * limits.hertz, 1e-18);
  EXPECT_NEAR(step.hertz_limit_at_1, 0.10 * limits.hertz * std::pow(2.0, 0.2), 1e-18);
  EXPECT_EQ(step.speed, 2.0);
  EXPECT_EQ(step.step, std::min(step.rayleigh_limit, step.hertz_limit));

  deck.time.rayleigh_fraction = 1e-3;
  step = choose_time_step(deck, materials, radii, 2.0);
  EXPECT_EQ(step.criterion, "rayleigh");
  EXPECT_NEAR(step.step, 1e-3 * limits.rayleigh, 1e-20);
  deck.time.rayleigh_fraction = 1.0;
  step = choose_time_step(deck, materials, radii, 2.0);
  EXPECT_EQ(step.criterion, "hertz");
  EXPECT_NEAR(step.step, 0.10 * limits.hertz, 1e-18);
}

TEST(ChooseTimeStep, FindsTheWorstOfAllPairs) {
  Deck deck = two_materials();
  deck.pairs.push_back({{0.5, 0.5, 0.1}, {"steel", "steel"}});
  const MaterialTable materials(deck);
  const double r[2] = {1e-3, 0.4e-3};
  const double m[2] = {sphere_mass(r[0], 2500.0), sphere_mass(r[1], 7800.0)};
  double hertz = none;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      const double stiffness = materials.pair(a, b).youngs_modulus_eff;
      hertz = std::min(hertz, hertz_time(r[a] * r[b] / (r[a] + r[b]), m[a] * m[b] / (m[a] + m[b]), stiffness, 1.0));
      hertz = std::min(hertz, hertz_time(r[a], m[a], stiffness, 1.0));
    }
  }
  const TimeStep step = choose_time_step(deck, materials, {{r[0], r[1]}}, 1.0);
  EXPECT_NEAR(step.hertz_limit, 0.10 * hertz, 1e-18);
  EXPECT_NEAR(step.rayleigh_limit, 0.20 * rayleigh_time(r[1], materials[1]), 1e-18);
}

TEST(ChooseTimeStep, AcceptsAShortGivenStep) {
  Deck deck = two_materials();
  const MaterialTable materials(deck);
  deck.time.step = 1e-9;
  const TimeStep step = choose_time_step(deck, materials, {{1e-3, none}}, 1.0);
  EXPECT_EQ(step.step, 1e-9);
  EXPECT_EQ(step.criterion, "given");
}

std::string complaint(const Deck& deck, double speed) {
  return test::deck_error([&] { choose_time_step(deck, MaterialTable(deck), {{1e-3, none}}, speed); });
}

TEST(ChooseTimeStep, NamesTheLimitThatAGivenStepExceeds) {
  Deck deck = two_materials();
  const Limits limits = limits_by_hand(MaterialTable(deck), 2.0);
  const bool hertz_is_shorter = 0.10 * limits.hertz < 0.20 * limits.rayleigh;
  ASSERT_TRUE(hertz_is_shorter);
  deck.time.step = 0.11 * limits.hertz;
  std::string message = complaint(deck, 2.0);
  for (const char* part : {"time.step", "10 % of the Hertz time", "expected speed of 2 m/s"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
  deck.time.hertz_fraction = 1.0;
  deck.time.rayleigh_fraction = 0.01;
  deck.time.step = 0.0101 * limits.rayleigh;
  message = complaint(deck, 2.0);
  for (const char* part : {"time.step", "1 % of the Rayleigh time"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
  EXPECT_EQ(message.find("expected speed"), std::string::npos) << message;
  deck.time.step = 0.0099 * limits.rayleigh;
  EXPECT_EQ(complaint(deck, 2.0), "no error");
}

NewParticles at(const std::vector<Vec3>& positions) {
  NewParticles particles;
  particles.position = positions;
  particles.velocity.assign(positions.size(), Vec3{});
  return particles;
}

// The domain is a cube from -1 to 1.
TEST(ExpectedSpeed, IsFreeFallToTheFarSideOfTheDomain) {
  Deck deck = two_materials();
  deck.gravity = {0.0, 0.0, -10.0};
  EXPECT_NEAR(expected_speed(deck, at({{0.0, 0.0, -0.5}, {0.0, 0.0, 0.25}}), {}), 5.0, 1e-14);  // sqrt(2 x 10 x 1.25)
  deck.gravity = {10.0, 0.0, 0.0};
  EXPECT_NEAR(expected_speed(deck, at({{-0.25, 0.0, 0.9}, {0.5, 0.0, 0.0}}), {}), 5.0, 1e-14);
  deck.gravity = {6.0, 8.0, 0.0};  // 6 x 0.5 + 8 x 1.25 = 13
  EXPECT_NEAR(expected_speed(deck, at({{0.5, -0.25, 0.0}}), {}), std::sqrt(26.0), 1e-14);
}

TEST(ExpectedSpeed, AddsTheInitialMotionOfEachParticle) {
  Deck deck = two_materials();
  deck.gravity = {0.0, 0.0, -10.0};
  NewParticles particles = at({{0.0, 0.0, 0.25}, {0.0, 0.0, -1.0}});
  particles.velocity[0] = {0.0, 12.0, 0.0};
  EXPECT_NEAR(expected_speed(deck, particles, {}), 13.0, 1e-14);
  particles.velocity = {{}, {0.0, 12.0, 0.0}};  // that one is at the floor already
  EXPECT_NEAR(expected_speed(deck, particles, {}), 12.0, 1e-14);
}

TEST(ExpectedSpeed, InAnApparatusThatTiltsIsFreeFallAcrossTheDomain) {
  Deck deck = two_materials();
  deck.gravity = {0.0, 0.0, -10.0};
  Pour pour;
  pour.bounds = {{0.0, 0.0, -0.5}, {0.5, 0.5, 0.25}};
  EXPECT_NEAR(expected_speed(deck, {}, {pour}), 5.0, 1e-14);
  deck.tilt.enabled = true;
  const double fastest = std::sqrt(2.0 * 10.0 * std::sqrt(12.0));  // from corner to corner
  EXPECT_NEAR(expected_speed(deck, at({{0.0, 0.0, -0.5}}), {}), fastest, 1e-14);
  EXPECT_NEAR(expected_speed(deck, {}, {pour}), fastest, 1e-14);
}

TEST(ExpectedSpeed, IsNeverNothingAndMayBeGiven) {
  Deck deck = two_materials();
  deck.gravity = {};
  EXPECT_NEAR(expected_speed(deck, at({{0.0, 0.0, 0.0}}), {}), 1e-3, 1e-18);
  deck.time.expected_speed = 0.5;
  EXPECT_EQ(expected_speed(deck, at({{0.0, 0.0, 0.0}}), {}), 0.5);
}

TEST(TimeStepExcess, IsTheStepOverTheTighterLimit) {
  Deck deck = two_materials();
  deck.time.rayleigh_fraction = 1.0;
  const MaterialTable materials(deck);
  const TimeStep step = choose_time_step(deck, materials, {{1e-3, none}}, 2.0);
  ASSERT_EQ(step.criterion, "hertz");
  EXPECT_NEAR(time_step_excess(step, 2.0), 1.0, 1e-12);
  EXPECT_NEAR(time_step_excess(step, 64.0), 2.0, 1e-12);  // 32 times the speed
  const double at_rest = time_step_excess(step, 0.0);
  EXPECT_NEAR(at_rest, step.step / step.rayleigh_limit, 1e-12);
  EXPECT_LT(at_rest, 1.0);
}

TEST(HookeTime, ByHand) {
  EXPECT_NEAR(hooke_time(1e-6, 100.0, 2.0 / 7.0), 3.14159265358979e-4, 1e-17);  // pi sqrt(m / k_n)
  EXPECT_NEAR(hooke_time(1e-6, 100.0, 8.0 / 7.0), 1.57079632679490e-4, 1e-17);  // pi sqrt(2/7 m / k_t)
}

TEST(ChooseTimeStep, HookeHasItsOwnCriterion) {
  Deck deck = two_materials();
  deck.contact.normal_law = NormalLaw::hooke;
  deck.pairs[0].hooke_stiffness = 1e3;
  deck.pairs[1].hooke_stiffness = 4e3;  // at the wall: four times as stiff, twice the mass
  const MaterialTable materials(deck);
  const SmallestRadii radii{{1e-3, none}};
  TimeStep step = choose_time_step(deck, materials, radii, 2.0);
  const double shortest = hooke_time(sphere_mass(1e-3, 2500.0), 4e3, 2.0 / 7.0);
  EXPECT_EQ(step.criterion, "hooke");
  EXPECT_NEAR(step.step, 0.02 * shortest, 1e-18);
  EXPECT_EQ(step.rayleigh_limit, none);
  EXPECT_EQ(step.hertz_limit, none);
  EXPECT_NEAR(time_step_excess(step, 100.0), 1.0, 1e-12);  // at any speed
  deck.time.step = 0.021 * shortest;
  const std::string message = test::deck_error([&] { choose_time_step(deck, materials, radii, 2.0); });
  EXPECT_NE(message.find("is too long: 2 % of the Hooke time is"), std::string::npos) << message;
}

// A dashpot faster than the step would drive what it should brake.
TEST(ChooseTimeStep, AFastDashpotShortensIt) {
  Deck deck = two_materials();
  deck.contact.normal_law = NormalLaw::hooke;
  for (PairDeck& pair : deck.pairs) pair.hooke_stiffness = 1e3;
  deck.pairs[0].hooke_damping_rate = 1e6;
  deck.pairs[0].hooke_tangential_damping_rate = 5e5;  // times 7/2 for a sphere that turns
  const MaterialTable materials(deck);
  const SmallestRadii radii{{1e-3, none}};
  TimeStep step = choose_time_step(deck, materials, radii, 2.0);
  EXPECT_EQ(step.criterion, "damping");
  EXPECT_NEAR(step.step, 0.5 / 1.75e6, 1e-18);
  const double chosen = step.step;
  deck.time.step = 3.99 * chosen;
  EXPECT_EQ(choose_time_step(deck, materials, radii, 2.0).criterion, "given");
  deck.time.step = 4.01 * chosen;
  const std::string message = test::deck_error([&] { choose_time_step(deck, materials, radii, 2.0); });
  EXPECT_NE(message.find("twice the time in which the faster damping rate"), std::string::npos) << message;
  deck.pairs[0].hooke_tangential_damping_rate = 0.0;
  deck.time.step = unset;
  EXPECT_NEAR(choose_time_step(deck, MaterialTable(deck), radii, 2.0).step, 0.5 / 1e6, 1e-18);
}

TEST(ChooseTimeStep, WhereNothingMovesOneMustBeGiven) {
  Deck deck = two_materials();
  const MaterialTable materials(deck);
  const SmallestRadii nothing{{none, none}};
  EXPECT_THROW(choose_time_step(deck, materials, nothing, 2.0), DeckError);
  deck.time.step = 1e-5;
  EXPECT_EQ(choose_time_step(deck, materials, nothing, 2.0).step, 1e-5);
}

}  // namespace
}  // namespace repose::test
