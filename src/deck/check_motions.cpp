#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/directions.h"
#include "deck/key.h"
#include "deck/present_walls.h"

namespace repose {
namespace {

/// Whether a motion takes the images of a body along: it must not move it in a periodic direction, nor turn it out.
bool suits(const MotionDeck& motion, Axis periodic) {
  const double Vec3::*direction = component(periodic);
  switch (motion.type) {
    case MotionType::translation:
      return motion.velocity.*direction == 0.0;
    case MotionType::oscillation:
      return motion.amplitude.*direction == 0.0;
    case MotionType::rotation:
      return are_parallel(motion.axis_direction, unit_along(periodic));
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
    check_acting_phases(motion, "the motion", motions[k].phases, deck, errors);
  }
}

}  // namespace

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
    if (block.rotation_blocked && is_held(block)) {
      errors.add(section + ".rotation_blocked",
                 "\"rotation_blocked\" is for particles that move freely, not for \"fixed\" ones or those on a "
                 "[[particles.motion]]; remove it");
    }
  }
}

void check_moving_walls(const Deck& deck, DeckErrors& errors) {
  const std::vector<PresentWalls> by_phase = present_walls_by_phase(deck);
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    const WallDeck& wall = deck.walls[i];
    if (wall.motions.empty() && !wall.servo.enabled) continue;
    const auto is_there = [&](const PresentWalls& walls) { return walls.has_body(wall.name); };
    if (std::any_of(by_phase.begin(), by_phase.end(), is_there)) continue;
    errors.add(fmt::format("wall.{}.{}", i, wall.servo.enabled ? "servo" : "motion"),
               fmt::format("wall \"{}\" is in no phase there to move; let a phase add it (add_walls)", wall.name));
  }
}

}  // namespace repose
