#include "deck/read_deck.h"

#include <cmath>

#include "base/error.h"
#include "deck/check_deck.h"
#include "deck/deck.h"
#include "deck/deck_kind.h"
#include "deck/read_described.h"

namespace repose {
namespace {

void set_default(double& value, double fallback) {
  if (std::isnan(value)) value = fallback;
}

void resolve_measurements(Deck& deck) {
  const double top = deck.discharge.enabled ? deck.discharge.orifice_height : deck.domain.max.z;
  if (deck.angle_of_repose.enabled) {
    set_default(deck.angle_of_repose.max_height, top);
    if (deck.angle_of_repose.camera == Camera::perspective) {
      set_default(deck.angle_of_repose.camera_height, deck.angle_of_repose.plate_height);
    }
  }
  ScatteringDeck& s = deck.scattering;
  if (!s.enabled) return;
  set_default(s.max_height, top);
  for (double Vec3::*along : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    set_default(s.plate_min.*along, deck.domain.min.*along);
    set_default(s.plate_max.*along, deck.domain.max.*along);
  }
}

/// Limits of a part of a face that were not given are those of the domain.
void set_limits(ExitDeck& exit, const DomainDeck& domain) {
  for (double Vec3::*along : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    set_default(exit.min.*along, domain.min.*along);
    set_default(exit.max.*along, domain.max.*along);
  }
}

void resolve_defaults(Deck& deck) {
  for (ExitDeck& exit : deck.exits) set_limits(exit, deck.domain);
  for (ParticlesDeck& p : deck.particles) {
    if (comes_from_file(p.type)) continue;
    if (p.type == ParticlesType::fill) set_default(p.spacing, 1.1 * p.diameter);
    if (p.region == RegionShape::cylinder && p.counts.empty()) set_default(p.radius_top, p.radius);
  }
  resolve_measurements(deck);
}

}  // namespace

Deck read_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  require_run_deck(text, path);
  return read_described<Deck>(text, path, overrides, [](Deck& deck, DeckErrors& errors) {
    resolve_defaults(deck);
    check_deck(deck, errors);
  });
}

Deck read_written_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  require_run_deck(text, path);
  return read_described<Deck>(text, path, overrides, [](Deck& deck, DeckErrors&) { resolve_defaults(deck); });
}

}  // namespace repose
