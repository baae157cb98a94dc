// The rebound of binary collisions is the given coefficient of restitution, with every normal law.
#include <cmath>

#include <gtest/gtest.h>

#include "integration/time_step.h"
#include "scene/particles/sphere_mass.h"
#include "support/contact_options.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double speed = 0.1;
constexpr double radius = 1e-3;
constexpr double density = 3592.0;
constexpr int steps_per_contact = 5000;

Deck collision_deck(NormalLaw law, bool attraction, double restitution) {
  Coefficients c;
  c.restitution_pp = restitution;
  c.restitution_pw = restitution;
  Deck deck = bare_deck(c, unset);
  if (law == NormalLaw::hooke) deck = with_hooke(deck);
  deck.contact.attraction = attraction;
  return deck;
}

/// The step, such that an undamped impact takes steps_per_contact of them.
double step_for(const Deck& deck, double radius_eff, double mass_eff) {
  const MaterialTable materials(deck);
  const PairParameters& pair = materials.pair(0, 0);  // that of the wall has the same stiffness
  const double time =
      deck.contact.normal_law == NormalLaw::hooke
          ? hooke_time(mass_eff, pair.coefficients.hooke_stiffness, pair.coefficients.hooke_tangential_ratio)
          : hertz_time(radius_eff, mass_eff, pair.youngs_modulus_eff, speed);
  return time / steps_per_contact;
}

/// The surfaces meet in the middle of a step: there a damped force that sets in with a jump is of second order in the
/// step; elsewhere it makes an error of up to zeta pi / steps_per_contact, 7e-4.
double gap(double dt) { return 10.5 * speed * dt; }

double rebound_between_grains(Deck deck, double other_radius) {
  const double m = sphere_mass(radius, density);
  const double m_other = sphere_mass(other_radius, density);
  deck.time.step = step_for(deck, radius * other_radius / (radius + other_radius), m * m_other / (m + m_other));
  const double apart = radius + other_radius + gap(deck.time.step);
  Scene scene(deck,
              {{{0, 0, 0}, {0, 0, 0.3 * speed}, {}, radius}, {{0, 0, apart}, {0, 0, -0.7 * speed}, {}, other_radius}});
  scene.run(4 * steps_per_contact);
  const std::vector<Grain> g = scene.grains();
  EXPECT_GT(g[1].position.z - g[0].position.z, radius + other_radius);  // they have parted
  return (g[1].velocity.z - g[0].velocity.z) / speed;
}

double rebound_from_wall(Deck deck) {
  deck.time.step = step_for(deck, radius, sphere_mass(radius, density));
  deck.walls.push_back(floor_at(0.0));
  Scene scene(deck, {{{0, 0, radius + gap(deck.time.step)}, {0, 0, -speed}, {}, radius}});
  scene.run(4 * steps_per_contact);
  EXPECT_GT(scene.grains()[0].position.z, radius);
  return scene.grains()[0].velocity.z / speed;
}

TEST(Restitution, ComesBackFromBinaryCollisions) {
  for (const NormalLaw law : {NormalLaw::hertz, NormalLaw::hooke}) {
    for (const bool attraction : {true, false}) {
      for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
        SCOPED_TRACE(testing::Message() << (law == NormalLaw::hooke ? "hooke" : "hertz") << ", attraction "
                                        << attraction << ", e = " << e);
        const Deck deck = collision_deck(law, attraction, e);
        EXPECT_NEAR(rebound_between_grains(deck, 0.4 * radius), e, 1e-4);
        EXPECT_NEAR(rebound_from_wall(deck), e, 1e-4);
      }
    }
  }
}

TEST(Restitution, WithoutAttractionNothingPulls) {
  Deck deck = collision_deck(NormalLaw::hooke, false, 0.2);
  deck.time.step = step_for(deck, radius, sphere_mass(radius, density));
  deck.walls.push_back(floor_at(0.0));
  Scene scene(deck, {{{0, 0, radius + gap(deck.time.step)}, {0, 0, -speed}, {}, radius}});
  double before = -speed;
  for (int part = 0; part < 200; ++part) {
    scene.run(4 * steps_per_contact / 200);
    const double now = scene.grains()[0].velocity.z;
    EXPECT_GE(now, before - 1e-12 * speed);  // rounding of the half kicks
    before = now;
  }
  EXPECT_GT(before, 0.0);
}

}  // namespace
}  // namespace repose::test
