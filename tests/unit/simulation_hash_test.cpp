// The state hash: what it sees and what it must not see.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "measurement/state_hash.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;

struct State {
  Particles particles;
  PairLists pairs;
  WallContacts wall_contacts;
  Csr<PairMemory> pair_memory;
  Csr<WallMemory> wall_memory;
  std::vector<Wall> walls;

  std::string hash() {
    const std::vector<double> reach(particles.owned, 1.5 * radius);
    pairs.build(particles, near_pairs(std::span(particles.record).first(particles.total()), reach, particles.owned),
                pair_memory);
    wall_contacts.build(particles, walls, reach, wall_memory);
    return state_hash(Communicator(MPI_COMM_WORLD), particles, pairs, wall_contacts);
  }
};

constexpr ContactHistory some_history = {{1e-9, 2e-9, 3e-9}, {4e-9, 5e-9, 6e-9}};

/// Grains `order` of three in a row above a floor; 0 remembers 1, and 1 the floor.
State three_grains(const std::vector<std::int64_t>& order) {
  State s;
  for (const std::int64_t id : order) {
    const auto n = static_cast<double>(id);
    s.particles.record.push_back({{2.0 * radius * n, 0.0, radius}, radius, {n, 2.0, -1.0}, 1.0, {3.0, -n, 4.0}, 1.0});
    s.particles.id.push_back(id);
    s.particles.material.push_back(0);
    ++s.particles.owned;
    std::vector<PairMemory> pairs;
    if (id < 2) pairs.push_back({1 - id, some_history});
    s.pair_memory.append_row(pairs);
    std::vector<WallMemory> walls;
    if (id == 1) walls.push_back({0, 0, some_history});
    s.wall_memory.append_row(walls);
  }
  s.walls.push_back(make_wall(floor_at(0.0), 1));
  add_lane_dummies(s.particles);
  return s;
}

TEST(StateHash, DoesNotDependOnTheOrder) {
  const std::string hash = three_grains({0, 1, 2}).hash();
  EXPECT_EQ(hash.size(), 32U);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(three_grains({2, 0, 1}).hash(), hash);
  EXPECT_EQ(three_grains({1, 2, 0}).hash(), hash);
}

/// The next double: one bit, or a few by carry.
void nudge(double& value) { value = std::nextafter(value, 1e300); }

TEST(StateHash, SeesTheLastBitOfEverything) {
  const std::string reference = three_grains({0, 1, 2}).hash();
  std::vector<std::string> hashes = {reference};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int component = 0; component < 9; ++component) {
      State s = three_grains({0, 1, 2});
      ParticleRecord& p = s.particles.record[i];
      double* all[] = {&p.position.x, &p.position.y, &p.position.z, &p.velocity.x, &p.velocity.y,
                       &p.velocity.z, &p.spin.x,     &p.spin.y,     &p.spin.z};
      nudge(*all[component]);
      hashes.push_back(s.hash());
    }
  }
  for (int component = 0; component < 6; ++component) {
    for (const bool wall : {false, true}) {
      State s = three_grains({0, 1, 2});
      ContactHistory& h = wall ? s.wall_memory.items[0].history : s.pair_memory.items[0].history;
      double* all[] = {&h.spring.x, &h.spring.y, &h.spring.z, &h.rolling.x, &h.rolling.y, &h.rolling.z};
      nudge(*all[component]);
      hashes.push_back(s.hash());
    }
  }
  State other_id = three_grains({0, 1, 2});
  other_id.particles.id[2] = 3;
  hashes.push_back(other_id.hash());
  State swapped = three_grains({0, 1, 2});
  std::swap(swapped.particles.record[1], swapped.particles.record[2]);
  hashes.push_back(swapped.hash());
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

TEST(StateHash, LeavesOutWhoHasLeft) {
  State with = three_grains({0, 1, 2});
  park(with.particles.record[2], 2);
  State without = three_grains({0, 1});
  EXPECT_EQ(with.hash(), without.hash());
}

}  // namespace
}  // namespace repose::test
