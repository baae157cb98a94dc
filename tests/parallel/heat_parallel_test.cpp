// Heat has the same bits on any number of ranks, for any lists and vector level, and none of it is lost.
#include <gtest/gtest.h>

#include "heat/heat_figures.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/levels.h"
#include "support/small_discharge.h"

namespace repose::test {
namespace {

/// Grains fall on one another in a vessel without heated walls; some leave, hot or cold.
Deck closed_box(bool crosses_gaps) {
  std::vector<std::string> overrides = {"heat.every=5", "particles.0.temperature=400", "particles.0.heating=3000"};
  for (const char* material : {"material.0", "material.1"}) {
    for (const char* key : {".conductivity=2.0", ".specific_heat=800.0", ".emissivity=0.9"})
      overrides.push_back(std::string(material) + key);
  }
  overrides.push_back("phase.1.heat=[{min=[-1, -1, -1], max=[0, 1, 1], temperature=500, power=1e-4}]");
  if (crosses_gaps) overrides.insert(overrides.end(), {"heat.gas=air", "heat.radiation=true", "heat.max_gap=0.5"});
  return small_discharge(overrides);
}

struct Outcome {
  std::vector<std::string> hashes;
  HeatFigures figures;
};

Outcome run(const Communicator& comm, const Deck& deck, VectorLevel level = best_vector_level()) {
  Simulation simulation(comm, deck, {}, level);
  Outcome outcome;
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    for (int part = 0; part < 2; ++part) {
      simulation.advance(500);
      simulation.check_guards();
      outcome.hashes.push_back(hash_of(simulation));
      outcome.figures = measure_heat(comm, simulation.materials(), *simulation.heat(), simulation.particles());
    }
  }
  return outcome;
}

class HeatOnRanks : public testing::TestWithParam<bool> {};

TEST_P(HeatOnRanks, HasTheBitsOfOne) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  Deck deck = closed_box(GetParam());
  deck.walls[0].heat.enabled = true;
  deck.walls[0].heat.temperature = 900.0;
  deck.walls[1].heat.enabled = true;
  deck.walls[1].heat.type = WallHeatType::power;
  deck.walls[1].heat.power = 1e-4;
  const Outcome together = run(world, deck);
  EXPECT_GT(together.figures.highest, together.figures.lowest + 1.0);
  EXPECT_GT(together.figures.walls[0], 0.0);
  if (world.is_root()) {
    const Outcome alone = run(self, deck);
    EXPECT_EQ(together.hashes, alone.hashes);
    EXPECT_EQ(together.figures.stored, alone.figures.stored);
    EXPECT_EQ(together.figures.mean, alone.figures.mean);
    EXPECT_EQ(together.figures.walls, alone.figures.walls);
  }
  world.barrier();
}

TEST_P(HeatOnRanks, DoesNotDependOnLists) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = closed_box(GetParam());
  const Outcome usual = run(world, deck);
  deck.neighbours.skin = 1.0;
  deck.neighbours.inner_skin = 0.2;
  EXPECT_EQ(usual.hashes, run(world, deck).hashes);
}

INSTANTIATE_TEST_SUITE_P(Contacts, HeatOnRanks, testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Gaps, HeatOnRanks, testing::Values(true));

TEST(HeatParallel, IsTheSameAtAllLevels) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = closed_box(false);
  const Outcome best = run(world, deck);
  for (const VectorLevel level : levels_here()) EXPECT_EQ(run(world, deck, level).hashes, best.hashes);
}

TEST(HeatParallel, ConservesEveryUnit) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = closed_box(true);
  deck.particles[0].heating = 0.0;
  deck.domain.min = {-0.01, -0.01, -0.001};
  ParticlesDeck hot = deck.particles[0];
  hot.temperature = 1200.0;
  hot.count = 40;
  hot.mass = unset;
  hot.centre.z += hot.height + 0.001;
  deck.particles.push_back(hot);
  Simulation simulation(world, deck, {}, best_vector_level());
  const auto stored = [&] {
    return measure_heat(world, simulation.materials(), *simulation.heat(), simulation.particles());
  };
  const HeatFigures before = stored();
  simulation.advance(4500);
  simulation.check_guards();
  const HeatFigures after = stored();  // which would throw if one unit were lost
  EXPECT_EQ(before.stored, after.stored);
  EXPECT_LT(after.highest, before.highest);
}

TEST(HeatParallel, LeavesTheStateOfOthersAlone) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = closed_box(false);
  Deck cold = deck;
  cold.heat.enabled = false;
  Simulation with(world, deck, {}, best_vector_level());
  Simulation without(world, cold, {}, best_vector_level());
  with.advance(1000);
  without.advance(1000);
  ASSERT_EQ(with.particles().owned, without.particles().owned);
  EXPECT_GT(world.sum(static_cast<std::int64_t>(with.particles().owned)), 0);
  for (std::size_t i = 0; i < with.particles().owned; ++i) {
    ASSERT_EQ(with.particles().id[i], without.particles().id[i]);
    ASSERT_EQ(with.particles().record[i].position, without.particles().record[i].position);
  }
}

}  // namespace
}  // namespace repose::test
