#include "scene/insertion/insertion.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/has_pair.h"
#include "deck/key.h"
#include "scene/insertion/fill.h"
#include "scene/insertion/grain_sizes.h"
#include "scene/insertion/lattice.h"
#include "scene/insertion/overlap.h"
#include "scene/insertion/particle_csv.h"
#include "scene/insertion/random_fill.h"
#include "scene/particles/materials.h"
#include "scene/particles/periodicity.h"
#include "scene/sizes/size_distribution.h"
#include "scene/walls/periodic_walls.h"

namespace repose {

namespace {

std::string block_name(const Deck& deck, std::size_t block) {
  const ParticlesDeck& p = deck.particles[block];
  const bool is_named = comes_from_file(p.type);
  const auto type = enumerators(p.type)[static_cast<std::size_t>(p.type)];
  return fmt::format("[[particles]] number {} ({})", block + 1, is_named ? std::string_view(p.file) : type);
}

int material_index(const Deck& deck, const std::string& name, const std::string& block) {
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (deck.materials[m].name == name) return static_cast<int>(m);
  }
  throw DeckError(fmt::format("{}: no material is named \"{}\"", block, name));
}

/// Gathers the blocks one after the other.
class Blocks {
 public:
  Blocks(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file, const ReadSnapshot& read_snapshot)
      : deck_(deck), walls_(walls), read_file_(read_file), read_snapshot_(read_snapshot) {}

  void add(std::size_t block) {
    const ParticlesDeck& p = deck_.particles[block];
    switch (p.type) {
      case ParticlesType::csv:
        return append(block, parse_particle_csv(read_file_(p.file), p.file, deck_.materials));
      case ParticlesType::snapshot:
        return append(block, read_snapshot_(p.file));
      case ParticlesType::lattice:
        return append(block, at_start(block, lattice_sites(p, walls_, block_name(deck_, block)), {}));
      case ParticlesType::fill:
        return fill(block);
      case ParticlesType::pour:
        return pour(block);
    }
  }

  Insertion result;
  std::vector<std::size_t> origin;  ///< block of each particle of result.now

 private:
  void fill(std::size_t block) {
    const ParticlesDeck& p = deck_.particles[block];
    const std::string name = block_name(deck_, block);
    const std::vector<double> radii = radii_of(block, name);
    const auto count = static_cast<std::int64_t>(radii.size());
    append(block, at_start(block,
                           p.sizes.enabled ? random_fill(p, radii, result.planned, deck_.run.seed, walls_, name)
                                           : fill_region(p, count, result.planned, deck_.run.seed, walls_, name),
                           radii));
  }

  void pour(std::size_t block) {
    const std::string name = block_name(deck_, block);
    Pour pour = plan_pour(deck_, block, name, walls_, radii_of(block, name), density_of(block, name));
    pour.first_id = result.planned;
    pour.material = material_index(deck_, pour.deck.material, name);
    result.planned += pour.size();
    result.pours.push_back(std::move(pour));
  }

  double density_of(std::size_t block, const std::string& name) const {
    const int material = material_index(deck_, deck_.particles[block].material, name);
    return deck_.materials[static_cast<std::size_t>(material)].density;
  }

  /// The radii of a block that is measured out, and their report.
  std::vector<double> radii_of(std::size_t block, const std::string& name) {
    const ParticlesDeck& p = deck_.particles[block];
    const SizeDistribution sizes = make_size_distribution(p, read_file_, name);
    std::vector<double> radii = draw_radii(p, sizes, density_of(block, name), result.planned, deck_.run.seed, name);
    if (p.sizes.enabled) result.sizes.push_back(report_sizes(name, sizes, radii));
    return radii;
  }

  /// Particles of a block at these places, with these radii or all of its diameter.
  NewParticles at_start(std::size_t block, const std::vector<Vec3>& position, const std::vector<double>& radii) const {
    const ParticlesDeck& p = deck_.particles[block];
    NewParticles particles;
    particles.position = position;
    particles.velocity.assign(position.size(), p.velocity);
    particles.spin.assign(position.size(), Vec3{});
    particles.radius = radii;
    particles.radius.resize(position.size(), 0.5 * p.diameter);
    particles.material.assign(position.size(), material_index(deck_, p.material, block_name(deck_, block)));
    return particles;
  }

  void append(std::size_t block, const NewParticles& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    NewParticles& all = result.now;
    for (std::size_t i = 0; i < more.size(); ++i) all.id.push_back(result.planned++);
    add(all.position, more.position);
    add(all.velocity, more.velocity);
    add(all.spin, more.spin);
    add(all.radius, more.radius);
    add(all.material, more.material);
    if (!more.temperature.empty()) {
      all.temperature.resize(all.size() - more.size(), unset);
      add(all.temperature, more.temperature);
    } else if (!all.temperature.empty()) {
      all.temperature.resize(all.size(), unset);
    }
    origin.resize(all.size(), block);
  }

  const Deck& deck_;
  const std::vector<Wall>& walls_;
  const ReadFile& read_file_;
  const ReadSnapshot& read_snapshot_;
};

// Which block each particle came from, for the checks and their messages.
struct Origin {
  const Deck& deck;
  const std::vector<std::size_t>& block;
  const std::vector<std::int64_t>& id;

  bool is_held(std::size_t i) const { return repose::is_held(deck.particles[block[i]]); }
  bool is_made(std::size_t i) const { return !comes_from_file(deck.particles[block[i]].type); }
  std::string describe(std::size_t i) const {
    return fmt::format("particle {} of {}", id[i], block_name(deck, block[i]));
  }
};

// read_deck cannot know the materials of a list; that every two which can touch have a pair is checked here.
void check_pairs(const Insertion& insertion, const Deck& deck) {
  std::vector<bool> used(deck.materials.size(), false);
  insertion.for_each([&](double, std::size_t material) { used[material] = true; });
  const auto require = [&](const std::string& a, const std::string& b) {
    if (has_pair(deck, a, b)) return;
    throw DeckError(
        fmt::format("no [[pair]] for \"{0}\" and \"{1}\", which can touch; add materials = [\"{0}\", \"{1}\"]", a, b));
  };
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    for (std::size_t j = 0; j <= i; ++j) {
      if (used[j]) require(deck.materials[i].name, deck.materials[j].name);
    }
    for (const WallDeck& wall : deck.walls) require(deck.materials[i].name, wall.material);
  }
}

void check_domain(const NewParticles& particles, const Origin& origin) {
  const auto& [min, max, periodic] = origin.deck.domain;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3& p = particles.position[i];
    if (p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y && p.z >= min.z && p.z < max.z) continue;
    throw DeckError(fmt::format("{} at ({}, {}, {}) is outside the domain", origin.describe(i), p.x, p.y, p.z));
  }
}

void check_walls(const NewParticles& particles, const Origin& origin, const std::vector<Wall>& walls) {
  const double bound = origin.deck.guards.max_overlap;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (origin.is_held(i)) continue;  // glued particles may stick in a plate
    for (const Wall& wall : walls) {
      const double overlap = particles.radius[i] - distance(wall, particles.position[i]);
      if (!wall.present || overlap <= bound * particles.radius[i]) continue;
      throw DeckError(fmt::format("{} reaches {:.3g} m into wall \"{}\", more than {} of its radius",
                                  origin.describe(i), overlap, wall.name, bound));
    }
  }
}

void check_overlaps(const NewParticles& particles, const Origin& origin) {
  const SpheresWithImages all = with_images(Periodicity(origin.deck.domain), particles.position, particles.radius);
  for_each_overlap(all.position, all.radius, [&](std::size_t a, std::size_t b) {
    const std::size_t i = all.original[a];
    const std::size_t j = all.original[b];
    if (origin.is_held(i) && origin.is_held(j)) return;
    const double smaller = std::min(particles.radius[i], particles.radius[j]);
    const double apart = norm(all.position[a] - all.position[b]);
    const double overlap = particles.radius[i] + particles.radius[j] - apart;
    // A block that is filled has no overlaps of its own, so any with another block means that their regions intersect.
    const bool blocks_intersect =
        origin.block[i] != origin.block[j] && (origin.is_made(i) || origin.is_made(j)) && overlap > 1e-9 * smaller;
    if (!blocks_intersect && overlap <= origin.deck.guards.max_overlap * smaller) return;
    throw DeckError(fmt::format("{} and {} overlap by {:.3g} m, {:.3g} of the smaller radius; {}", origin.describe(j),
                                origin.describe(i), overlap, overlap / smaller,
                                blocks_intersect ? "a filled block must not overlap with another: take separate "
                                                   "regions, or pour them"
                                                 : fmt::format("the bound is {}", origin.deck.guards.max_overlap)));
  });
}

void check_periodic(const Insertion& insertion, const DomainDeck& domain, const std::vector<Wall>& walls) {
  const double largest = insertion.largest_radius();
  longest_skin(Periodicity(domain), largest);
  check_walls_meet(domain, walls, largest);
}

}  // namespace

Insertion insert_particles(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file,
                           const ReadSnapshot& read_snapshot) {
  Blocks blocks(deck, walls, read_file, read_snapshot);
  for (std::size_t block = 0; block < deck.particles.size(); ++block) {
    blocks.add(block);
    blocks.result.block_begin.push_back(blocks.result.planned);
  }
  NewParticles& now = blocks.result.now;
  const Origin origin{deck, blocks.origin, now.id};
  check_pairs(blocks.result, deck);
  check_domain(now, origin);
  check_walls(now, origin, walls);
  check_overlaps(now, origin);
  check_periodic(blocks.result, deck.domain, walls);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!origin.is_held(i)) continue;
    now.material[i] = MaterialTable::held_twin(now.material[i], deck.materials.size());
    now.velocity[i] = now.spin[i] = {};  // what a file says: they move by their motion alone, from the first phase on
  }
  return std::move(blocks.result);
}

}  // namespace repose
