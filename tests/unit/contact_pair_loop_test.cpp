// The pair loop against a scalar evaluation of the contact law, bit for bit, at every vector level of the processor.
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "contact_loop_samples.h"
#include "support/contact_options.h"
#include "support/levels.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

void expect_same_bits(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(std::memcmp(a.blocks.data(), b.blocks.data(), a.blocks.size() * sizeof(ContactBlock)), 0);
  EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(ForceSum)), 0);
}

class PairLoop : public ::testing::Test {
 protected:
  const MaterialTable materials{bare_deck({}, loop_dt)};
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

TEST(PairLoopWithOptions, IsTheContactLawBitForBitAtEveryLevel) {
  std::vector<Outcome> all;
  for (const Deck& deck : decks_of_all_options(bare_deck({}, loop_dt))) {
    const MaterialTable materials(deck);
    const Loop loop = random_loop(21, 500, materials);
    const Outcome scalar = evaluate_scalar(loop, materials.pair(0, 0));
    ASSERT_FALSE(scalar.alarms.any());
    for (const VectorLevel level : levels_here()) {
      SCOPED_TRACE(to_string(level));
      expect_same_bits(evaluate(level, loop, materials.pair(0, 0)), scalar);
    }
    for (const Outcome& other : all) {  // each option does something
      EXPECT_NE(std::memcmp(scalar.blocks.data(), other.blocks.data(), scalar.blocks.size() * sizeof(ContactBlock)), 0);
    }
    all.push_back(scalar);
  }
  EXPECT_EQ(all.size(), 32U);
}

TEST(PairLoopWithModels, IsTheContactLawBitForBitAtEveryLevel) {
  const Deck plain = bare_deck({}, loop_dt);
  std::vector<Outcome> all = {
      evaluate_scalar(random_loop(21, 500, MaterialTable(plain)), MaterialTable(plain).pair(0, 0))};
  for (const Deck& deck : decks_of_all_models(plain)) {
    SCOPED_TRACE(all.size());
    const MaterialTable materials(deck);
    const Loop loop = random_loop(21, 500, materials);
    const Outcome scalar = evaluate_scalar(loop, materials.pair(0, 0));
    ASSERT_FALSE(scalar.alarms.any());
    for (const VectorLevel level : levels_here()) {
      SCOPED_TRACE(to_string(level));
      expect_same_bits(evaluate(level, loop, materials.pair(0, 0)), scalar);
    }
    for (const Outcome& other : all) {  // each model does something
      EXPECT_NE(std::memcmp(scalar.sums.data(), other.sums.data(), scalar.sums.size() * sizeof(ForceSum)), 0);
    }
    all.push_back(scalar);
  }
  EXPECT_EQ(all.size(), 15U);
}

TEST(PairLoopWithOptions, ReportsNan) {
  for (const Deck& deck : decks_of_all_options(bare_deck({}, loop_dt))) {
    const MaterialTable materials(deck);
    Loop loop = random_loop(17, 64, materials);
    ParticleRecord& a = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].first[13])];
    ParticleRecord& b = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].second[13])];
    b.position = a.position + Vec3{0.0, 0.0, 0.99 * (a.radius + b.radius)};
    ASSERT_FALSE(evaluate(best_vector_level(), loop, materials.pair(0, 0)).alarms.any());
    for (double* poisoned : {&a.velocity.y, &b.spin.x, &loop.blocks[0].spring[1][13], &loop.blocks[0].rolling[2][13]}) {
      const double healthy = *poisoned;
      *poisoned = std::numeric_limits<double>::quiet_NaN();
      EXPECT_GT(evaluate(best_vector_level(), loop, materials.pair(0, 0)).alarms.out_of_range, 0);
      *poisoned = healthy;
    }
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
    const Loop loop = random_loop(13, block_lanes + 1, materials);  // the second block is all dummies but one
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
  set_fixed_point_scales(materials, loop_max_overlap, loop.particles);  // the same scale: the same rounding
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
    ParticleRecord& a = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].first[13])];
    ParticleRecord& b = loop.particles.record[static_cast<std::size_t>(loop.blocks[0].second[13])];
    b.position = a.position + Vec3{0.0, 0.0, 0.99 * (a.radius + b.radius)};
    ASSERT_FALSE(evaluate(level, loop, pair).alarms.any());
    for (double* poisoned : {&a.velocity.y, &b.velocity.x, &a.spin.z, &b.spin.x, &loop.blocks[0].spring[1][13],
                             &loop.blocks[0].rolling[2][13]}) {
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
