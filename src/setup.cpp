#include "setup.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "output/snapshot_reader.h"
#include "scene/sphere.h"

namespace repose {

std::vector<Wall> make_walls(const Deck& deck, const MaterialTable& materials, const ReadFile& read_file) {
  std::vector<Wall> walls;
  for (const WallDeck& w : deck.walls) walls.push_back(make_wall(w, materials.index_of(w.material), read_file));
  return walls;
}

Insertion insert_particles_of(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file) {
  Insertion insertion = insert_particles(deck, walls, read_file, [&](const std::string& file) {
    return parse_snapshot(read_file(file), file, deck.materials);
  });
  if (deck.tilt_onset.enabled && deck.tilt_onset.particle >= insertion.planned) {
    throw DeckError(fmt::format("measurement.tilt_onset.particle = {}: the deck has particles 0 to {}",
                                deck.tilt_onset.particle, insertion.planned - 1));
  }
  return insertion;
}

SmallestRadii smallest_radii(const Insertion& insertion, std::size_t materials) {
  SmallestRadii radii{std::vector<double>(materials, std::numeric_limits<double>::infinity())};
  insertion.for_each([&](double radius, std::size_t material) {
    radii.of_material[material] = std::min(radii.of_material[material], radius);
  });
  return radii;
}

double planned_mass(const Insertion& insertion, const MaterialTable& materials) {
  double mass = 0.0;
  insertion.for_each(
      [&](double radius, std::size_t material) { mass += sphere_mass(radius, materials[material].density); });
  return mass;
}

}  // namespace repose
