#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/directions.h"
#include "deck/key.h"

namespace repose {
namespace {

constexpr auto axis_names = enumerators(Axis{});
constexpr auto face_names = enumerators(DomainFace{});

constexpr Axis all_axes[] = {Axis::x, Axis::y, Axis::z};

std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }

Axis across(const ExitDeck& exit) { return static_cast<Axis>(static_cast<std::size_t>(exit.face) / 2); }

void check_periodic(const Deck& deck, Axis axis, DeckErrors& errors) {
  const std::string_view name = axis_names[index(axis)];
  if (std::count(deck.domain.periodic.begin(), deck.domain.periodic.end(), axis) > 1) {
    errors.add("domain.periodic", fmt::format("\"{}\" is given twice", name));
  }
  if (!std::isnan(deck.time.expected_speed) || deck.contact.normal_law == NormalLaw::hooke) return;
  if (deck.gravity.*component(axis) != 0.0) {
    errors.add(
        "domain.periodic",
        fmt::format("gravity along {0} is not zero, so the fall along the periodic direction {0} has no end; set "
                    "time.expected_speed",
                    name));
  } else if (deck.tilt.enabled && !are_parallel(deck.tilt.axis_direction, unit_along(axis))) {
    errors.add("domain.periodic",
               fmt::format("the [tilt] turns gravity towards the periodic direction {0}, along which the fall has no "
                           "end; set time.expected_speed, or tilt about {0}",
                           name));
  }
}

/// Whether all that leaves through an exit leaves through one before it.
bool lies_within(const ExitDeck& exit, const ExitDeck& before, const DomainDeck& domain) {
  if (exit.face != before.face) return false;
  return std::all_of(std::begin(all_axes), std::end(all_axes), [&](Axis axis) {
    const double Vec3::*a = component(axis);
    return axis == across(exit) || (before.min.*a <= std::max(exit.min.*a, domain.min.*a) &&
                                    before.max.*a >= std::min(exit.max.*a, domain.max.*a));
  });
}

void check_exit(const Deck& deck, std::size_t i, DeckErrors& errors) {
  const ExitDeck& exit = deck.exits[i];
  const std::string section = fmt::format("exit.{}", i);
  if (std::find(face_names.begin(), face_names.end(), exit.name) != face_names.end()) {
    errors.add(section + ".name", fmt::format("\"{}\" is the name of a whole face; take another", exit.name));
  }
  if (is_periodic(deck.domain, across(exit))) {
    errors.add(section + ".face",
               fmt::format("nothing leaves by \"{}\": {} is a periodic direction",
                           face_names[static_cast<std::size_t>(exit.face)], axis_names[index(across(exit))]));
  }
  for (const Axis axis : all_axes) {
    if (axis == across(exit)) continue;
    const double Vec3::*a = component(axis);
    if (exit.min.*a < exit.max.*a && exit.min.*a < deck.domain.max.*a && exit.max.*a > deck.domain.min.*a) continue;
    errors.add(section + ".max", fmt::format("from {} to {} in {} is no part of the domain's face", exit.min.*a,
                                             exit.max.*a, axis_names[index(axis)]));
  }
  for (std::size_t k = 0; k < i; ++k) {
    if (!lies_within(exit, deck.exits[k], deck.domain)) continue;
    errors.add(section,
               fmt::format("all of exit \"{0}\" lies in exit \"{1}\", which comes first and counts what leaves; "
                           "put \"{0}\" before \"{1}\"",
                           exit.name, deck.exits[k].name));
    return;
  }
}

}  // namespace

void check_domain(const Deck& deck, DeckErrors& errors) {
  for (const Axis axis : all_axes) {
    if (is_periodic(deck.domain, axis)) check_periodic(deck, axis, errors);
  }
  for (std::size_t i = 0; i < deck.exits.size(); ++i) check_exit(deck, i, errors);
}

}  // namespace repose
