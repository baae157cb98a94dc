// Particles that change their rank, with their memories, and the ghosts around each rank.
#include "domain/migration.h"

#include <chrono>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "domain/ghost_exchange.h"
#include "domain_samples.h"
#include "node_ranks.h"

namespace repose::test {
namespace {

/// Every id of `expected` is owned exactly once over all ranks.
void expect_each_owned_once(const Communicator& world, const Particles& particles,
                            const std::set<std::int64_t>& expected) {
  const std::vector<std::int64_t> mine(particles.id.begin(),
                                       particles.id.begin() + static_cast<std::ptrdiff_t>(particles.owned));
  const std::vector<std::int64_t> all = world.gather(mine);
  if (!world.is_root()) return;
  EXPECT_EQ(all.size(), expected.size());
  EXPECT_EQ(std::set<std::int64_t>(all.begin(), all.end()), expected);
}

std::set<std::int64_t> ids_up_to(std::int64_t count) {
  std::set<std::int64_t> ids;
  for (std::int64_t id = 0; id < count; ++id) ids.insert(id);
  return ids;
}

/// Material and memories are still those that the id says.
void expect_luggage(const Particles& particles, const ContactMemory& memory) {
  ASSERT_EQ(memory.pairs.rows(), particles.owned);
  ASSERT_EQ(memory.walls.rows(), particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    Particles alone;
    ContactMemory expected;
    add_sample(particles.id[i], alone, expected);
    EXPECT_EQ(particles.material[i], alone.material[0]);
    ASSERT_EQ(memory.pairs.row(i).size(), expected.pairs.row(0).size());
    for (std::size_t k = 0; k < memory.pairs.row(i).size(); ++k) {
      EXPECT_EQ(memory.pairs.row(i)[k].partner, expected.pairs.row(0)[k].partner);
      EXPECT_TRUE(same(memory.pairs.row(i)[k].history, expected.pairs.row(0)[k].history));
    }
    ASSERT_EQ(memory.walls.row(i).size(), expected.walls.row(0).size());
    for (std::size_t k = 0; k < memory.walls.row(i).size(); ++k) {
      EXPECT_EQ(memory.walls.row(i)[k].wall, expected.walls.row(0)[k].wall);
      EXPECT_EQ(memory.walls.row(i)[k].feature, expected.walls.row(0)[k].feature);
      EXPECT_TRUE(same(memory.walls.row(i)[k].history, expected.walls.row(0)[k].history));
    }
  }
}

void expect_at_home(const Communicator& world, const Particles& particles, const Decomposition& tree) {
  EXPECT_EQ(particles.total(), particles.owned);
  EXPECT_EQ(particles.record.size(), particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    EXPECT_EQ(tree.owner(particles.record[i].position), world.rank());
  }
}

class Migration : public ::testing::Test {
 protected:
  const Communicator world{MPI_COMM_WORLD};
};

TEST_F(Migration, EveryParticleArrivesOnceWithItsMemories) {
  for (const std::int64_t count : {0, 1, 3, 2000}) {
    ContactMemory memory;
    Particles particles = dealt_out(world, count, memory);
    const Decomposition tree = bisect(world, particles);
    migrate(world, tree, particles, memory);
    expect_each_owned_once(world, particles, ids_up_to(count));
    expect_at_home(world, particles, tree);
    expect_luggage(particles, memory);
    for (std::size_t i = 0; i < particles.owned; ++i) {
      EXPECT_TRUE(same(particles.record[i], sample(particles.id[i]).record));
    }
  }
}

TEST_F(Migration, FollowsMovingParticles) {
  ContactMemory memory;
  Particles particles = dealt_out(world, 500, memory);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < particles.owned; ++i) {
      particles.record[i].position += 0.05 * particles.record[i].velocity;
    }
    const Decomposition tree = bisect(world, particles);
    migrate(world, tree, particles, memory);
    expect_each_owned_once(world, particles, ids_up_to(500));
    expect_at_home(world, particles, tree);
    expect_luggage(particles, memory);
  }
}

TEST_F(Migration, DropsParkedParticlesAndGhosts) {
  ContactMemory memory;
  Particles particles = dealt_out(world, 300, memory);
  const Decomposition tree = bisect(world, particles);
  migrate(world, tree, particles, memory);
  GhostExchange ghosts(world);
  ghosts.set_up(tree, {0.3, 0.0}, particles);
  std::set<std::int64_t> expected = ids_up_to(300);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (particles.id[i] % 5 == 0) park(particles.record[i], particles.id[i]);
  }
  for (std::int64_t id = 0; id < 300; id += 5) expected.erase(id);
  migrate(world, tree, particles, memory);
  expect_each_owned_once(world, particles, expected);
  expect_at_home(world, particles, tree);
  expect_luggage(particles, memory);
}

TEST_F(Migration, TheOrderDoesNotDependOnTheWayThere) {
  ContactMemory memory;
  Particles in_turn = dealt_out(world, 400, memory);
  const Decomposition tree = bisect(world, in_turn);
  migrate(world, tree, in_turn, memory);

  Particles from_one;
  ContactMemory other_memory;
  if (world.is_root()) {
    for (std::int64_t id = 399; id >= 0; --id) add_sample(id, from_one, other_memory);
  }
  migrate(world, tree, from_one, other_memory);
  EXPECT_EQ(in_turn.id, from_one.id);
}

constexpr SkinRule rule = {0.3, 1e-4};

/// Migrated particles with their ghosts; `reach` as set_up returned it.
struct Shell {
  Particles particles;
  Decomposition tree;
  GhostExchange ghosts;
  std::vector<double> reach;

  Shell(const Communicator& world, std::int64_t count) : ghosts(world) {
    ContactMemory memory;
    particles = dealt_out(world, count, memory);
    tree = bisect(world, particles);
    migrate(world, tree, particles, memory);
    reach = ghosts.set_up(tree, rule, particles);
  }
};

void expect_complete(const Communicator& world, const Shell& shell, std::int64_t count) {
  const Particles& p = shell.particles;
  ASSERT_EQ(shell.reach.size(), p.total());
  std::map<std::int64_t, std::size_t> held;
  for (std::size_t i = 0; i < p.total(); ++i) {
    EXPECT_FALSE(held.contains(p.id[i])) << "particle " << p.id[i] << " is held twice";
    held[p.id[i]] = i;
    const Sample s = sample(p.id[i]);
    EXPECT_TRUE(same(p.record[i], s.record));
    EXPECT_EQ(p.material[i], s.material);
    EXPECT_EQ(shell.reach[i], reach_of(s.record, rule));
    EXPECT_EQ(i < p.owned, shell.tree.owner(s.record.position) == world.rank());
  }
  for (std::int64_t id = 0; id < count; ++id) {
    if (held.contains(id)) continue;
    const ParticleRecord other = sample(id).record;
    for (std::size_t i = 0; i < p.owned; ++i) {
      const double limit = shell.reach[i] + reach_of(other, rule);
      EXPECT_GE(squared_norm(p.record[i].position - other.position), limit * limit)
          << "particle " << id << " is missed by particle " << p.id[i];
    }
  }
}

/// With so many ranks that share memory.
class Ghosts : public ::testing::TestWithParam<int> {
 protected:
  const NodeRanks node{GetParam()};
  const Communicator world{MPI_COMM_WORLD};
};

TEST_P(Ghosts, EveryPairWithinReachIsHere) {
  for (const std::int64_t count : {0, 1, 2, 3, 20, 1500}) {
    const Shell shell(world, count);
    expect_complete(world, shell, count);
  }
}

TEST_P(Ghosts, AreAShellNotEverything) {
  const Shell shell(world, 3000);
  const std::int64_t ghosts = world.sum(static_cast<std::int64_t>(shell.particles.ghosts()));
  if (world.size() == 1) {
    EXPECT_EQ(ghosts, 0);
  } else {
    EXPECT_GT(ghosts, 10);
    EXPECT_LT(ghosts, 3000 * (world.size() - 1) / 2);
  }
}

TEST_P(Ghosts, MotionArrivesEveryTime) {
  Shell shell(world, 600);
  Particles& p = shell.particles;
  for (int round = 1; round <= 20; ++round) {
    const auto position = [&](std::int64_t id) { return Vec3{1.0 * round, static_cast<double>(id), 0.5}; };
    for (std::size_t i = 0; i < p.owned; ++i) {
      p.record[i].position = position(p.id[i]);
      p.record[i].velocity = 2.0 * position(p.id[i]);
      p.record[i].spin = -3.0 * position(p.id[i]);
    }
    shell.ghosts.start(p);
    shell.ghosts.finish(p);
    for (std::size_t i = 0; i < p.total(); ++i) {
      EXPECT_EQ(p.record[i].position, position(p.id[i]));
      EXPECT_EQ(p.record[i].velocity, 2.0 * position(p.id[i]));
      EXPECT_EQ(p.record[i].spin, -3.0 * position(p.id[i]));
      EXPECT_EQ(p.record[i].radius, sample(p.id[i]).record.radius);
      EXPECT_EQ(p.record[i].force_scale, sample(p.id[i]).record.force_scale);
    }
  }
}

// A thousand ghosts: more than what a rank can send without the other's help.
TEST_P(Ghosts, MotionArrivesWithoutWaiting) {
  Shell shell(world, 6000);
  Particles& p = shell.particles;
  for (std::size_t i = 0; i < p.owned; ++i) p.record[i].spin = {1.0, static_cast<double>(p.id[i]), 0.5};
  shell.ghosts.start(p);
  const auto begin = std::chrono::steady_clock::now();
  bool arrived = false;
  while (!arrived && std::chrono::steady_clock::now() - begin < std::chrono::seconds(60))
    arrived = shell.ghosts.advance();
  EXPECT_TRUE(arrived);
  shell.ghosts.finish(p);
  for (std::size_t i = 0; i < p.total(); ++i) EXPECT_EQ(p.record[i].spin.y, static_cast<double>(p.id[i]));
}

TEST_P(Ghosts, OnlyThoseThatAreKeptTravel) {
  Shell shell(world, 400);
  Particles& p = shell.particles;
  std::vector<bool> needed;
  std::vector<std::int64_t> expected(p.id.begin(), p.id.begin() + static_cast<std::ptrdiff_t>(p.owned));
  for (std::size_t i = p.owned; i < p.total(); ++i) {
    needed.push_back((p.id[i] + world.rank()) % 3 == 0);  // the ranks want different ones
    if (needed.back()) expected.push_back(p.id[i]);
  }
  shell.ghosts.keep(needed, p);
  EXPECT_EQ(p.id, expected);
  const auto spin = [](std::int64_t id) { return Vec3{1.0, static_cast<double>(id), 0.5}; };
  for (std::size_t i = 0; i < p.owned; ++i) p.record[i].spin = spin(p.id[i]);
  shell.ghosts.start(p);
  shell.ghosts.finish(p);
  for (std::size_t i = 0; i < p.total(); ++i) {
    EXPECT_EQ(p.record[i].spin, spin(p.id[i]));
    EXPECT_EQ(p.record[i].radius, sample(p.id[i]).record.radius);
    EXPECT_EQ(p.material[i], sample(p.id[i]).material);
  }
}

TEST_P(Ghosts, CanBeSetUpAgain) {
  Shell shell(world, 400);
  for (int round = 0; round < 4; ++round) {
    ContactMemory memory;
    for (std::size_t i = 0; i < shell.particles.owned; ++i) {
      memory.pairs.append_row({});
      memory.walls.append_row({});
    }
    shell.tree = bisect(world, shell.particles);
    migrate(world, shell.tree, shell.particles, memory);
    shell.reach = shell.ghosts.set_up(shell.tree, rule, shell.particles);
    expect_complete(world, shell, 400);
    shell.ghosts.start(shell.particles);
    shell.ghosts.finish(shell.particles);
    expect_complete(world, shell, 400);
  }
}

// A particle parked by its owner is out of reach on every rank after the next exchange.
TEST_P(Ghosts, ParkedParticlesAreParkedEverywhere) {
  Shell shell(world, 300);
  Particles& p = shell.particles;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (p.id[i] % 2 == 0) park(p.record[i], p.id[i]);
  }
  shell.ghosts.start(p);
  shell.ghosts.finish(p);
  for (std::size_t i = 0; i < p.total(); ++i) EXPECT_EQ(is_parked(p.record[i]), p.id[i] % 2 == 0);
}

INSTANTIATE_TEST_SUITE_P(NodeRanks, Ghosts, ::testing::Values(1, 2, 1000), ::testing::PrintToStringParamName());

}  // namespace
}  // namespace repose::test
