// Friction of a small grain that trembles on a large one, by both integrators (arXiv:2410.14798).
#include <cmath>

#include <gtest/gtest.h>

#include "contact/pair_loop.h"
#include "integration/velocity_verlet.h"
#include "neighbours/pair_lists.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double large = 5e-3;
constexpr double small = 5e-4;  // a tenth
constexpr double dt = 1e-6;
constexpr int steps_per_cycle = 64;
constexpr int cycles = 2000;
constexpr double omega = 2.0 * 3.141592653589793 / (steps_per_cycle * dt);
constexpr double amplitude = 2e-6;
constexpr double overlap = 20e-6;  // at rest
constexpr double apart = large + small - overlap;

/// A small grain on a fixed large one, moved to and fro along a straight line at 45 degrees to the normal, with the
/// half-step velocities of that path: the spring along the line's tangent after `cycles` closed cycles.
double spring_after_trembling(Integrator integrator, TangentialSpring spring) {
  Coefficients c;
  c.sliding_pp = 1e9;  // it sticks
  Deck deck = bare_deck(c, dt);
  deck.time.integrator = integrator;
  deck.contact.tangential_spring = spring;
  const MaterialTable materials(deck);
  Particles p;
  p.record = {ParticleRecord{{0, 0, apart}, small, {}, 0.0, {}, 0.0},
              ParticleRecord{{0, 0, 0}, large, {}, 0.0, {}, 0.0}};
  p.id = {0, 1};
  p.material = {0, 0};
  p.owned = 2;
  set_fixed_point_scales(materials, 0.3, p);
  add_lane_dummies(p);
  std::vector<ContactBlock> block(1);
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    block[0].first[lane] = lane == 0 ? 0 : 2;
    block[0].second[lane] = lane == 0 ? 1 : 3;
    set_history(block[0], lane, {});
  }
  std::vector<ForceSum> sums(p.record.size(), ForceSum{});
  Vec3 before = p.record[0].position;
  for (int step = 1; step <= cycles * steps_per_cycle; ++step) {
    const double s = amplitude * std::sin(omega * dt * step) * std::sqrt(0.5);
    p.record[0].position = {s, 0.0, apart + s};
    p.record[0].velocity = (1.0 / dt) * (p.record[0].position - before);
    before = p.record[0].position;
    evaluate_pairs(best_vector_level(), block, materials.pair(0, 0), dt, 0.3, p.record.data(), sums.data());
    std::fill(sums.begin(), sums.end(), ForceSum{});
  }
  return history(block[0], 0).spring.x;
}

/// Per unit of time -dt <v_n v_t> / (2 r) (docs/theory.md), here with <v_n v_t> = (amplitude omega)^2 / 4.
double drift_of_the_plain_scheme() {
  return -0.125 * dt / apart * amplitude * amplitude * omega * omega * cycles * steps_per_cycle * dt;
}

TEST(VelocityVerlet, StretchesTheSpringOfATremblingGrain) {
  for (const TangentialSpring spring : {TangentialSpring::projected, TangentialSpring::rotated}) {
    const double drift = spring_after_trembling(Integrator::velocity_verlet, spring);
    std::cout << "  velocity_verlet: " << drift << " m, theory " << drift_of_the_plain_scheme() << " m\n";
    EXPECT_NEAR(drift / drift_of_the_plain_scheme(), 1.0, 0.01);
  }
}

TEST(SynchronisedVerlet, LeavesItAlone) {
  for (const TangentialSpring spring : {TangentialSpring::projected, TangentialSpring::rotated}) {
    const double drift = spring_after_trembling(Integrator::synchronised_verlet, spring);
    std::cout << "  synchronised_verlet: " << drift << " m\n";
    EXPECT_LT(std::fabs(drift), 1e-3 * std::fabs(drift_of_the_plain_scheme()));
  }
}

}  // namespace
}  // namespace repose::test
