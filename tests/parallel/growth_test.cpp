// Particles that grow: by how much, of what mass, and with the same bits on any number of ranks.
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/particles/sphere_mass.h"
#include "simulation/phases.h"
#include "simulation/setup.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/levels.h"
#include "support/small_discharge.h"

namespace repose::test {
namespace {

Deck growing(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides = {"phase.0.growth.factor=1.004", "phase.0.growth.every=30", "phase.0.min_time=0",
                                        "phase.0.max_time=0.012"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return small_discharge(overrides);
}

std::vector<std::string> hashes(const Communicator& comm, const Deck& deck, VectorLevel level = best_vector_level()) {
  Simulation simulation(comm, deck, {}, level);
  std::vector<std::string> found;
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    for (int part = 0; part < 2; ++part) {
      simulation.advance(700);
      simulation.check_guards();
      found.push_back(hash_of(simulation));
    }
  }
  return found;
}

TEST(Growth, MakesAllDiametersLarger) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = growing();
  Simulation simulation(world, deck, {}, best_vector_level());
  const double before = 0.5 * deck.particles[0].diameter;
  const Phase phase(deck.phases[0], simulation);
  simulation.advance(29);
  for (std::size_t i = 0; i < simulation.particles().owned; ++i)
    ASSERT_EQ(simulation.particles().record[i].radius, before);
  simulation.advance(631);  // 660 steps
  double radius = before;
  for (int time = 0; time < 22; ++time) radius *= 1.004;
  const Particles& particles = simulation.particles();
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ASSERT_EQ(particles.record[i].radius, radius);
    const double density = simulation.materials()[static_cast<std::size_t>(particles.material[i])].density;
    const double mass = 1.0 / (particles.force_to_acceleration[i] * particles.record[i].force_scale);
    ASSERT_NEAR(mass / sphere_mass(radius, density), 1.0, 1e-15);
  }
}

TEST(Growth, HasTheBitsOfOneRank) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  Deck deck = growing();
  const std::vector<std::string> together = hashes(world, deck);
  if (world.is_root()) {
    EXPECT_EQ(together, hashes(self, deck));
  }
  for (const VectorLevel level : levels_here()) EXPECT_EQ(together, hashes(world, deck, level));
  deck.neighbours.skin = 1.0;
  deck.neighbours.inner_skin = 0.2;
  EXPECT_EQ(together, hashes(world, deck));
  deck.phases[0].growth.enabled = false;
  EXPECT_NE(together, hashes(world, deck));
}

TEST(Growth, HasAnEnd) {
  const auto growth_of = [](const std::vector<std::string>& more) { return greatest_growth(growing(more), 1e-5); };
  EXPECT_NEAR(growth_of({"phase.0.max_time=0.09"}), std::pow(1.004, 300), 1e-9);
  try {
    growth_of({"phase.0.max_time=0.9"});
    FAIL() << "nothing was thrown";
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 10; shorten the phase"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace repose::test
