// When lists are made anew, and that no contact is ever missed in between.
#include <gtest/gtest.h>

#include "deck/deck.h"
#include "integration/velocity_verlet.h"
#include "neighbours/partner_search.h"
#include "neighbours/skin_watch.h"
#include "neighbours_samples.h"

namespace repose::test {
namespace {

enum class Skins { last, inner_used_up, outer_used_up };

/// The owned particles whose inner skins are used up; no time passes.
std::vector<std::int32_t> moved_ones(const SkinWatch& watch, Particles particles) {
  particles.sum.assign(particles.total(), ForceSum{});
  particles.force_to_acceleration.assign(particles.owned, 1.0);
  particles.torque_to_acceleration.assign(particles.owned, 1.0);
  const DomainDeck everywhere = {{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}};
  std::vector<std::int32_t> moved(particles.owned);
  moved.resize(step_first_half(best_vector_level(), {}, 0.0, everywhere, watch.inner_marks(), moved, particles).moved);
  return moved;
}

/// Those of them whose outer skins are used up.
std::vector<std::int32_t> at_large(const SkinWatch& watch, const Particles& particles,
                                   std::vector<std::int32_t> moved) {
  std::erase_if(moved, [&](std::int32_t i) { return !watch.outer_is_used_up(particles, static_cast<std::size_t>(i)); });
  return moved;
}

/// What a step on one rank makes of them.
Skins state_of(const SkinWatch& watch, const Particles& particles) {
  const std::vector<std::int32_t> moved = moved_ones(watch, particles);
  if (moved.empty()) return Skins::last;
  return at_large(watch, particles, moved).empty() ? Skins::inner_used_up : Skins::outer_used_up;
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
  watch.begin_outer(p);
  watch.begin_inner(p);
  return watch;
}

TEST(SkinWatch, ValidUntilTheInnerSkinIsUsed) {
  Particles p = one_grain();
  const SkinWatch watch = watching(p);
  EXPECT_EQ(state_of(watch, p), Skins::last);
  p.record[0].position = {0.0, 0.0199e-3, 0.0};
  EXPECT_EQ(state_of(watch, p), Skins::last);
  p.record[0].position = {0.0, 0.0201e-3, 0.0};
  EXPECT_EQ(state_of(watch, p), Skins::inner_used_up);
}

TEST(SkinWatch, TheWayCountsInEveryDirection) {
  const Particles p = one_grain();
  const SkinWatch watch = watching(p);
  Draw draw(51);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 direction = draw.direction();
    Particles moved = p;
    moved.record[0].position = 0.0199e-3 * direction;
    EXPECT_EQ(state_of(watch, moved), Skins::last);
    moved.record[0].position = 0.0201e-3 * direction;
    EXPECT_EQ(state_of(watch, moved), Skins::inner_used_up);
  }
}

// Of an outer skin of 0.3 mm, 14 x 0.021 mm leave 0.006 mm for the last inner one.
TEST(SkinWatch, InnerSkinsKeepWithinTheOuterOne) {
  Particles p = one_grain();
  SkinWatch watch = watching(p);
  for (int k = 1; k <= 14; ++k) {
    p.record[0].position.x = 0.021e-3 * k;
    ASSERT_EQ(state_of(watch, p), Skins::inner_used_up) << k;
    watch.begin_inner(p, std::vector<std::int32_t>{0});
    ASSERT_EQ(state_of(watch, p), Skins::last);
    EXPECT_DOUBLE_EQ(watch.inner_spheres()[0].reach, 1e-3 + std::min(0.02e-3, 0.3e-3 - 0.021e-3 * k)) << k;
  }
  p.record[0].position.x = 0.2999e-3;
  EXPECT_EQ(state_of(watch, p), Skins::last);
  p.record[0].position.x = 0.3001e-3;
  EXPECT_EQ(state_of(watch, p), Skins::outer_used_up);
  watch = watching(p);
  EXPECT_EQ(state_of(watch, p), Skins::last);
}

TEST(SkinWatch, SkinsAreThoseOfTheSpeedAtTheMarks) {
  Particles p = one_grain();
  p.record[0].velocity = {0.0, 0.0, -2.0};  // inner skin 0.02 + 0.016 mm, outer 0.3 + 0.16 mm
  const SkinWatch watch = watching(p);
  p.record[0].velocity = {};
  p.record[0].position.z = -0.0359e-3;
  EXPECT_EQ(state_of(watch, p), Skins::last);
  p.record[0].position.z = -0.0361e-3;
  EXPECT_EQ(state_of(watch, p), Skins::inner_used_up);
}

TEST(SkinWatch, OneSkinBeginsAnewAlone) {
  Particles p = random_cloud(54, {.count = 9});
  p.owned = 6;
  SkinWatch watch = watching(p);
  for (ParticleRecord& r : p.record) r.position.z += 0.03e-3;
  EXPECT_EQ(moved_ones(watch, p), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
  const std::vector<std::int32_t> two = {1, 4};
  watch.begin_inner(p, two);
  EXPECT_EQ(moved_ones(watch, p), (std::vector<std::int32_t>{0, 2, 3, 5}));
}

TEST(SkinWatch, GhostsAreWatchedApart) {
  Particles p = random_cloud(54, {.count = 9});
  p.owned = 6;
  SkinWatch watch = watching(p);
  EXPECT_EQ(watch.inner_marks().size(), 6U);
  EXPECT_TRUE(watch.moved_ghosts(p).empty());
  for (const std::size_t i : {2U, 6U, 8U}) p.record[i].position.z += 0.03e-3;
  const std::span<const std::int32_t> moved = watch.moved_ghosts(p);
  EXPECT_EQ(std::vector(moved.begin(), moved.end()), (std::vector<std::int32_t>{6, 8}));
  watch.begin_inner(p, moved);
  EXPECT_TRUE(watch.moved_ghosts(p).empty());
}

TEST(SkinWatch, ParkedParticlesAskForNothing) {
  Particles p = one_grain();
  SkinWatch watch = watching(p);
  park(p.record[0], 0);
  watch.ignore_parked(p);
  EXPECT_EQ(state_of(watch, p), Skins::last);
  watch.begin_inner(p);
  EXPECT_EQ(state_of(watch, p), Skins::last);
}

TEST(SkinWatch, NoParticlesNoStaleLists) {
  const Particles p;
  EXPECT_EQ(state_of(watching(p), p), Skins::last);
}

// Grains fly about, are stopped and shot off again; every pair that touches must be in the inner lists at every step.
TEST(SkinWatch, NoContactIsEverMissed) {
  Draw draw(52);
  Particles p = random_cloud(53, {.count = 150, .smallest = 3e-4, .largest = 2e-3, .box = 0.02});
  p.owned = p.total();
  PairLists lists;
  SkinWatch watch(inner, outer);
  PartnerSearch search;
  const Csr<PairMemory> nothing = Csr<PairMemory>::empty(p.owned);
  const auto rebuild = [&] {
    lists.build(p, listed(p, outer), nothing);
    watch = watching(p);
    search.begin(sort_into_levels(std::span(p.record).first(p.total()), reaches(p, outer)), p.owned);
    lists.select_near(watch.inner_spheres());
  };
  rebuild();
  int rebuilds = 0;
  int renewals = 0;
  std::size_t outer_renewals = 0;
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
    const std::vector<std::int32_t> moved = moved_ones(watch, p);
    const std::vector<std::int32_t> leavers = at_large(watch, p, moved);
    const bool too_many = search.renewals() + leavers.size() > 20;
    if (!too_many) {
      for (const std::int32_t i : leavers) watch.begin_outer(p, static_cast<std::size_t>(i));
      search.renew(p, watch, leavers);
      for (const std::int32_t i : leavers) lists.list_more(p, i, search.partners(p, watch, i));
      outer_renewals += leavers.size();
    }
    if (too_many) {
      rebuild();
      ++rebuilds;
    } else if (step % 50 == 0) {
      watch.begin_inner(p);
      lists.select_near(watch.inner_spheres());
    } else if (!moved.empty()) {
      watch.begin_inner(p, moved);
      lists.add_near(watch.inner_spheres(), moved);
      ++renewals;
    }
    const PairCount listed = inner_pairs(p, lists);
    for (const auto& [pair, count] : brute_force(p, {0.0, 0.0})) {
      ASSERT_TRUE(listed.contains(pair)) << "step " << step;
      ++touching;
    }
  }
  EXPECT_GT(rebuilds, 5);
  EXPECT_GT(renewals, rebuilds);
  EXPECT_GT(outer_renewals, 100U);
  EXPECT_GT(touching, 10000U);
}

}  // namespace
}  // namespace repose::test
