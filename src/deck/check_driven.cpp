#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/acts_in.h"
#include "deck/check_deck.h"
#include "deck/present_walls.h"

namespace repose {
namespace {

/// The place of a phase among all of them; their number when there is none of this name.
std::size_t place_of_phase(const std::string& name, const Deck& deck) {
  const auto found =
      std::find_if(deck.phases.begin(), deck.phases.end(), [&](const PhaseDeck& phase) { return phase.name == name; });
  return static_cast<std::size_t>(found - deck.phases.begin());
}

bool are_known(const std::vector<const WallDeck*>& walls) {
  return std::find(walls.begin(), walls.end(), nullptr) == walls.end();
}

/// That grains move in a phase in which something is measured on walls, and that one of these is there.
void check_measured_phase(const std::string& key, const std::string& name, const std::vector<std::string>& walls,
                          const Deck& deck, DeckErrors& errors) {
  const std::size_t place = place_of_phase(name, deck);
  if (place == deck.phases.size()) return;
  if (!deck.phases[place].mechanics) {
    errors.add(key, fmt::format("phase \"{}\" is one without mechanics, in which nothing moves", name));
  }
  const PresentWalls there = present_walls_by_phase(deck)[place];
  if (walls.empty() ||
      std::any_of(walls.begin(), walls.end(), [&](const auto& wall) { return there.has_body(wall); })) {
    return;
  }
  errors.add(key, fmt::format("wall \"{}\" is not there in phase \"{}\"; let a phase add it (add_walls)", walls.front(),
                              name));
}

void check_shear(const ShearDeck& s, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.shear";
  const auto walls = find_walls(section + ".walls", s.walls, "one half of the cell", deck, errors);
  check_phase_names(section, {s.phase}, deck, errors);
  if (are_known(walls)) check_measured_phase(section + ".phase", s.phase, s.walls, deck, errors);
  check_height(section, "plane_height", s.plane_height, deck.domain, errors);
  if (s.type == ShearType::translation) {
    check_direction(section, "direction", s.direction, errors);
    if (s.direction.z != 0.0) errors.add(section + ".direction", "is not horizontal: the plane between the halves is");
    return;
  }
  check_direction(section, "axis_direction", s.axis_direction, errors);
  if (s.inner_radius >= s.outer_radius) {
    errors.add(section + ".outer_radius",
               fmt::format("\"outer_radius\" = {} must be greater than \"inner_radius\" = {}", s.outer_radius,
                           s.inner_radius));
  }
}

/// That the lid is there when the bed is loaded and let go, and that it can let it go.
void check_way_of_lid(const CompressionDeck& c, const WallDeck& lid, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.compression";
  check_measured_phase(section + ".load_phase", c.load_phase, {c.lid}, deck, errors);
  check_measured_phase(section + ".unload_phase", c.unload_phase, {c.lid}, deck, errors);
  if (!acts_in(lid.servo.phases, c.unload_phase)) {
    errors.add(section + ".unload_phase",
               fmt::format("the [wall.servo] of wall \"{}\" does not act in phase \"{}\", so "
                           "that the lid cannot go back; name it in its phases",
                           c.lid, c.unload_phase));
  }
}

void check_compression(const CompressionDeck& c, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.compression";
  const WallDeck* lid = find_wall(section + ".lid", c.lid, deck, errors);
  if (lid != nullptr && !(lid->servo.enabled && lid->servo.type == ServoType::translation)) {
    errors.add(section + ".lid", fmt::format("wall \"{}\" has no [wall.servo] that presses", c.lid));
  }
  check_phase_names(section, {c.load_phase, c.unload_phase}, deck, errors);
  const std::size_t loading = place_of_phase(c.load_phase, deck);
  if (loading < deck.phases.size() && place_of_phase(c.unload_phase, deck) <= loading) {
    errors.add(section + ".unload_phase",
               fmt::format("phase \"{}\" does not come after \"load_phase\" = \"{}\"", c.unload_phase, c.load_phase));
  }
  if (lid != nullptr && lid->servo.enabled) check_way_of_lid(c, *lid, deck, errors);
}

/// That a wall of the blade moves, and how is measured.
void check_blade_wall(const std::string& key, const WallDeck& wall, DeckErrors& errors) {
  if (wall.motions.empty() && !wall.servo.enabled && wall.moves_with.empty()) {
    errors.add(key, fmt::format("wall \"{}\" has no [[wall.motion]]: it does no work", wall.name));
  }
  if (std::any_of(wall.motions.begin(), wall.motions.end(),
                  [](const MotionDeck& motion) { return motion.type == MotionType::conveyor; })) {
    errors.add(key, fmt::format("wall \"{}\" is a conveyor, whose work is not measured; name walls that move "
                                "themselves",
                                wall.name));
  }
}

bool is_alike(const MotionDeck& a, const MotionDeck& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.type == b.type && a.velocity == b.velocity && a.amplitude == b.amplitude && same(a.frequency, b.frequency) &&
         a.axis_origin == b.axis_origin && a.axis_direction == b.axis_direction &&
         same(a.angular_velocity, b.angular_velocity) && a.phases == b.phases;
}

/// Whether something moves a wall of the blade, itself or the one it moves with, in a phase.
bool is_moved(const WallDeck& wall, const std::string& phase, const Deck& deck) {
  const auto found = std::find_if(deck.walls.begin(), deck.walls.end(),
                                  [&](const WallDeck& other) { return other.name == wall.moves_with; });
  const WallDeck& leader = found == deck.walls.end() ? wall : *found;
  return (leader.servo.enabled && acts_in(leader.servo.phases, phase)) ||
         std::any_of(leader.motions.begin(), leader.motions.end(),
                     [&](const MotionDeck& motion) { return acts_in(motion.phases, phase); });
}

/// Whether two walls are parts of one body.
bool move_together(const WallDeck& a, const WallDeck& b) {
  const auto leader = [](const WallDeck& wall) { return wall.moves_with.empty() ? wall.name : wall.moves_with; };
  if (leader(a) == leader(b)) return true;
  return !a.servo.enabled && !b.servo.enabled && a.moves_with.empty() && b.moves_with.empty() &&
         std::equal(a.motions.begin(), a.motions.end(), b.motions.begin(), b.motions.end(), is_alike);
}

void check_flow_energy(const FlowEnergyDeck& f, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.flow_energy";
  const auto walls = find_walls(section + ".walls", f.walls, "the blade", deck, errors);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (walls[k] == nullptr) continue;
    const std::string key = fmt::format("{}.walls.{}", section, k);
    check_blade_wall(key, *walls[k], errors);
    if (walls[0] == nullptr || move_together(*walls[0], *walls[k])) continue;
    errors.add(key,
               fmt::format("wall \"{}\" does not move as \"{}\" does; a blade is one body: let it move with that one "
                           "(\"moves_with\")",
                           walls[k]->name, walls[0]->name));
  }
  if (!check_phase_names(section, {f.phase}, deck, errors) || !are_known(walls)) return;
  check_measured_phase(section + ".phase", f.phase, f.walls, deck, errors);
  if (walls.empty() || walls[0] == nullptr || is_moved(*walls[0], f.phase, deck)) return;
  errors.add(section + ".phase", fmt::format("wall \"{}\" does not move in phase \"{}\"; name one in which the blade's "
                                             "[[wall.motion]] acts",
                                             walls[0]->name, f.phase));
}

}  // namespace

void check_driven_measurements(const Deck& deck, DeckErrors& errors) {
  if (deck.shear.enabled) check_shear(deck.shear, deck, errors);
  if (deck.compression.enabled) check_compression(deck.compression, deck, errors);
  if (deck.flow_energy.enabled) check_flow_energy(deck.flow_energy, deck, errors);
}

}  // namespace repose
