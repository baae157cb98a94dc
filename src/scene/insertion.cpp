#include "scene/insertion.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "scene/fill.h"
#include "scene/overlap.h"
#include "scene/particle_csv.h"
#include "scene/periodic_walls.h"
#include "scene/periodicity.h"

namespace repose {

namespace {

std::string block_name(const Deck& deck, std::size_t block) {
  const bool fill = deck.particles[block].type == ParticlesType::fill;
  return fmt::format("[[particles]] number {} ({})", block + 1, fill ? "fill" : deck.particles[block].file);
}

int material_index(const Deck& deck, const std::string& name, const std::string& block) {
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (deck.materials[m].name == name) return static_cast<int>(m);
  }
  throw DeckError(fmt::format("{}: no material is named \"{}\"", block, name));
}

NewParticles filled(const Deck& deck, std::size_t block, std::size_t first_id, const std::vector<Wall>& walls) {
  const ParticlesDeck& fill = deck.particles[block];
  const std::string name = block_name(deck, block);
  const int material = material_index(deck, fill.material, name);
  const std::int64_t count = fill_count(fill, deck.materials[static_cast<std::size_t>(material)].density, name);
  NewParticles particles;
  particles.position = fill_region(fill, count, static_cast<std::int64_t>(first_id), deck.run.seed, walls, name);
  particles.velocity.assign(particles.size(), fill.velocity);
  particles.spin.assign(particles.size(), Vec3{});
  particles.radius.assign(particles.size(), 0.5 * fill.diameter);
  particles.material.assign(particles.size(), material);
  return particles;
}

void append(NewParticles& all, const NewParticles& more) {
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(all.position, more.position);
  add(all.velocity, more.velocity);
  add(all.spin, more.spin);
  add(all.radius, more.radius);
  add(all.material, more.material);
}

// Which block each particle came from, for the checks and their messages.
struct Origin {
  const Deck& deck;
  std::vector<std::size_t> block;

  bool is_fill(std::size_t id) const { return deck.particles[block[id]].type == ParticlesType::fill; }
  std::string describe(std::size_t id) const {
    return fmt::format("particle {} of {}", id, block_name(deck, block[id]));
  }
};

// read_deck cannot know the materials of a list; that every two which can touch have a pair is checked here.
void check_pairs(const NewParticles& particles, const Deck& deck) {
  std::vector<bool> used(deck.materials.size(), false);
  for (const int m : particles.material) used[static_cast<std::size_t>(m)] = true;
  const auto require = [&](const std::string& a, const std::string& b) {
    const bool given = std::any_of(deck.pairs.begin(), deck.pairs.end(), [&](const PairDeck& p) {
      return (p.materials[0] == a && p.materials[1] == b) || (p.materials[0] == b && p.materials[1] == a);
    });
    if (given) return;
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
    const double smaller = std::min(particles.radius[i], particles.radius[j]);
    const double apart = norm(all.position[a] - all.position[b]);
    const double overlap = particles.radius[i] + particles.radius[j] - apart;
    // A filled block has no overlaps of its own, so any with another block means that their regions intersect.
    const bool blocks_intersect =
        origin.block[i] != origin.block[j] && (origin.is_fill(i) || origin.is_fill(j)) && overlap > 1e-9 * smaller;
    if (!blocks_intersect && overlap <= origin.deck.guards.max_overlap * smaller) return;
    throw DeckError(fmt::format("{} and {} overlap by {:.3g} m, {:.3g} of the smaller radius; {}", origin.describe(j),
                                origin.describe(i), overlap, overlap / smaller,
                                blocks_intersect ? "a filled block must not overlap with another"
                                                 : fmt::format("the bound is {}", origin.deck.guards.max_overlap)));
  });
}

void check_periodic(const NewParticles& particles, const DomainDeck& domain, const std::vector<Wall>& walls) {
  double largest = 0.0;
  for (const double radius : particles.radius) largest = std::max(largest, radius);
  longest_skin(Periodicity(domain), largest);
  check_walls_meet(domain, walls, largest);
}

}  // namespace

NewParticles insert_particles(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file) {
  NewParticles all;
  Origin origin{deck, {}};
  for (std::size_t block = 0; block < deck.particles.size(); ++block) {
    const ParticlesDeck& particles = deck.particles[block];
    append(all, particles.type == ParticlesType::fill
                    ? filled(deck, block, all.size(), walls)
                    : parse_particle_csv(read_file(particles.file), particles.file, deck.materials));
    origin.block.resize(all.size(), block);
  }
  check_pairs(all, deck);
  check_domain(all, origin);
  check_walls(all, origin, walls);
  check_overlaps(all, origin);
  check_periodic(all, deck.domain, walls);
  return all;
}

}  // namespace repose
