// The pair loop against a scalar evaluation of the contact law, bit for bit, at every vector level of the processor.
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "contact/fixed_point.h"
#include "contact/pair_loop.h"
#include "contact_samples.h"
#include "integration/velocity_verlet.h"
#include "neighbours/pair_lists.h"
#include "scene/sphere.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double dt = 1e-6;
constexpr double max_overlap = 0.3;

std::vector<VectorLevel> levels_here() {
  std::vector<VectorLevel> levels;
  for (const char* name : {"sse2", "avx2", "avx512"}) {
    try {
      levels.push_back(vector_level_from(name));
    } catch (const DeckError&) {  // this processor lacks it
    }
  }
  return levels;
}

struct Loop {
  Particles particles;
  std::vector<ContactBlock> blocks;
  std::size_t pairs = 0;
};

struct Outcome {
  std::vector<ContactBlock> blocks;
  std::vector<ForceSum> sums;
  PairLoopAlarms alarms;
};

/// Signed overlaps, over the smaller radius: deep, usual, a last-digit touch, exact touch, gaps.
double random_overlap(Draw& draw) {
  switch (draw.below(6)) {
    case 0:
      return draw(0.05, 0.29);
    case 1:
      return draw(1e-9, 1e-3);
    case 2:
      return draw(-4e-16, 4e-16);
    case 3:
      return 0.0;
    case 4:
      return draw(-1e-3, -1e-9);
    default:
      return draw(-30.0, -0.1);
  }
}

ParticleRecord random_grain(Draw& draw, const Vec3& position, double radius) {
  ParticleRecord record = {};
  record.position = position;
  record.radius = radius;
  record.velocity = draw.vector(0.2);
  record.spin = draw.vector(200.0);
  return record;
}

/// `pairs` pairs of grains with radii from 0.1 to 1 mm; every third pair shares its first grain with the pair before.
Loop random_loop(std::uint64_t seed, std::size_t pairs, const MaterialTable& materials) {
  Draw draw(seed);
  Loop loop;
  loop.pairs = pairs;
  Particles& p = loop.particles;
  std::vector<std::array<std::size_t, 2>> indices;
  for (std::size_t k = 0; k < pairs; ++k) {
    if (k % 3 != 1) p.record.push_back(random_grain(draw, draw.vector(0.05), draw(1e-4, 1e-3)));
    const std::size_t first = k % 3 != 1 ? p.record.size() - 1 : indices.back()[0];
    const ParticleRecord a = p.record[first];
    const double radius = draw(1e-4, 1e-3);
    const double apart = a.radius + radius - random_overlap(draw) * std::min(a.radius, radius);
    p.record.push_back(random_grain(draw, a.position + apart * draw.direction(), radius));
    indices.push_back({first, p.record.size() - 1});
  }
  p.owned = p.record.size();
  for (std::size_t i = 0; i < p.owned; ++i) p.id.push_back(static_cast<std::int64_t>(i));
  p.material.assign(p.owned, 0);
  set_fixed_point_scales(materials, max_overlap, p);
  add_lane_dummies(p);

  const auto dummy = static_cast<std::int32_t>(p.total());
  loop.blocks.resize((pairs + block_lanes - 1) / block_lanes);
  for (std::size_t k = 0; k < block_lanes * loop.blocks.size(); ++k) {
    ContactBlock& block = loop.blocks[k / block_lanes];
    const std::size_t lane = k % block_lanes;
    const bool used = k < pairs;
    block.first[lane] = used ? static_cast<std::int32_t>(indices[k][0]) : dummy;
    block.second[lane] = used ? static_cast<std::int32_t>(indices[k][1]) : dummy + 1;
    const bool remembers = used && draw(0.0, 1.0) < 0.7;
    for (auto& column : block.spring) column[lane] = remembers ? draw(-1e-6, 1e-6) : 0.0;
    for (auto& column : block.rolling) column[lane] = remembers ? draw(-1e-9, 1e-9) : 0.0;
  }
  return loop;
}

Outcome evaluate(VectorLevel level, const Loop& loop, const PairParameters& pair, double step = dt) {
  Outcome outcome = {loop.blocks, std::vector<ForceSum>(loop.particles.record.size(), ForceSum{}), {}};
  outcome.alarms = evaluate_pairs(level, outcome.blocks, pair, step, max_overlap, loop.particles.record.data(),
                                  outcome.sums.data());
  return outcome;
}

bool add(const Vec3& v, double scale, std::int64_t* sum) {
  bool fits = add_fixed_point(to_fixed_point(v.x, scale), sum[0]);
  fits &= add_fixed_point(to_fixed_point(v.y, scale), sum[1]);
  return add_fixed_point(to_fixed_point(v.z, scale), sum[2]) && fits;
}

/// One lane, written as the theory says it.
void evaluate_scalar(const ParticleRecord& a, const ParticleRecord& b, const PairParameters& pair,
                     ContactHistory& history, ForceSum& on_a, ForceSum& on_b, PairLoopAlarms& alarms) {
  const Vec3 apart = a.position - b.position;
  const double distance = norm(apart);
  ContactGeometry contact = {};
  contact.overlap = a.radius + b.radius - distance;
  if (!(contact.overlap > 0.0)) {
    history = {};
    return;
  }
  contact.normal = (1.0 / distance) * apart;
  contact.radius_eff = a.radius * b.radius / (a.radius + b.radius);
  const double mass_a = sphere_mass(a.radius, pair.density_first);
  const double mass_b = sphere_mass(b.radius, pair.density_second);
  contact.mass_eff = mass_a * mass_b / (mass_a + mass_b);
  const double arm_a = a.radius - 0.5 * contact.overlap;
  const double arm_b = b.radius - 0.5 * contact.overlap;
  const Vec3 velocity = a.velocity - b.velocity;
  contact.normal_velocity = dot(velocity, contact.normal);
  contact.tangential_velocity = velocity - contact.normal_velocity * contact.normal -
                                cross(arm_a * a.spin + arm_b * b.spin, contact.normal);
  contact.rolling_velocity = without_normal_part(a.spin - b.spin, contact.normal);
  const ContactForces forces = contact_law(pair, contact, dt, history);
  alarms.too_deep += contact.overlap > max_overlap * std::min(a.radius, b.radius) ? 1 : 0;
  bool fits = add(forces.force, a.force_scale, on_a.force);
  fits &= add(-forces.force, b.force_scale, on_b.force);
  fits &= add(-(arm_a * forces.friction_arm) - forces.rolling_moment, a.torque_scale, on_a.torque);
  fits &= add(forces.rolling_moment - arm_b * forces.friction_arm, b.torque_scale, on_b.torque);
  alarms.out_of_range += fits ? 0 : 1;
}

Outcome evaluate_scalar(const Loop& loop, const PairParameters& pair) {
  Outcome outcome = {loop.blocks, std::vector<ForceSum>(loop.particles.record.size(), ForceSum{}), {}};
  for (std::size_t k = 0; k < loop.pairs; ++k) {
    ContactBlock& block = outcome.blocks[k / block_lanes];
    const std::size_t lane = k % block_lanes;
    const auto first = static_cast<std::size_t>(block.first[lane]);
    const auto second = static_cast<std::size_t>(block.second[lane]);
    ContactHistory h = {{block.spring[0][lane], block.spring[1][lane], block.spring[2][lane]},
                        {block.rolling[0][lane], block.rolling[1][lane], block.rolling[2][lane]}};
    evaluate_scalar(loop.particles.record[first], loop.particles.record[second], pair, h, outcome.sums[first],
                    outcome.sums[second], outcome.alarms);
    const double spring[] = {h.spring.x, h.spring.y, h.spring.z};
    const double rolling[] = {h.rolling.x, h.rolling.y, h.rolling.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.spring[axis][lane] = spring[axis];
      block.rolling[axis][lane] = rolling[axis];
    }
  }
  return outcome;
}

void expect_same_bits(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(std::memcmp(a.blocks.data(), b.blocks.data(), a.blocks.size() * sizeof(ContactBlock)), 0);
  EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(ForceSum)), 0);
}

class PairLoop : public ::testing::Test {
 protected:
  const MaterialTable materials{bare_deck({}, dt)};
  const PairParameters pair = materials.pair(0, 0);
};

TEST_F(PairLoop, IsTheContactLawBitForBitAtEveryLevel) {
  const Loop loop = random_loop(11, 5000, materials);  // fills the last block in part
  const Outcome scalar = evaluate_scalar(loop, pair);
  ASSERT_FALSE(scalar.alarms.any());
  for (const VectorLevel level : levels_here()) {
    SCOPED_TRACE(to_string(level));
    const Outcome outcome = evaluate(level, loop, pair);
    expect_same_bits(outcome, scalar);
    EXPECT_FALSE(outcome.alarms.any());
  }
}

TEST_F(PairLoop, SamplesBothTouchingAndParted) {
  const Loop loop = random_loop(11, 5000, materials);
  const Outcome outcome = evaluate(best_vector_level(), loop, pair);
  int touching = 0;
  for (std::size_t k = 0; k < loop.pairs; ++k) {
    const ContactBlock& block = outcome.blocks[k / block_lanes];
    touching += block.spring[0][k % block_lanes] != 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, 1500);
  EXPECT_LT(touching, 3500);
}

TEST_F(PairLoop, PartedLanesForgetAndPushNothing) {
  for (const VectorLevel level : levels_here()) {
    SCOPED_TRACE(to_string(level));
    Loop loop = random_loop(12, 100, materials);
    for (std::size_t i = 0; i < loop.particles.owned; ++i) {
      loop.particles.record[i].position = 0.01 * Vec3{static_cast<double>(i), 0.0, 0.0};
    }
    const Outcome outcome = evaluate(level, loop, pair);
    for (const ContactBlock& block : outcome.blocks) {
      for (std::size_t lane = 0; lane < block_lanes; ++lane) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(block.spring[axis][lane], 0.0);
          EXPECT_EQ(block.rolling[axis][lane], 0.0);
        }
      }
    }
    for (const ForceSum& sum : outcome.sums) {
      for (const std::int64_t component : sum.force) EXPECT_EQ(component, 0);
      for (const std::int64_t component : sum.torque) EXPECT_EQ(component, 0);
    }
    EXPECT_FALSE(outcome.alarms.any());
  }
}

TEST_F(PairLoop, DummyLanesStayBlank) {
  for (const VectorLevel level : levels_here()) {
    const Loop loop = random_loop(13, 65, materials);  // 63 dummies in the second block
    const Outcome outcome = evaluate(level, loop, pair);
    for (std::size_t lane = 1; lane < block_lanes; ++lane) EXPECT_EQ(outcome.blocks[1].rolling[2][lane], 0.0);
    for (std::size_t dummy = loop.particles.total(); dummy < outcome.sums.size(); ++dummy) {
      for (const std::int64_t component : outcome.sums[dummy].force) EXPECT_EQ(component, 0);
    }
  }
}

TEST_F(PairLoop, PairForcesCancelUpToTheirRounding) {
  Loop loop = random_loop(14, 1, materials);
  ParticleRecord& a = loop.particles.record[0];
  ParticleRecord& b = loop.particles.record[1];
  b.radius = a.radius;
  b.position = a.position + Vec3{1.9 * a.radius, 0.0, 0.0};
  set_fixed_point_scales(materials, max_overlap, loop.particles);  // the same scale: the same rounding
  const Outcome outcome = evaluate(best_vector_level(), loop, pair);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(outcome.sums[0].force[axis], -outcome.sums[1].force[axis]);
  EXPECT_LT(outcome.sums[0].force[0], 0);  // pushed apart
}

TEST_F(PairLoop, WithoutTimeNoRollingMomentArises) {
  Loop loop = random_loop(15, 200, materials);
  for (ContactBlock& block : loop.blocks) {
    std::memset(block.spring, 0, sizeof block.spring);
    std::memset(block.rolling, 0, sizeof block.rolling);
  }
  const Outcome outcome = evaluate(best_vector_level(), loop, pair, 0.0);
  for (const ContactBlock& block : outcome.blocks) {
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      EXPECT_EQ(block.rolling[0][lane], 0.0);
      EXPECT_EQ(block.spring[0][lane], 0.0);
    }
  }
}

TEST_F(PairLoop, CountsTooDeepOverlaps) {
  for (const VectorLevel level : levels_here()) {
    SCOPED_TRACE(to_string(level));
    Loop loop = random_loop(16, 200, materials);
    int deep = 0;
    for (std::size_t k = 0; k < loop.pairs; ++k) {
      const ContactBlock& block = loop.blocks[k / block_lanes];
      const auto first = static_cast<std::size_t>(block.first[k % block_lanes]);
      const auto second = static_cast<std::size_t>(block.second[k % block_lanes]);
      const ParticleRecord& a = loop.particles.record[first];
      ParticleRecord& b = loop.particles.record[second];
      const double share = k % 4 == 0 ? 0.301 : 0.299;  // of the smaller radius
      b.position = a.position + Vec3{0.0, a.radius + b.radius - share * std::min(a.radius, b.radius), 0.0};
      deep += k % 4 == 0 ? 1 : 0;
    }
    EXPECT_EQ(evaluate(level, loop, pair).alarms.too_deep, deep);
  }
}

TEST_F(PairLoop, ReportsNan) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const VectorLevel level : levels_here()) {
    SCOPED_TRACE(to_string(level));
    Loop loop = random_loop(17, 64, materials);
    ParticleRecord& a = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].first[37])];
    ParticleRecord& b = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].second[37])];
    b.position = a.position + Vec3{0.0, 0.0, 0.99 * (a.radius + b.radius)};
    ASSERT_FALSE(evaluate(level, loop, pair).alarms.any());
    for (double* poisoned : {&a.velocity.y, &b.velocity.x, &a.spin.z, &b.spin.x, &loop.blocks[0].spring[1][37],
                             &loop.blocks[0].rolling[2][37]}) {
      const double healthy = *poisoned;
      *poisoned = nan;
      EXPECT_GT(evaluate(level, loop, pair).alarms.out_of_range, 0);
      *poisoned = healthy;
    }
  }
}

TEST_F(PairLoop, ReportsCentresOnTopOfOneAnother) {
  for (const VectorLevel level : levels_here()) {
    Loop loop = random_loop(18, 64, materials);
    loop.particles.record[static_cast<std::size_t>(loop.blocks[0].second[5])].position =
        loop.particles.record[static_cast<std::size_t>(loop.blocks[0].first[5])].position;
    EXPECT_TRUE(evaluate(level, loop, pair).alarms.any());
  }
}

TEST_F(PairLoop, ReportsForcesBeyondTheRange) {
  for (const VectorLevel level : levels_here()) {
    SCOPED_TRACE(to_string(level));
    Loop loop = random_loop(19, 64, materials);
    ParticleRecord& a = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].first[9])];
    ParticleRecord& b = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].second[9])];
    b.position = a.position + Vec3{0.0, 0.0, a.radius + b.radius - 0.2 * std::min(a.radius, b.radius)};
    b.velocity = a.velocity;
    ASSERT_FALSE(evaluate(level, loop, pair).alarms.any());
    b.velocity.z = a.velocity.z - 1e6;  // the dashpot's force
    EXPECT_GT(evaluate(level, loop, pair).alarms.out_of_range, 0);
  }
}

TEST(VectorLevels, AreNamedAndRefused) {
  for (const VectorLevel level : levels_here()) EXPECT_EQ(vector_level_from(to_string(level)), level);
  EXPECT_EQ(vector_level_from("auto"), best_vector_level());
  EXPECT_EQ(vector_level_from(""), best_vector_level());
  EXPECT_THROW(vector_level_from("avx3"), DeckError);
}

}  // namespace
}  // namespace repose::test
