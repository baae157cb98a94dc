// When lists are made anew, and that no contact is ever missed in between.
#include <gtest/gtest.h>

#include "deck/deck.h"
#include "integration/velocity_verlet.h"
#include "neighbours/skin_watch.h"
#include "neighbours_samples.h"

namespace repose::test {
namespace {

enum class ListState { valid, inner_stale, outer_stale };

/// What a step on one rank makes of the two questions; no time passes.
ListState state_of(const SkinWatch& watch, Particles particles) {
  particles.sum.assign(particles.total(), ForceSum{});
  particles.force_to_acceleration.assign(particles.owned, 1.0);
  particles.torque_to_acceleration.assign(particles.owned, 1.0);
  const DomainDeck everywhere = {{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}};
  if (!step_first_half(best_vector_level(), {}, 0.0, everywhere, watch.inner_marks(), particles).skin_used_up)
    return ListState::valid;
  return watch.outer_is_too_short(particles) ? ListState::outer_stale : ListState::inner_stale;
}

constexpr SkinRule outer = {0.3, 8e-5};
constexpr SkinRule inner = {0.02, 8e-6};

/// One grain of radius 1 mm at rest: inner skin 0.02 mm, outer skin 0.3 mm.
Particles one_grain() {
  Particles p;
  ParticleRecord record = {};
  record.radius = 1e-3;
  p.record = {record};
  p.id = {0};
  p.material = {0};
  p.owned = 1;
  return p;
}

SkinWatch watching(const Particles& p) {
  SkinWatch watch(inner, outer);
  watch.outer_listed(p);
  watch.inner_selected(p);
  return watch;
}

TEST(SkinWatch, ValidUntilTheInnerSkinIsUsed) {
  Particles p = one_grain();
  const SkinWatch watch = watching(p);
  EXPECT_EQ(state_of(watch, p), ListState::valid);
  p.record[0].position = {0.0, 0.0199e-3, 0.0};
  EXPECT_EQ(state_of(watch, p), ListState::valid);
  p.record[0].position = {0.0, 0.0201e-3, 0.0};
  EXPECT_EQ(state_of(watch, p), ListState::inner_stale);
}

TEST(SkinWatch, TheWayCountsInEveryDirection) {
  const Particles p = one_grain();
  const SkinWatch watch = watching(p);
  Draw draw(51);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 direction = draw.direction();
    Particles moved = p;
    moved.record[0].position = 0.0199e-3 * direction;
    EXPECT_EQ(state_of(watch, moved), ListState::valid);
    moved.record[0].position = 0.0201e-3 * direction;
    EXPECT_EQ(state_of(watch, moved), ListState::inner_stale);
  }
}

TEST(SkinWatch, OuterSkinKeepsRoomForAnotherInnerOne) {
  Particles p = one_grain();
  SkinWatch watch = watching(p);
  for (int k = 1; k <= 13; ++k) {  // 13 x 0.021 = 0.273 mm of 0.3 - 0.02 mm
    p.record[0].position.x = 0.021e-3 * k;
    ASSERT_EQ(state_of(watch, p), ListState::inner_stale) << k;
    watch.inner_selected(p);
    ASSERT_EQ(state_of(watch, p), ListState::valid);
  }
  p.record[0].position.x = 0.021e-3 * 14;
  EXPECT_EQ(state_of(watch, p), ListState::outer_stale);
  watch = watching(p);
  EXPECT_EQ(state_of(watch, p), ListState::valid);
}

TEST(SkinWatch, SkinsAreThoseOfTheSpeedAtTheMarks) {
  Particles p = one_grain();
  p.record[0].velocity = {0.0, 0.0, -2.0};  // inner skin 0.02 + 0.016 mm, outer 0.3 + 0.16 mm
  const SkinWatch watch = watching(p);
  p.record[0].velocity = {};
  p.record[0].position.z = -0.0359e-3;
  EXPECT_EQ(state_of(watch, p), ListState::valid);
  p.record[0].position.z = -0.0361e-3;
  EXPECT_EQ(state_of(watch, p), ListState::inner_stale);
}

TEST(SkinWatch, AGrainTooFastForItsOuterSkinAsksForNewLists) {
  Particles p = one_grain();
  const SkinWatch watch = watching(p);
  p.record[0].velocity = {40.0, 0.0, 0.0};  // another inner skin would be 0.34 mm
  p.record[0].position.x = 0.01e-3;
  EXPECT_EQ(state_of(watch, p), ListState::valid);
  p.record[0].position.x = 0.03e-3;
  EXPECT_EQ(state_of(watch, p), ListState::outer_stale);
}

TEST(SkinWatch, ParkedParticlesAskForNothing) {
  Particles p = one_grain();
  SkinWatch watch = watching(p);
  park(p.record[0], 0);
  watch.ignore_parked(p);
  EXPECT_EQ(state_of(watch, p), ListState::valid);
  watch.inner_selected(p);
  EXPECT_EQ(state_of(watch, p), ListState::valid);
}

TEST(SkinWatch, NoParticlesNoStaleLists) {
  const Particles p;
  EXPECT_EQ(state_of(watching(p), p), ListState::valid);
}

// Grains fly about, are stopped and shot off again; every pair that touches must be in the inner lists at every step.
TEST(SkinWatch, NoContactIsEverMissed) {
  Draw draw(52);
  Particles p = random_cloud(53, {.count = 150, .smallest = 3e-4, .largest = 2e-3, .box = 0.02});
  p.owned = p.total();
  PairLists lists;
  SkinWatch watch(inner, outer);
  const Csr<PairMemory> nothing = Csr<PairMemory>::empty(p.owned);
  const auto rebuild = [&] {
    lists.build(p, listed(p, outer), nothing);
    lists.select_near(p, inner);
    watch = watching(p);
  };
  rebuild();
  int rebuilds = 0;
  int selections = 0;
  std::size_t touching = 0;
  for (int step = 0; step < 1500; ++step) {
    for (int kick = 0; kick < 2; ++kick) {
      p.record[draw.below(p.owned)].velocity = draw.vector(draw(0.0, 1.0) < 0.1 ? 20.0 : 0.5);
    }
    for (std::size_t i = 0; i < p.owned; ++i) {
      ParticleRecord& r = p.record[i];
      r.position += 5e-7 * r.velocity;
      if (squared_norm(r.position) > 4e-4) r.velocity = -20.0 * r.position;  // back to the cloud
    }
    const ListState state = state_of(watch, p);
    if (state == ListState::outer_stale) {
      rebuild();
      ++rebuilds;
    } else if (state == ListState::inner_stale) {
      lists.select_near(p, inner);
      watch.inner_selected(p);
      ++selections;
    }
    const PairCount listed = inner_pairs(p, lists);
    for (const auto& [pair, count] : brute_force(p, {0.0, 0.0})) {
      ASSERT_TRUE(listed.contains(pair)) << "step " << step;
      ++touching;
    }
  }
  EXPECT_GT(rebuilds, 5);
  EXPECT_GT(selections, rebuilds);
  EXPECT_GT(touching, 10000U);
}

}  // namespace
}  // namespace repose::test
