#include "deck/present_walls.h"

#include <algorithm>

namespace repose {

PresentWalls::PresentWalls(const Deck& deck) : deck_(deck) {
  for (const WallDeck& wall : deck.walls) {
    if (wall.present) present_.insert(wall.name);
  }
}

void PresentWalls::take_along(const std::string& leader) {
  for (const WallDeck& wall : deck_.walls) {
    if (wall.moves_with != leader) continue;
    if (present_.contains(leader)) {
      present_.insert(wall.name);
    } else {
      present_.erase(wall.name);
    }
  }
}

bool PresentWalls::has_body(const std::string& name) const {
  return present_.contains(name) || std::any_of(deck_.walls.begin(), deck_.walls.end(), [&](const WallDeck& wall) {
           return wall.moves_with == name && present_.contains(wall.name);
         });
}

std::vector<PresentWalls> present_walls_by_phase(const Deck& deck) {
  std::vector<PresentWalls> all;
  PresentWalls walls(deck);
  for (const PhaseDeck& phase : deck.phases) {
    for (const std::string& name : phase.remove_walls) walls.remove(name);
    for (const std::string& name : phase.remove_walls) walls.take_along(name);
    for (const std::string& name : phase.add_walls) walls.add(name);
    for (const std::string& name : phase.add_walls) walls.take_along(name);
    all.push_back(walls);
  }
  return all;
}

}  // namespace repose
