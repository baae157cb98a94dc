#include "setup.h"

#include <algorithm>
#include <limits>

namespace repose {

std::vector<Wall> make_walls(const Deck& deck, const MaterialTable& materials, const ReadFile& read_file) {
  std::vector<Wall> walls;
  for (const WallDeck& w : deck.walls) walls.push_back(make_wall(w, materials.index_of(w.material), read_file));
  return walls;
}

SmallestRadii smallest_radii(const NewParticles& particles, std::size_t materials) {
  SmallestRadii radii{std::vector<double>(materials, std::numeric_limits<double>::infinity())};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double& smallest = radii.of_material[static_cast<std::size_t>(particles.material[i])];
    smallest = std::min(smallest, particles.radius[i]);
  }
  return radii;
}

}  // namespace repose
