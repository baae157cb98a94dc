#include <algorithm>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/directions.h"
#include "deck/nearest.h"

namespace repose {
namespace {

void check_tilted_gravity(const Deck& deck, DeckErrors& errors) {
  const std::string key = "tilt.axis_direction";
  check_direction("tilt", "axis_direction", deck.tilt.axis_direction, errors);
  if (deck.gravity == Vec3{}) {
    errors.add("tilt", "there is no gravity for a [tilt] to turn; set \"gravity\", or remove the [tilt]");
  } else if (are_parallel(deck.tilt.axis_direction, deck.gravity)) {
    errors.add(key,
               "\"axis_direction\" is along gravity, which the [tilt] would leave as it is; tilt about another axis");
  }
  if (deck.tilt.angular_velocity == 0.0) errors.add("tilt.angular_velocity", "the tilt needs a rate other than zero");
}

void check_tilt_onset(const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.tilt_onset";
  if (!deck.tilt.enabled) errors.add(section, "[measurement.tilt_onset] needs a [tilt]");
  std::vector<std::string> materials;
  for (const MaterialDeck& m : deck.materials) materials.push_back(m.name);
  const std::string& against = deck.tilt_onset.against;
  if (std::find(materials.begin(), materials.end(), against) != materials.end()) return;
  errors.add(section + ".against",
             fmt::format("unknown material \"{}\"; the nearest is \"{}\"", against, nearest(against, materials)));
}

void check_surface_angle(const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.surface_angle";
  const Vec3& axis = deck.surface_angle.axis_direction;
  check_direction(section, "axis_direction", axis, errors);
  if (deck.tilt.enabled && !are_parallel(axis, deck.tilt.axis_direction)) {
    errors.add(section + ".axis_direction",
               "is not along the axis of the [tilt], about which the slope of the bed changes");
  }
  if (deck.gravity == Vec3{}) {
    errors.add(section, "there is no gravity, against which the slope of a bed is measured; set \"gravity\"");
  } else if (are_parallel(axis, deck.gravity)) {
    errors.add(section + ".axis_direction", "\"axis_direction\" is along gravity; the axis of a drum lies across it");
  }
}

}  // namespace

void check_tilt(const Deck& deck, DeckErrors& errors) {
  if (deck.tilt.enabled) {
    check_tilted_gravity(deck, errors);
    check_acting_phases("tilt", "the tilt", deck.tilt.phases, deck, errors);
  }
  if (deck.tilt_onset.enabled) check_tilt_onset(deck, errors);
  if (deck.surface_angle.enabled) check_surface_angle(deck, errors);
}

}  // namespace repose
