// Neighbour lists against brute force, and the histories they carry.
#include <set>

#include <gtest/gtest.h>

#include "neighbours/near_pairs.h"
#include "neighbours_samples.h"

namespace repose::test {
namespace {

constexpr SkinRule outer = {0.3, 8e-5};
constexpr SkinRule inner = {0.02, 8e-6};

Csr<PairMemory> nothing(std::size_t owned) { return Csr<PairMemory>::empty(owned); }

std::vector<CloudOptions> clouds() {
  CloudOptions sparse{.count = 300, .box = 0.1};
  CloudOptions dense{.count = 600, .box = 0.02, .speed = 0.0};
  CloudOptions mixed{.count = 900, .smallest = 2e-4, .largest = 2e-3, .box = 0.02};
  CloudOptions fast{.count = 600, .smallest = 2e-4, .largest = 2e-3, .box = 0.04, .fast_share = 0.05};
  CloudOptions single{.count = 1};
  CloudOptions none{.count = 0};
  CloudOptions wide{.count = 900, .smallest = 1e-4, .largest = 5e-3, .box = 0.04};
  return {sparse, dense, mixed, fast, single, none, wide};
}

TEST(NearPairs, CrossTheCellsAtTheEndsOfALargeDomain) {
  Particles p = random_cloud(23, {.count = 6});
  p.owned = 6;
  p.record[1].position = p.record[2].position = {1e9, 0.0, -1e9};
  p.record[3].position = p.record[4].position = {1e9, -1e9, 1e9};
  p.record[5].position = {1e9, -1e9, -1e9};
  const auto pairs = near_pairs(std::span(p.record).first(6), reaches(p, outer), 6);
  EXPECT_EQ(pairs, (std::vector<std::array<std::int32_t, 2>>{{1, 2}, {3, 4}}));
}

TEST(NearPairs, DropGhostsThatNobodyIsNear) {
  std::vector<IndexPair> pairs = {{0, 1}, {0, 5}, {1, 3}, {1, 5}};
  const std::vector<bool> needed = ghosts_in(pairs, 2, 6);
  EXPECT_EQ(needed, (std::vector<bool>{false, true, false, true}));
  drop_ghosts(needed, 2, pairs);
  EXPECT_EQ(pairs, (std::vector<IndexPair>{{0, 1}, {0, 3}, {1, 2}, {1, 3}}));
}

TEST(PairLists, OuterListHoldsEachPairOnce) {
  for (const CloudOptions& options : clouds()) {
    for (std::uint64_t seed = 31; seed < 34; ++seed) {
      const Particles p = random_cloud(seed, options);
      PairLists lists;
      lists.build(p, listed(p, outer), nothing(p.owned));
      const PairCount expected = brute_force(p, outer);
      EXPECT_EQ(outer_pairs(p, lists), expected);
      EXPECT_EQ(lists.listed(), expected.size());
      EXPECT_EQ(lists.lanes(), 0U);
    }
  }
}

TEST(PairLists, InnerListHoldsEachNearPairOnce) {
  for (const CloudOptions& options : clouds()) {
    const Particles p = random_cloud(35, options);
    PairLists lists;
    lists.build(p, listed(p, outer), nothing(p.owned));
    lists.select_near(spheres(p, inner));
    EXPECT_EQ(inner_pairs(p, lists), brute_force(p, inner));
    lists.select_near(spheres(p, outer));
    EXPECT_EQ(inner_pairs(p, lists), brute_force(p, outer));
    lists.select_near(spheres(p, inner));
    EXPECT_EQ(inner_pairs(p, lists), brute_force(p, inner));
  }
}

TEST(PairLists, TheSamplesHavePairs) {
  const Particles dense = random_cloud(31, clouds()[1]);
  EXPECT_GT(brute_force(dense, outer).size(), 1000U);
  EXPECT_LT(brute_force(dense, inner).size(), 0.8 * static_cast<double>(brute_force(dense, outer).size()));
  const Particles fast = random_cloud(31, clouds()[3]);
  EXPECT_GT(2 * brute_force(fast, outer).size(), 3 * brute_force(fast, {outer.share, 0.0}).size());
}

TEST(PairLists, GroupsShareMaterialsAndKeepTheGhostsApart) {
  const Particles p = random_cloud(36, clouds()[2]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  EXPECT_EQ(lists.groups().size(), 8U);  // two materials in either place, interior or not
  for (const PairGroup& group : lists.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) {
      const auto first = static_cast<std::size_t>(pair.first);
      const auto second = static_cast<std::size_t>(pair.second);
      EXPECT_LT(p.id[first], p.id[second]);
      EXPECT_EQ(p.material[first], group.material_first);
      EXPECT_EQ(p.material[second], group.material_second);
      EXPECT_EQ(group.interior, first < p.owned && second < p.owned);
    }
  }
}

TEST(PairLists, UnusedLanesNameTheDummies) {
  const Particles p = random_cloud(37, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  for (const PairGroup& group : lists.groups()) {
    ASSERT_EQ(group.blocks.size(), blocks_for(group.lanes));
    for (std::size_t lane = group.lanes; lane < block_lanes * group.blocks.size(); ++lane) {
      const std::size_t block = lane / block_lanes;
      const std::size_t slot = lane % block_lanes;
      EXPECT_EQ(group.blocks[block].first[slot], static_cast<std::int32_t>(p.total()));
      EXPECT_EQ(group.blocks[block].second[slot], static_cast<std::int32_t>(p.total() + 1));
      EXPECT_TRUE(is_blank(lane_history(group, lane)));
    }
  }
}

/// A history that tells of which pair it is.
ContactHistory tagged(const IdPair& pair) {
  const auto a = static_cast<double>(pair.first + 1);
  const auto b = static_cast<double>(pair.second + 1);
  return {{1e-9 * a, -1e-9 * b, 1e-12}, {a, 0.0, b}};
}

bool same(const ContactHistory& a, const ContactHistory& b) { return a.spring == b.spring && a.rolling == b.rolling; }

void give_histories(const Particles& p, PairLists& lists) {
  for (PairGroup& group : lists.groups()) {
    for (std::size_t lane = 0; lane < group.lanes; ++lane) {
      const std::size_t at = lane / block_lanes;
      const std::size_t slot = lane % block_lanes;
      ContactBlock& block = group.blocks[at];
      set_history(block, slot, tagged(ids(p, block.first[slot], block.second[slot])));
    }
  }
}

/// Lanes of the inner lists of which is(pair, history) holds.
template <class Is>
std::size_t count_lanes(const Particles& p, const PairLists& lists, const Is& is) {
  std::size_t count = 0;
  for (const PairGroup& group : lists.groups()) {
    for (std::size_t lane = 0; lane < group.lanes; ++lane) {
      const std::size_t block = lane / block_lanes;
      const std::size_t slot = lane % block_lanes;
      const IdPair pair = ids(p, group.blocks[block].first[slot], group.blocks[block].second[slot]);
      count += is(pair, lane_history(group, lane)) ? 1U : 0U;
    }
  }
  return count;
}

/// Those that remember what tagged() says.
std::size_t faithful_lanes(const Particles& p, const PairLists& lists) {
  return count_lanes(p, lists, [](const IdPair& pair, const ContactHistory& h) { return same(h, tagged(pair)); });
}

std::size_t blank_lanes(const Particles& p, const PairLists& lists) {
  return count_lanes(p, lists, [](const IdPair&, const ContactHistory& h) { return is_blank(h); });
}

TEST(PairLists, HistoriesSurviveANewSelection) {
  const Particles p = random_cloud(41, clouds()[2]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  give_histories(p, lists);
  const std::size_t touching = lists.lanes();
  ASSERT_GT(touching, 200U);
  lists.select_near(spheres(p, outer));  // many more pairs, which remember nothing
  EXPECT_GT(lists.lanes(), touching);
  EXPECT_EQ(faithful_lanes(p, lists), touching);
  lists.select_near(spheres(p, inner));
  EXPECT_EQ(lists.lanes(), touching);
  EXPECT_EQ(faithful_lanes(p, lists), touching);
}

TEST(PairLists, HistoriesFollowTheirPairsWhileOthersComeAndGo) {
  Particles p = random_cloud(46, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  const Particles listed_at = p;
  Draw draw(47);
  PairCount before;
  for (int turn = 0; turn < 20; ++turn) {
    for (std::size_t i = 0; i < p.total(); ++i) {
      p.record[i].position = listed_at.record[i].position + draw.vector(0.1 * p.record[i].radius);
    }
    lists.select_near(spheres(p, inner));
    const PairCount now = inner_pairs(p, lists);
    EXPECT_EQ(now, brute_force(p, inner));
    std::size_t stayed = 0;
    for (const auto& [pair, count] : now) stayed += before.contains(pair) ? 1U : 0U;
    EXPECT_EQ(faithful_lanes(p, lists), stayed);
    EXPECT_EQ(blank_lanes(p, lists), now.size() - stayed);
    if (turn > 0) {
      EXPECT_GT(stayed, 100U);
      EXPECT_GT(now.size(), stayed + 10);     // some have come
      EXPECT_GT(before.size(), stayed + 10);  // and gone
    }
    give_histories(p, lists);
    before = now;
  }
}

// Pairs that come late keep their histories, too, when lanes are given anew, and are listed once.
TEST(PairLists, LatePairsAreListedOnceAndRemember) {
  Particles p = random_cloud(49, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  std::vector<ReachSphere> spheres_now = spheres(p, inner);
  lists.select_near(spheres_now);
  give_histories(p, lists);
  Draw draw(50);
  std::size_t late = 0;
  for (int turn = 0; turn < 60; ++turn) {
    const std::size_t before = lists.lanes();
    std::vector<std::int32_t> moved;
    for (int k = 0; k < 10; ++k) {
      const std::size_t i = draw.below(p.total());  // ghosts as well
      p.record[i].position += draw.vector(0.15 * p.record[i].radius);
      moved.push_back(static_cast<std::int32_t>(i));
    }
    spheres_now = spheres(p, inner);
    lists.add_near(spheres_now, moved);
    late += lists.lanes() - before;
    EXPECT_EQ(faithful_lanes(p, lists), before);
    EXPECT_EQ(blank_lanes(p, lists), lists.lanes() - before);
    give_histories(p, lists);
    const PairCount now = inner_pairs(p, lists);
    for (const auto& [pair, count] : now) EXPECT_EQ(count, 1);
    const PairCount listed_ones = outer_pairs(p, lists);
    for (const auto& [pair, count] : brute_force(p, inner)) {
      EXPECT_TRUE(now.contains(pair) || !listed_ones.contains(pair)) << "turn " << turn;
    }
    if (turn % 10 == 9) {
      lists.select_near(spheres_now);
      EXPECT_EQ(faithful_lanes(p, lists), lists.lanes());
      EXPECT_LT(lists.lanes(), now.size());
    }
  }
  EXPECT_GT(late, 50U);
}

// Lists of some pairs only, to which the rest comes particle by particle, are those of all pairs.
TEST(PairLists, PairsOfSingleParticlesAreListedOnce) {
  for (const CloudOptions& options : clouds()) {
    Particles p = random_cloud(47, options);
    p.owned = p.total();
    PairLists lists;
    lists.build(p, listed(p, inner), nothing(p.owned));
    lists.select_near(spheres(p, inner));
    give_histories(p, lists);
    std::vector<std::vector<std::int32_t>> partners(p.owned);
    for (const auto& [i, j] : listed(p, outer)) {
      partners[static_cast<std::size_t>(i)].push_back(j);
      partners[static_cast<std::size_t>(j)].push_back(i);
    }
    for (std::size_t i = 0; i < p.owned; i += 2) lists.list_more(p, static_cast<std::int32_t>(i), partners[i]);
    lists.select_near(spheres(p, inner));
    EXPECT_EQ(inner_pairs(p, lists), brute_force(p, inner));
    EXPECT_EQ(faithful_lanes(p, lists), lists.lanes());
    std::vector<std::int32_t> all(p.owned);
    for (std::size_t i = 0; i < p.owned; ++i) {
      all[i] = static_cast<std::int32_t>(i);
      lists.list_more(p, all[i], partners[i]);
    }
    EXPECT_EQ(outer_pairs(p, lists), brute_force(p, outer));
    const std::size_t with_history = lists.lanes();
    lists.add_near(spheres(p, outer), all);
    EXPECT_EQ(inner_pairs(p, lists), brute_force(p, outer));
    EXPECT_EQ(faithful_lanes(p, lists), with_history);
    lists.clear();
    lists.build(p, listed(p, outer), nothing(p.owned));
    for (std::size_t i = 0; i < p.owned; ++i) lists.list_more(p, all[i], partners[i]);
    EXPECT_EQ(lists.listed(), brute_force(p, outer).size());
  }
}

TEST(PairLists, NewListsTakeTheMemoryOfTheOldOnes) {
  const Particles p = random_cloud(48, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, outer));
  const ContactBlock* blocks = lists.groups().front().blocks.data();
  const PairGroup::Pair* pairs = lists.groups().front().pairs.data();
  lists.clear();
  EXPECT_EQ(lists.listed(), 0U);
  EXPECT_EQ(lists.lanes(), 0U);
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, outer));
  EXPECT_EQ(lists.groups().front().blocks.data(), blocks);
  EXPECT_EQ(lists.groups().front().pairs.data(), pairs);
}

TEST(PairLists, HistoriesSurviveARebuildInAnotherOrder) {
  Particles p = random_cloud(42, clouds()[2]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  give_histories(p, lists);
  const std::size_t touching = lists.lanes();

  std::vector<std::size_t> order(p.owned);
  for (std::size_t i = 0; i < p.owned; ++i) order[i] = (i * 7 + 3) % p.owned;  // 600 owned: 7 is coprime
  const Csr<PairMemory> in_old_order = lists.memory(p);
  Csr<PairMemory> memory;
  for (const std::size_t i : order) memory.append_row(in_old_order.row(i));
  Particles shuffled = p;
  for (std::size_t i = 0; i < p.owned; ++i) {
    shuffled.record[i] = p.record[order[i]];
    shuffled.id[i] = p.id[order[i]];
    shuffled.material[i] = p.material[order[i]];
  }
  PairLists again;
  again.build(shuffled, listed(shuffled, outer), memory);
  EXPECT_EQ(again.lanes(), touching);  // those that remember, before any selection
  EXPECT_EQ(faithful_lanes(shuffled, again), touching);
  again.select_near(spheres(shuffled, inner));
  EXPECT_EQ(inner_pairs(shuffled, again), brute_force(p, inner));
  EXPECT_EQ(faithful_lanes(shuffled, again), touching);
}

TEST(PairLists, MemoryGoesToEveryOwnedPartner) {
  const Particles p = random_cloud(43, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  give_histories(p, lists);
  const Csr<PairMemory> memory = lists.memory(p);
  ASSERT_EQ(memory.rows(), p.owned);
  PairCount remembered;
  for (std::size_t i = 0; i < p.owned; ++i) {
    for (const PairMemory& m : memory.row(i)) {
      const IdPair pair = std::minmax(p.id[i], m.partner);
      EXPECT_TRUE(same(m.history, tagged(pair)));
      ++remembered[pair];
    }
  }
  std::set<std::int64_t> owned(p.id.begin(), p.id.begin() + static_cast<std::ptrdiff_t>(p.owned));
  PairCount expected = brute_force(p, inner);
  for (auto& [pair, count] : expected) count = owned.contains(pair.first) && owned.contains(pair.second) ? 2 : 1;
  EXPECT_EQ(remembered, expected);
}

TEST(PairLists, BlankHistoriesAreNotRemembered) {
  const Particles p = random_cloud(44, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  EXPECT_TRUE(lists.memory(p).items.empty());
}

TEST(PairLists, CostCountsEachPairOnce) {
  const Particles p = random_cloud(45, clouds()[1]);
  PairLists lists;
  lists.build(p, listed(p, outer), nothing(p.owned));
  lists.select_near(spheres(p, inner));
  std::int64_t total = 0;
  for (const std::int64_t pairs : lists.pairs_of_owned(p)) total += pairs;
  EXPECT_EQ(total, static_cast<std::int64_t>(lists.lanes()));
}

}  // namespace
}  // namespace repose::test
