// The state after n steps has the same bits on any number of ranks: each test runs the same case on all ranks and, on
// rank 0, alone.
#include <gtest/gtest.h>

#include "node_ranks.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/small_discharge.h"

namespace repose::test {
namespace {

struct Outcome {
  std::vector<std::string> hashes;
  std::int64_t left = 0;
  RunCounters counters;
};

Outcome run(const Communicator& comm, const Deck& deck, VectorLevel level = best_vector_level()) {
  Simulation simulation(comm, deck, {}, level);
  Outcome outcome;
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    for (int part = 0; part < 4; ++part) {
      for (int step = 0; step < 2000; ++step) simulation.step();
      simulation.check_guards();
      outcome.hashes.push_back(hash_of(simulation));
    }
  }
  for (const std::int64_t n : simulation.left_here().particles) outcome.left += n;
  outcome.left = comm.sum(outcome.left);
  outcome.counters = simulation.counters();
  return outcome;
}

TEST(Determinism, SameBitsOnAllRanksAsOnOne) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const Deck deck = small_discharge();
  const Outcome together = run(world, deck);
  EXPECT_GT(together.left, 20);  // the gate has opened and grains have left
  EXPECT_GT(together.counters.rebuilds, 20);
  EXPECT_GT(world.sum(together.counters.outer_renewals), world.size() == 1 ? 1000 : 0);  // few are clear of other ranks
  if (world.size() > 1) {
    EXPECT_GT(together.counters.bisections, 2);
  }
  if (world.is_root()) {
    const Outcome alone = run(self, deck);
    EXPECT_EQ(together.hashes, alone.hashes);
    EXPECT_EQ(together.left, alone.left);
    for (std::size_t k = 1; k < alone.hashes.size(); ++k) EXPECT_NE(alone.hashes[k], alone.hashes[k - 1]);
  }
  world.barrier();
}

TEST(Determinism, SameBitsWhateverTheLists) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = small_discharge();
  const Outcome usual = run(world, deck);
  deck.neighbours.skin = 1.0;
  deck.neighbours.inner_skin = 0.2;
  deck.neighbours.max_imbalance = 1.5;
  const Outcome other = run(world, deck);
  EXPECT_EQ(usual.hashes, other.hashes);
  EXPECT_NE(usual.counters.rebuilds, other.counters.rebuilds);
}

TEST(Determinism, SameBitsAtEveryVectorLevel) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = small_discharge();
  const Outcome plain = run(world, deck, VectorLevel::sse2);
  EXPECT_EQ(plain.hashes, run(world, deck, best_vector_level()).hashes);
}

TEST(Determinism, SameBitsHoweverGhostsTravel) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = small_discharge();
  const Outcome by_memory = run(world, deck);
  for (const int most : {1, 2}) {
    const NodeRanks node(most);
    EXPECT_EQ(by_memory.hashes, run(world, deck).hashes) << most;
  }
}

TEST(Determinism, MoreRanksThanParticles) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  Deck deck = small_discharge();
  deck.particles[0].mass = std::numeric_limits<double>::quiet_NaN();
  deck.particles[0].count = 3;
  const Outcome together = run(world, deck);
  if (world.is_root()) {
    EXPECT_EQ(together.hashes, run(self, deck).hashes);
  }
  world.barrier();
}

}  // namespace
}  // namespace repose::test
