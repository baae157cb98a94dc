// With none of the contact law's defaults the state still has the same bits on any number of ranks and vector level.
#include "support/contact_options.h"

#include <gtest/gtest.h>

#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/small_discharge.h"

namespace repose::test {
namespace {

Deck small_bed() { return small_discharge({"time.step=4e-6"}); }

std::vector<std::string> hashes(const Communicator& comm, const Deck& deck, VectorLevel level = best_vector_level()) {
  Simulation simulation(comm, deck, {}, level);
  std::vector<std::string> all;
  for (int part = 0; part < 4; ++part) {
    if (part == 2) simulation.set_wall_present("lid", false);
    simulation.advance(1500);
    simulation.check_guards();
    all.push_back(hash_of(simulation));
  }
  return all;
}

void expect_same_bits_as_on_one(const Deck& deck) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const std::vector<std::string> together = hashes(world, deck);
  if (world.is_root()) {
    EXPECT_EQ(together, hashes(self, deck));
  }
  world.barrier();
}

TEST(ContactOptions, SameBitsOnAllRanksAsOnOne) { expect_same_bits_as_on_one(with_all_options(small_bed())); }

TEST(ContactModels, SameBitsOnAllRanksAsOnOne) {
  for (const Deck& deck : {with_cohesive_models(small_bed()), with_adhesion(small_bed()), with_bridges(small_bed())}) {
    expect_same_bits_as_on_one(deck);
  }
}

TEST(ContactModels, SameBitsWhateverTheListsAndTheLevel) {
  const Communicator world(MPI_COMM_WORLD);
  for (Deck deck : {with_cohesive_models(small_bed()), with_adhesion(small_bed()), with_bridges(small_bed())}) {
    const std::vector<std::string> usual = hashes(world, deck);
    deck.neighbours.skin = 1.0;
    deck.neighbours.inner_skin = 0.2;
    EXPECT_EQ(usual, hashes(world, deck, VectorLevel::sse2));
  }
}

TEST(ContactOptions, SameBitsWhateverTheListsAndTheLevel) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = with_all_options(small_bed());
  const std::vector<std::string> usual = hashes(world, deck);
  deck.neighbours.skin = 1.0;
  deck.neighbours.inner_skin = 0.2;
  EXPECT_EQ(usual, hashes(world, deck, VectorLevel::sse2));
  deck.time.integrator = Integrator::velocity_verlet;
  EXPECT_NE(usual, hashes(world, deck));
}

}  // namespace
}  // namespace repose::test
