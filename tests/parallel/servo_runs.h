#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "measurement/wall_loads.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"

namespace repose::test {

/// What became of a run whose second wall has a servo.
struct ServoOutcome {
  std::vector<std::string> ended_by;
  std::vector<std::string> hashes;  ///< at the end of each phase
  std::vector<double> ways;         ///< of the servo (m or rad), in the phase "rest"
  std::vector<double> loads;        ///< as told by `load`, in the same
};

/// Collective. Runs a deck given as a text; `load` makes a number of the loads on its walls.
template <class Load>
ServoOutcome run_servo(const Communicator& comm, const std::string& text, const std::vector<std::string>& overrides,
                       VectorLevel level, Load&& load) {
  const Deck deck = read_deck(text, "scene.toml", overrides);
  Simulation s(comm, deck, {}, level);
  ServoOutcome outcome;
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, s);
    while (true) {
      if (const auto ended = phase.ended_by(s, deck.run.check_every)) {
        outcome.ended_by.push_back(*ended);
        break;
      }
      s.advance(100);
      s.check_guards();
      if (phase_deck.name != "rest") continue;
      outcome.ways.push_back(s.walls()[1].servo->way());
      outcome.loads.push_back(
          load(measure_wall_loads(comm, level, s.walls(), s.materials(), s.particles(), s.wall_contacts())));
    }
    outcome.hashes.push_back(hash_of(s));
  }
  return outcome;
}

using ServoRun =
    std::function<ServoOutcome(const Communicator&, const std::vector<std::string>& overrides, VectorLevel)>;

/// Collective. That the run on all ranks has the bits of one rank.
inline void expect_the_bits_of_one_rank(const ServoRun& run) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const ServoOutcome together = run(world, {}, best_vector_level());
  if (world.is_root()) {
    const ServoOutcome alone = run(self, {}, best_vector_level());
    EXPECT_EQ(alone.hashes, together.hashes);
    EXPECT_EQ(alone.ways, together.ways);
    EXPECT_EQ(alone.loads, together.loads);
  }
  world.barrier();
}

/// That neither lists nor vectors change its bits; on one rank.
inline void expect_the_bits_of_other_lists_and_vectors(const ServoRun& run) {
  const Communicator world(MPI_COMM_WORLD);
  if (world.size() > 1) return;
  const ServoOutcome plain = run(world, {}, best_vector_level());
  for (const ServoOutcome& other :
       {run(world, {"neighbours.skin=0.8", "neighbours.inner_skin=0.1"}, best_vector_level()),
        run(world, {}, VectorLevel::sse2)}) {
    EXPECT_EQ(other.hashes, plain.hashes);
    EXPECT_EQ(other.ways, plain.ways);
  }
}

}  // namespace repose::test
