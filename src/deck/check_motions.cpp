#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/key.h"
#include "deck/nearest.h"

namespace repose {
namespace {

/// Whether a motion takes the images of a body along: it must not move it in a periodic direction, nor turn it out.
bool suits(const MotionDeck& motion, Axis periodic) {
  const double Vec3::*direction = component(periodic);
  Vec3 axis;
  switch (motion.type) {
    case MotionType::translation:
      return motion.velocity.*direction == 0.0;
    case MotionType::oscillation:
      return motion.amplitude.*direction == 0.0;
    case MotionType::rotation:
      axis.*component(periodic) = 1.0;
      return cross(motion.axis_direction, axis) == Vec3{};
    case MotionType::conveyor:
      return true;
  }
  return false;
}

void check_motion_list(const std::string& section, const std::vector<MotionDeck>& motions, const Deck& deck,
                       DeckErrors& errors) {
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const std::string motion = fmt::format("{}.motion.{}", section, k);
    for (const Axis periodic : deck.domain.periodic) {
      if (suits(motions[k], periodic)) continue;
      errors.add(motion, fmt::format("moves along or turns away from the periodic direction {} of the [domain]",
                                     enumerators(Axis{})[static_cast<std::size_t>(periodic)]));
    }
    if (motions[k].type == MotionType::rotation)
      check_direction(motion, "axis_direction", motions[k].axis_direction, errors);
    check_phase_names(motion, motions[k].phases, deck, errors);
  }
}

void check_tilt_onset(const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.tilt_onset";
  if (!deck.tilt.enabled) errors.add(section, "[measurement.tilt_onset] needs a [tilt]");
  if (deck.tilt.angular_velocity == 0.0) errors.add("tilt.angular_velocity", "the tilt needs a rate other than zero");
  std::vector<std::string> materials;
  for (const MaterialDeck& m : deck.materials) materials.push_back(m.name);
  const std::string& against = deck.tilt_onset.against;
  if (std::find(materials.begin(), materials.end(), against) != materials.end()) return;
  errors.add(section + ".against",
             fmt::format("unknown material \"{}\"; the nearest is \"{}\"", against, nearest(against, materials)));
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
  check_phase_names(section, {f.phase}, deck, errors);
}

}  // namespace

void check_phase_names(const std::string& section, const std::vector<std::string>& named, const Deck& deck,
                       DeckErrors& errors) {
  std::vector<std::string> phases;
  for (const PhaseDeck& phase : deck.phases) phases.push_back(phase.name);
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (std::find(phases.begin(), phases.end(), named[k]) != phases.end()) continue;
    errors.add(fmt::format("{}.phases.{}", section, k),
               fmt::format("unknown phase \"{}\"; the nearest is \"{}\"", named[k], nearest(named[k], phases)));
  }
}

void check_motions(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    check_motion_list(fmt::format("wall.{}", i), deck.walls[i].motions, deck, errors);
  }
  for (std::size_t i = 0; i < deck.particles.size(); ++i) {
    const ParticlesDeck& block = deck.particles[i];
    const std::string section = fmt::format("particles.{}", i);
    check_motion_list(section, block.motions, deck, errors);
    for (std::size_t k = 0; k < block.motions.size(); ++k) {
      if (block.motions[k].type != MotionType::conveyor) continue;
      errors.add(fmt::format("{}.motion.{}.type", section, k), "only walls can be a conveyor; particles can move");
    }
    if (!block.motions.empty() && !deck.domain.periodic.empty()) {
      errors.add(section, "[[particles.motion]] needs a [domain] without periodic directions");
    }
    if (is_held(block) && block.type == ParticlesType::pour) {
      errors.add(section + ".type", "poured particles can be neither \"fixed\" nor on a [[particles.motion]]");
    }
    if (block.fixed && !block.motions.empty()) {
      errors.add(section + ".fixed", "\"fixed\" particles stay in place; remove it or the [[particles.motion]]");
    }
  }
  if (deck.tilt.enabled) {
    check_direction("tilt", "axis_direction", deck.tilt.axis_direction, errors);
    check_phase_names("tilt", deck.tilt.phases, deck, errors);
  }
  if (deck.tilt_onset.enabled) check_tilt_onset(deck, errors);
  if (deck.flow_energy.enabled) check_flow_energy(deck.flow_energy, deck, errors);
  if (deck.surface_angle.enabled) {
    check_direction("measurement.surface_angle", "axis_direction", deck.surface_angle.axis_direction, errors);
    if (deck.tilt.enabled && cross(deck.surface_angle.axis_direction, deck.tilt.axis_direction) != Vec3{}) {
      errors.add("measurement.surface_angle.axis_direction",
                 "is not along the axis of the [tilt], about which the slope of the bed changes");
    }
  }
  for (std::size_t i = 0; i < deck.phases.size(); ++i) {
    if (deck.phases[i].until != PhaseUntil::tilt_onset || deck.tilt_onset.enabled) continue;
    if (deck.tilt.enabled && deck.surface_angle.enabled) continue;
    errors.add(fmt::format("phase.{}.until", i),
               "\"until\" = tilt_onset needs [measurement.tilt_onset], or a [tilt] and [measurement.surface_angle]");
  }
}

}  // namespace repose
