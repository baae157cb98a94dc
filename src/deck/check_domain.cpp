#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/key.h"

namespace repose {
namespace {

constexpr auto axis_names = enumerators(Axis{});
constexpr auto face_names = enumerators(DomainFace{});

std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }

bool is_periodic(const DomainDeck& domain, Axis axis) {
  return std::find(domain.periodic.begin(), domain.periodic.end(), axis) != domain.periodic.end();
}

void check_periodic(const Deck& deck, Axis axis, DeckErrors& errors) {
  const std::string_view name = axis_names[index(axis)];
  if (std::count(deck.domain.periodic.begin(), deck.domain.periodic.end(), axis) > 1) {
    errors.add("domain.periodic", fmt::format("\"{}\" is given twice", name));
  }
  if (deck.gravity.*component(axis) != 0.0 && std::isnan(deck.time.expected_speed)) {
    errors.add(
        "domain.periodic",
        fmt::format("gravity along {0} is not zero, so the fall along the periodic direction {0} has no end; set "
                    "time.expected_speed",
                    name));
  }
}

void check_open_z(const Deck& deck, DeckErrors& errors) {
  if (!is_periodic(deck.domain, Axis::z)) return;
  const std::string message = "the height z must not be a periodic direction of the [domain]";
  if (deck.discharge.enabled) errors.add("measurement.discharge", message);
  if (deck.angle_of_repose.enabled) errors.add("measurement.angle_of_repose", message);
}

void check_exit(const Deck& deck, std::size_t i, DeckErrors& errors) {
  const ExitDeck& exit = deck.exits[i];
  const std::string section = fmt::format("exit.{}", i);
  if (std::find(face_names.begin(), face_names.end(), exit.name) != face_names.end()) {
    errors.add(section + ".name", fmt::format("\"{}\" is the name of a whole face; take another", exit.name));
  }
  const auto across = static_cast<Axis>(static_cast<std::size_t>(exit.face) / 2);
  if (is_periodic(deck.domain, across)) {
    errors.add(section + ".face",
               fmt::format("nothing leaves by \"{}\": {} is a periodic direction",
                           face_names[static_cast<std::size_t>(exit.face)], axis_names[index(across)]));
  }
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    if (axis == across) continue;
    const double Vec3::*a = component(axis);
    if (exit.min.*a < exit.max.*a && exit.min.*a < deck.domain.max.*a && exit.max.*a > deck.domain.min.*a) continue;
    errors.add(section + ".max", fmt::format("from {} to {} in {} is no part of the domain's face", exit.min.*a,
                                             exit.max.*a, axis_names[index(axis)]));
  }
}

}  // namespace

void check_domain(const Deck& deck, DeckErrors& errors) {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    if (is_periodic(deck.domain, axis)) check_periodic(deck, axis, errors);
  }
  check_open_z(deck, errors);
  for (std::size_t i = 0; i < deck.exits.size(); ++i) check_exit(deck, i, errors);
}

}  // namespace repose
