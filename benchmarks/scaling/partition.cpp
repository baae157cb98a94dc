// Divides the particles of snapshots into parts, one per rank of an imagined run, by the decomposition of the program,
// and prints as JSON what each division asks of its parts: `repose_partition PARTS SNAPSHOT...`, PARTS such as
// 8,64,512. Every snapshot is divided by new planes ("new"), by those of the first one ("first"), and by those of a run
// that balances its load at each of the snapshots before, when it is out of bounds ("bound"). One process, one core.

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <mpi.h>
#include <nlohmann/json.hpp>

#include "deck/read_deck.h"
#include "domain/decomposition.h"
#include "domain/ghost_exchange.h"
#include "files/shared_file.h"
#include "output/file_contents.h"
#include "simulation/rank_load.h"
#include "simulation/simulation.h"
#include "tool.h"

namespace {

using namespace repose;
using Json = nlohmann::ordered_json;

std::size_t index(std::int64_t i) { return static_cast<std::size_t>(i); }

/// The state of a snapshot with the lists that a run would make of it.
class State {
 public:
  State(const Communicator& comm, const std::string& path) : State(comm, path, read_whole_file(path)) {}

  const Simulation& simulation() const { return simulation_; }
  const Particles& particles() const { return simulation_.particles(); }
  std::int64_t step() const { return contents_.step; }
  double time() const { return contents_.time_s; }

 private:
  State(const Communicator& comm, const std::string& path, const std::string& bytes)
      : contents_(file_contents(bytes, path)),
        simulation_(
            comm, deck_of(contents_, path), [&](const std::string&) { return bytes; }, best_vector_level()) {}

  /// The snapshot's own deck, but with the snapshot for particles and without walls that a phase removes.
  static Deck deck_of(const FileContents& contents, const std::string& path) {
    Deck deck = read_deck(contents.deck, path, {});
    ParticlesDeck particles;
    particles.type = ParticlesType::snapshot;
    particles.file = path;
    deck.particles = {particles};
    for (const PhaseDeck& phase : deck.phases) {
      for (const std::string& name : phase.remove_walls) {
        std::erase_if(deck.walls, [&](const WallDeck& wall) { return wall.name == name; });
      }
    }
    return deck;
  }

  FileContents contents_;
  Simulation simulation_;
};

/// What a division asks of one part.
struct Part {
  std::int64_t cost = 0;   ///< as the decomposition counts it
  std::int64_t pairs = 0;  ///< to evaluate, those across a boundary on both sides
  std::int64_t ghosts = 0;
  std::int64_t sent = 0;  ///< particles that are ghosts elsewhere, once for each place
  std::set<int> neighbours;
};

/// Calls visit(pair) for all listed pairs.
template <class Visit>
void for_each_pair(const State& state, const Visit& visit) {
  for (const PairGroup& group : state.simulation().pairs().groups()) {
    for (const PairGroup::Pair& pair : group.pairs) visit(pair);
  }
}

std::vector<int> owners(const Decomposition& division, const Particles& particles) {
  std::vector<int> owner(particles.owned);
  for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = division.owner(particles.record[i].position);
  return owner;
}

/// Of each particle, as its owner counts it.
std::vector<std::int64_t> costs(const State& state, const std::vector<int>& owner) {
  std::vector<std::int64_t> cost = cost_of_owned(state.simulation().pairs(), state.particles());
  for_each_pair(state, [&](const PairGroup::Pair& pair) {
    const bool is_shared = owner[index(pair.first)] != owner[index(pair.second)];
    if (pair.lane >= 0 && is_shared) ++cost[index(pair.second)];
  });
  return cost;
}

/// Divided as in a run: what a particle costs follows from the division before.
Decomposition divide(const Communicator& comm, const State& state, int parts) {
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < state.particles().owned; ++i) positions.push_back(state.particles().record[i].position);
  Decomposition division(parts);
  for (int round = 0; round < 3; ++round) {
    division = Decomposition::bisect(comm, parts, positions, costs(state, owners(division, state.particles())));
  }
  return division;
}

std::vector<Part> parts_of(const State& state, const Decomposition& division, int parts) {
  const std::vector<int> owner = owners(division, state.particles());
  std::vector<Part> result(index(parts));
  const std::vector<std::int64_t> cost = costs(state, owner);
  for (std::size_t i = 0; i < owner.size(); ++i) result[index(owner[i])].cost += cost[i];

  std::vector<std::array<std::int32_t, 2>> ghosts;  // the part that has it, the particle
  for_each_pair(state, [&](const PairGroup::Pair& pair) {
    const int a = owner[index(pair.first)];
    const int b = owner[index(pair.second)];
    if (pair.lane >= 0) ++result[index(a)].pairs;
    if (a == b) return;
    if (pair.lane >= 0) ++result[index(b)].pairs;
    ghosts.push_back({a, pair.second});
    ghosts.push_back({b, pair.first});
  });
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  for (const auto& [part, particle] : ghosts) {
    Part& source = result[index(owner[index(particle)])];
    ++result[index(part)].ghosts;
    ++source.sent;
    source.neighbours.insert(part);
  }
  return result;
}

struct Figure {
  double mean;
  double max;
};

template <class Of>
Figure figure(const std::vector<Part>& parts, const Of& of) {
  Figure f = {0.0, 0.0};
  for (const Part& part : parts) {
    const auto value = static_cast<double>(of(part));
    f.mean += value / static_cast<double>(parts.size());
    f.max = std::max(f.max, value);
  }
  return f;
}

Json json_of(const Figure& f) { return {{"mean", f.mean}, {"max", f.max}}; }

Json row(const State& state, const Decomposition& division, int count, const char* planes) {
  const std::vector<Part> parts = parts_of(state, division, count);
  const auto particles = static_cast<double>(state.particles().owned);
  const Figure cost = figure(parts, [](const Part& p) { return p.cost; });
  const Figure pairs = figure(parts, [](const Part& p) { return p.pairs; });
  const Figure ghosts = figure(parts, [](const Part& p) { return p.ghosts; });
  const auto of_lists = static_cast<double>(state.simulation().pairs().lanes());
  return {
      {"step", state.step()},
      {"time_s", state.time()},
      {"particles", state.particles().owned},
      {"parts", count},
      {"planes", planes},
      {"cost_imbalance", cost.max / cost.mean},
      {"pair_imbalance", pairs.max / pairs.mean},
      {"pairs_per_particle", of_lists / particles},
      {"pairs_evaluated_over_pairs", pairs.mean * count / of_lists},
      {"ghosts_per_particle", ghosts.mean * count / particles},
      {"ghosts", json_of(ghosts)},
      {"neighbours", json_of(figure(parts, [](const Part& p) { return p.neighbours.size(); }))},
      {"bytes_per_step", json_of(figure(parts, [](const Part& p) { return p.sent * std::int64_t{sizeof(Motion)}; }))}};
}

void run(const std::vector<std::string>& words) {
  const Communicator comm(MPI_COMM_SELF);
  std::vector<int> counts;
  std::istringstream list(words.at(0));
  for (std::string part; std::getline(list, part, ',');) counts.push_back(std::stoi(part));
  std::vector<Decomposition> first;
  std::vector<Decomposition> bound;
  Json rows = Json::array();
  for (std::size_t file = 1; file < words.size(); ++file) {
    const State state(comm, words[file]);
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const Decomposition division = divide(comm, state, counts[k]);
      if (file == 1) {
        first.push_back(division);
        bound.push_back(division);
      }
      rows.push_back(row(state, division, counts[k], "new"));
      rows.push_back(row(state, first[k], counts[k], "first"));
      rows.push_back(row(state, bound[k], counts[k], "bound"));
      const double limit = state.simulation().deck().neighbours.max_imbalance;
      if (rows.back()["cost_imbalance"].get<double>() > limit) bound[k] = division;
    }
  }
  std::puts(rows.dump(1).c_str());
}

}  // namespace

int main(int argc, char** argv) { return run_tool(argc, argv, 2, "repose_partition PARTS SNAPSHOT...", run); }
