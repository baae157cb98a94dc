#pragma once

#include <map>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "simulation/simulation.h"

namespace repose::test {

/// A particle of a small scene.
struct Grain {
  Vec3 position;
  Vec3 velocity;
  Vec3 spin;
  double radius;
};

/// A deck with one material for the grains ("grain") and one for the walls ("wall"), whose pairs have the given
/// coefficients, in a large domain without gravity, walls or particles; `timestep` s is given.
struct Coefficients {
  double youngs_modulus = 5e6;
  double poisson_ratio = 0.3;
  double density = 3592.0;
  double restitution_pp = 0.5;
  double restitution_pw = 0.6;
  double sliding_pp = 0.827;
  double sliding_pw = 0.43314;
  double rolling_pp = 0.172;
  double rolling_pw = 0.12757;
};
Deck bare_deck(const Coefficients& c, double timestep);

/// The same with particles from the list "grains.csv" and one phase of so many steps: a deck that can be run.
Deck listed_deck(double timestep, std::int64_t steps);

/// The plane z = height, of material "wall".
WallDeck floor_at(double height);

/// A simulation on all ranks of MPI_COMM_WORLD, with its particles from a list (all of material "grain"). `files` holds
/// the texts of other files that the deck names.
class Scene {
 public:
  Scene(Deck deck, const std::vector<Grain>& grains, VectorLevel level = best_vector_level(),
        const std::map<std::string, std::string>& files = {});

  Simulation& simulation() { return simulation_; }
  void run(std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; ++k) simulation_.step();
    simulation_.check_guards();
  }
  /// All particles in the order of their ids, on every rank; small scenes only.
  std::vector<Grain> grains() const;

 private:
  Communicator comm_;
  Simulation simulation_;
};

}  // namespace repose::test
