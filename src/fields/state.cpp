#include "fields/state.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "deck/read_deck.h"
#include "integration/velocity_verlet.h"
#include "output/checkpoint_reader.h"
#include "output/file_contents.h"
#include "output/snapshot_reader.h"
#include "output/state_json.h"
#include "simulation/setup.h"

namespace repose::fields {
namespace {

/// The walls in the state that a checkpoint keeps: where Simulation and MovingScene put them.
struct SceneState {
  std::vector<Wall>& walls;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v.each("walls", self.walls);
  }
};
struct SimulationState {
  SceneState scene;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("scene", self.scene);
  }
};

void place_walls(const std::string& state, const std::string& file, double dt, std::vector<Wall>& walls) {
  const nlohmann::json json = nlohmann::json::parse(state, nullptr, false);
  if (json.is_discarded()) throw FileError(fmt::format("{}: /state is no JSON", file));
  SimulationState simulation{{walls}};
  StateReader(json, file + ": state")("simulation", simulation);
  place(walls, dt);
}

/// Whether it is where the deck says, and there in all phases: those that move with another come and go with it.
bool is_settled(const Wall& wall, std::span<const Wall> walls, const Deck& deck) {
  const std::string& leader = wall.moves_with ? walls[*wall.moves_with].name : wall.name;
  const auto names = [&](const std::vector<std::string>& list) {
    return std::any_of(list.begin(), list.end(),
                       [&](const std::string& name) { return name == wall.name || name == leader; });
  };
  return !wall.travels && std::none_of(deck.phases.begin(), deck.phases.end(), [&](const PhaseDeck& phase) {
    return names(phase.remove_walls) || names(phase.add_walls);
  });
}

Deck deck_of(const DeckSource& source, const std::string& own, const std::string& file) {
  if (!source.text.empty()) return read_deck(source.text, source.path, source.overrides);
  return read_written_deck(own, file + ": its deck", source.overrides);
}

/// A checkpoint names materials and walls by their places in the deck alone.
void refuse_other_names(const Deck& deck, const DeckSource& source, const std::string& own, const std::string& file) {
  if (source.text.empty()) return;
  const auto names = [](const auto& sections) {
    std::vector<std::string> list;
    for (const auto& section : sections) list.push_back(section.name);
    return list;
  };
  const Deck written = read_written_deck(own, file + ": its deck", {});
  if (names(deck.materials) != names(written.materials) || names(deck.walls) != names(written.walls)) {
    throw DeckError(fmt::format("{}: has other materials or walls than the deck in {}; give the deck of that run",
                                source.path, file));
  }
}

/// A snapshot names the solids of grains alone: which of them are held follows from their ids.
void mark_held(const Deck& deck, const Insertion& insertion, const std::vector<std::int64_t>& ids,
               std::vector<int>& materials) {
  for (std::size_t block = 0; block < deck.particles.size(); ++block) {
    if (!is_held(deck.particles[block])) continue;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] < insertion.block_begin[block] || ids[i] >= insertion.block_begin[block + 1]) continue;
      materials[i] = MaterialTable::held_twin(materials[i], deck.materials.size());
    }
  }
}

/// Those of a snapshot, held ones with the twins of their materials.
NewParticles snapshot_grains(const std::string& bytes, const std::string& file, const State& state,
                             const ReadFile& read_file) {
  const Deck& deck = state.deck;
  NewParticles grains = parse_snapshot(bytes, file, deck.materials);
  if (std::any_of(deck.particles.begin(), deck.particles.end(), [](const ParticlesDeck& p) { return is_held(p); })) {
    const std::vector<std::int64_t> ids = snapshot_particles(bytes, file).particles.id;
    mark_held(deck, insert_particles_of(deck, state.walls, read_file), ids, grains.material);
  }
  return grains;
}

Particles particles_of(const NewParticles& all) {
  Particles particles;
  for (std::size_t i = 0; i < all.size(); ++i) {
    particles.record.push_back({all.position[i], all.radius[i], all.velocity[i], 0.0, all.spin[i], 0.0});
    particles.id.push_back(static_cast<std::int64_t>(i));
    particles.material.push_back(all.material[i]);
  }
  particles.owned = all.size();
  return particles;
}

template <class T>
Csr<T> chosen_rows(const Csr<T>& rows, const std::vector<std::size_t>& order) {
  Csr<T> chosen;
  for (const std::size_t row : order) chosen.append_row(rows.row(row));
  return chosen;
}

/// Those of a checkpoint that are in the domain, in the order of their ids, with what their contacts remember.
void take(const Checkpoint& checkpoint, State& state) {
  const Particles& all = checkpoint.particles;
  std::vector<std::size_t> order(all.owned);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return is_parked(all.record[i]); });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all.id[a] < all.id[b]; });
  for (const std::size_t i : order) {
    state.particles.record.push_back(all.record[i]);
    state.particles.id.push_back(all.id[i]);
    state.particles.material.push_back(all.material[i]);
  }
  state.particles.owned = order.size();
  state.memory = {chosen_rows(checkpoint.memory.pairs, order), chosen_rows(checkpoint.memory.walls, order)};
  state.remembers = true;
}

void check_fit(const State& state, const std::string& file) {
  const auto is_among = [](std::int32_t index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
  };
  if (state.particles.owned == 0) throw DeckError(fmt::format("{}: it holds no particles", file));
  for (const std::int32_t material : state.particles.material) {
    if (!is_among(material, state.materials.size()))
      throw FileError(fmt::format("{}: material {} is not in the deck", file, material));
  }
  for (const WallMemory& contact : state.memory.walls.items) {
    if (!is_among(contact.wall, state.walls.size()))
      throw FileError(fmt::format("{}: wall {} is not in the deck", file, contact.wall));
  }
}

}  // namespace

State read_state(const std::string& bytes, const std::string& file, const DeckSource& source,
                 const ReadFile& read_file) {
  const FileContents contents = file_contents(bytes, file);
  if (contents.kind == FileContents::Kind::grid) {
    throw FileError(fmt::format("{}: is the grid of a calibration; a snapshot or a checkpoint is needed", file));
  }
  const Deck deck = deck_of(source, contents.deck, file);
  State state(deck);
  state.step = contents.step;
  state.time = contents.time_s;
  state.walls = make_walls(deck, state.materials, read_file);
  if (contents.kind == FileContents::Kind::checkpoint) {
    refuse_other_names(deck, source, contents.deck, file);
    const Checkpoint checkpoint = parse_checkpoint(bytes, file);
    const double dt = state.step > 0 ? state.time / static_cast<double>(state.step) : 0.0;
    place_walls(checkpoint.header.state, file, dt, state.walls);
    take(checkpoint, state);
  } else {
    state.particles = particles_of(snapshot_grains(bytes, file, state, read_file));
    state.memory = {Csr<PairMemory>::empty(state.particles.owned), Csr<WallMemory>::empty(state.particles.owned)};
    for (Wall& wall : state.walls) {
      if (is_settled(wall, state.walls, deck)) continue;
      wall.present = false;
      state.unknown_walls.push_back(wall.name);
    }
  }
  check_fit(state, file);
  state.particles.periodic = Periodicity(deck.domain);
  wrap_positions(state.particles);
  set_fixed_point_scales(state.materials, deck.guards.max_overlap, state.particles);
  state.particles.sum.assign(state.particles.record.size(), ForceSum{});
  return state;
}

}  // namespace repose::fields
