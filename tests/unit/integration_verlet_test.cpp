// Velocity Verlet and the scales of the force sums against values worked out by hand.
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "deck/deck.h"
#include "integration/velocity_verlet.h"
#include "scene/particles/materials.h"
#include "scene/particles/sphere_mass.h"
#include "support/draw.h"
#include "support/fixed_point_sum.h"
#include "support/levels.h"

namespace repose::test {
namespace {

/// One owned grain and one ghost; a unit of the force sum gives 2^-10 m/s2, one of the torque sum 2^-5 rad/s2.
Particles grain_and_ghost() {
  Particles p;
  p.record = {{{1.0, 2.0, 3.0}, 0.5, {0.5, 0.0, -0.25}, 1.0, {8.0, 0.0, 0.0}, 1.0},
              {{4.0, 5.0, 6.0}, 0.5, {1.0, 1.0, 1.0}, 1.0, {1.0, 1.0, 1.0}, 1.0}};
  p.id = {0, 1};
  p.material = {0, 0};
  p.owned = 1;
  p.force_to_acceleration = {0x1p-10};
  p.torque_to_acceleration = {0x1p-5};
  p.sum = {{{1024, -2048, 512, 0}, {64, -32, 0, 0}}, {{1024, 1024, 1024, 0}, {64, 64, 64, 0}}};
  return p;
}

const DomainDeck domain = {{-100.0, -100.0, -100.0}, {100.0, 100.0, 100.0}};
const std::vector<Mark> here = {{{1.0, 2.0, 3.0}, 1.0}};  // a skin of 1 m
std::array<std::int32_t, 1> room;                         // for who has moved by it

bool same_bits(const ParticleRecord& a, const ParticleRecord& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Powers of two throughout: exact.
TEST(VelocityVerlet, SecondHalfIsHalfAKick) {
  for (const VectorLevel level : levels_here()) {
    Particles p = grain_and_ghost();
    step_second_half(level, {0.0, 0.0, -8.0}, 0.5, p);
    const ParticleRecord expected = {{1.0, 2.0, 3.0},
                                     0.5,
                                     {0.5 + 0.25 * 1.0, 0.25 * -2.0, -0.25 + 0.25 * (0.5 - 8.0)},
                                     1.0,
                                     {8.0 + 0.25 * 2.0, 0.25 * -1.0, 0.0},
                                     1.0};
    EXPECT_TRUE(same_bits(p.record[0], expected));
    EXPECT_TRUE(same_bits(p.record[1], grain_and_ghost().record[1]));
  }
}

TEST(VelocityVerlet, FirstHalfKicksDriftsAndClearsAllSums) {
  for (const VectorLevel level : levels_here()) {
    Particles kicked = grain_and_ghost();
    step_second_half(level, {0.0, 0.0, -8.0}, 0.5, kicked);
    Particles p = grain_and_ghost();
    step_first_half(level, {0.0, 0.0, -8.0}, 0.5, domain, here, room, p);
    EXPECT_EQ(p.record[0].velocity, kicked.record[0].velocity);
    EXPECT_EQ(p.record[0].spin, kicked.record[0].spin);
    EXPECT_EQ(p.record[0].position, (Vec3{1.0, 2.0, 3.0} + 0.5 * kicked.record[0].velocity));
    EXPECT_EQ(p.record[0].radius, 0.5);
    EXPECT_TRUE(same_bits(p.record[1], grain_and_ghost().record[1]));
    for (const ForceSum& sum : p.sum) {
      for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(sum.force[axis] | sum.torque[axis], 0);
    }
  }
}

TEST(VelocityVerlet, OnePassForTwoHalvesGivesTheSameBits) {
  test::Draw draw(71);
  for (const VectorLevel level : levels_here()) {
    for (int trial = 0; trial < 100; ++trial) {
      Particles two = grain_and_ghost();
      two.record[0].velocity = draw.vector(1.0);
      two.record[0].spin = draw.vector(100.0);
      for (int axis = 0; axis < 3; ++axis) {
        two.sum[0].force[axis] = static_cast<std::int64_t>(draw(-1e18, 1e18));
        two.sum[0].torque[axis] = static_cast<std::int64_t>(draw(-1e18, 1e18));
      }
      two.force_to_acceleration[0] = 1.1e-17;
      two.torque_to_acceleration[0] = 1.3e-15;
      Particles one = two;
      step_second_half(VectorLevel::sse2, {0.1, 0.0, -9.81}, 3e-6, two);
      step_first_half(VectorLevel::sse2, {0.1, 0.0, -9.81}, 3e-6, domain, here, room, two);
      step_second_and_first_half(level, {0.1, 0.0, -9.81}, 3e-6, domain, here, room, one);
      EXPECT_TRUE(same_bits(one.record[0], two.record[0])) << to_string(level);
    }
  }
}

TEST(VelocityVerlet, NotesWhoIsOutsideAndWhoHasMoved) {
  Particles p = grain_and_ghost();
  const auto notes = [&](double skin, const DomainDeck& within) {
    Particles copy = p;
    const std::vector<Mark> marks = {{{1.0, 2.0, 2.5}, skin * skin}};
    return step_first_half(best_vector_level(), {}, 0.0, within, marks, room, copy);
  };
  EXPECT_EQ(notes(0.51, domain).moved, 0U);
  EXPECT_EQ(notes(0.5, domain).moved, 1U);
  EXPECT_EQ(notes(1.0, domain).outside, 0U);
  EXPECT_EQ(notes(1.0, {{1.0, 2.0, 3.0}, {2.0, 3.0, 4.0}}).outside, 0U);  // the lower faces belong to the domain
  EXPECT_EQ(notes(1.0, {{0.0, 0.0, 0.0}, {2.0, 3.0, 3.0}}).outside, 1U);  // the upper ones do not
  EXPECT_EQ(notes(1.0, {{1.1, 0.0, 0.0}, {2.0, 3.0, 4.0}}).outside, 1U);
  EXPECT_EQ(notes(1.0, {{0.0, 0.0, 0.0}, {2.0, 2.0, 4.0}}).outside, 1U);
}

TEST(VelocityVerlet, NamesWhoHasMoved) {
  for (const VectorLevel level : levels_here()) {
    Particles p;
    std::vector<Mark> marks;
    for (int i = 0; i < 7; ++i) {
      ParticleRecord record = {};
      record.position = {static_cast<double>(i), 0.0, 0.0};
      record.radius = 0.5;
      p.record.push_back(record);
      marks.push_back({record.position + Vec3{0.0, i % 3 == 2 ? 0.2 : 0.1, 0.0}, 0.15 * 0.15});
    }
    p.owned = p.record.size();
    p.id.resize(p.owned);
    p.sum.assign(p.owned, ForceSum{});
    p.force_to_acceleration.assign(p.owned, 1.0);
    p.torque_to_acceleration.assign(p.owned, 1.0);
    std::vector<std::int32_t> moved(p.owned);
    const StepNotes notes = step_first_half(level, {}, 0.0, domain, marks, moved, p);
    moved.resize(notes.moved);
    EXPECT_EQ(moved, (std::vector<std::int32_t>{2, 5})) << to_string(level);
  }
}

TEST(VelocityVerlet, NotesTheLongestStepAndWhatIsNowhere) {
  for (const VectorLevel level : levels_here()) {
    const auto notes = [&](const Vec3& velocity) {
      Particles p = grain_and_ghost();
      p.record[0].velocity = velocity;
      p.sum[0] = {};
      return step_first_half(level, {}, 0.5, domain, here, room, p);
    };
    EXPECT_EQ(notes({0.5, 0.25, -0.25}).longest_step, 0.25) << to_string(level);
    EXPECT_EQ(notes({0.5, -0.75, -0.25}).longest_step, 0.375) << to_string(level);
    EXPECT_EQ(notes({0.5, -0.75, -1.0}).longest_step, 0.5) << to_string(level);
    EXPECT_FALSE(notes({0.5, -0.75, -1.0}).nowhere) << to_string(level);
    EXPECT_TRUE(notes({0.0, std::nan(""), 0.0}).nowhere) << to_string(level);
  }
}

// A constant acceleration is integrated exactly: x = v t + a t^2 / 2.
TEST(VelocityVerlet, FreeFallIsExact) {
  Particles p = grain_and_ghost();
  p.sum[0] = {};
  const double dt = 0x1p-7;
  for (int step = 0; step < 128; ++step) {
    step_first_half(best_vector_level(), {0.0, 0.0, -8.0}, dt, domain, here, room, p);
    step_second_half(best_vector_level(), {0.0, 0.0, -8.0}, dt, p);
  }
  EXPECT_EQ(p.record[0].position, (Vec3{1.5, 2.0, 3.0 - 0.25 - 4.0}));
  EXPECT_EQ(p.record[0].velocity, (Vec3{0.5, 0.0, -8.25}));
}

MaterialTable soft_and_stiff() {
  Deck deck;
  deck.materials = {{"soft", 1e7, 0.25, 1000.0}, {"stiff", 4e9, 0.5, 2000.0}};
  deck.pairs = {{{0.3, 0.1, 0.2}, {"soft", "soft"}}, {{1.0, 0.4, 0.5}, {"stiff", "soft"}}};
  return MaterialTable(deck);
}

TEST(FixedPointScales, ArePowersOfTwoThatHoldTheGreatestForce) {
  const MaterialTable materials = soft_and_stiff();
  for (const double radius : {1e-5, 2.2e-4, 1e-3, 0.05}) {
    Particles p;
    p.record = {{{}, radius, {}, 0.0, {}, 0.0}};
    p.material = {0};
    p.owned = 1;
    set_fixed_point_scales(materials, 0.3, p);
    const double force_scale = p.record[0].force_scale;
    const double torque_scale = p.record[0].torque_scale;
    int exponent = 0;
    EXPECT_EQ(std::frexp(force_scale, &exponent), 0.5);
    EXPECT_EQ(std::frexp(torque_scale, &exponent), 0.5);
    // Hertz's force on a wall of the stiffest partner, at 0.3 of the radius, four times over: at least 50, below 51
    // bits
    const double stiffness = materials.pair(0, 1).youngs_modulus_eff;
    const double force = 4.0 * 4.0 / 3.0 * stiffness * std::sqrt(0.3) * 0.3 * radius * radius;
    for (const double most : {force * force_scale, force * radius * torque_scale}) {
      EXPECT_LT(most, 0x1p+51);
      EXPECT_GE(most, 0x1p+50 * (1.0 - 1e-12));
    }
    std::int64_t sum = 0;
    EXPECT_TRUE(add_fixed_point(to_fixed_point(force, force_scale), sum));
    EXPECT_NEAR(static_cast<double>(sum) * p.force_to_acceleration[0], force / sphere_mass(radius, 1000.0),
                1e-14 * force / sphere_mass(radius, 1000.0));
    const double inertia = 0.4 * sphere_mass(radius, 1000.0) * radius * radius;
    EXPECT_NEAR(p.torque_to_acceleration[0] * torque_scale * inertia, 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace repose::test
