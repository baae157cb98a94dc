#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/directions.h"

namespace repose {
namespace {

/// That the height is no periodic direction.
void check_open_height(const std::string& section, const Deck& deck, DeckErrors& errors) {
  if (is_periodic(deck.domain, Axis::z))
    errors.add(section, "the height z must not be a periodic direction of the [domain]");
}

/// That gravity draws grains down, whatever else it does.
void check_falls(const std::string& section, const Deck& deck, DeckErrors& errors) {
  if (deck.gravity.z < 0.0) return;
  errors.add(section, fmt::format("[{}] needs a gravity that points down, towards -z; set \"gravity\"", section));
}

/// That gravity draws grains straight down.
void check_upright(const std::string& section, const Deck& deck, DeckErrors& errors) {
  if (deck.gravity.z < 0.0 && are_parallel(deck.gravity, unit_along(Axis::z))) return;
  errors.add(section,
             fmt::format("[{}] needs a gravity that points straight down, along -z; set \"gravity\"", section));
}

void check_discharge(const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.discharge";
  check_open_height(section, deck, errors);
  check_falls(section, deck, errors);
  check_height(section, "orifice_height", deck.discharge.orifice_height, deck.domain, errors);
}

void check_angle_of_repose(const AngleOfReposeDeck& a, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.angle_of_repose";
  check_open_height(section, deck, errors);
  check_upright(section, deck, errors);
  if (is_periodic(deck.domain, Axis::x)) {
    errors.add(section, "a pile has no flanks along x, a periodic direction of the [domain]; only y may be one");
  }
  check_height(section, "plate_height", a.plate_height, deck.domain, errors);
  if (a.fit_from >= a.fit_to) {
    errors.add(section + ".fit_to",
               fmt::format("\"fit_to\" = {} must be greater than \"fit_from\" = {}", a.fit_to, a.fit_from));
  }
  if (a.max_height <= a.plate_height) {
    errors.add(section + ".max_height",
               fmt::format("\"max_height\" = {} must be above \"plate_height\" = {}", a.max_height, a.plate_height));
  }
}

void check_scattering(const ScatteringDeck& s, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.scattering";
  check_open_height(section, deck, errors);
  check_upright(section, deck, errors);
  check_height(section, "plate_height", s.plate_height, deck.domain, errors);
  if (!(s.plate_min.x < s.plate_max.x && s.plate_min.y < s.plate_max.y)) {
    errors.add(section + ".plate_max", "\"plate_max\" must be greater than \"plate_min\" in x and y");
    return;
  }
  if (s.max_height <= s.plate_height) {
    errors.add(section + ".max_height",
               fmt::format("\"max_height\" = {} must be above \"plate_height\" = {}", s.max_height, s.plate_height));
  }
  const double corner = std::hypot(std::max(s.axis.x - s.plate_min.x, s.plate_max.x - s.axis.x),
                                   std::max(s.axis.y - s.plate_min.y, s.plate_max.y - s.axis.y));
  const auto check_radius = [&](const std::string& key, double radius) {
    if (radius < corner) return;
    errors.add(section + "." + key,
               fmt::format("{} leaves nothing for area 3: the plate's farthest corner is {:.4g} from the axis", radius,
                           corner));
  };
  check_radius("area_3_radius", s.area_3_radius);
  for (std::size_t i = 0; i < s.area_3_widened.size(); ++i) {
    check_radius(fmt::format("area_3_widened.{}", i), s.area_3_widened[i]);
  }
}

void check_bulk_density(const BulkDensityDeck& b, const DomainDeck& domain, DeckErrors& errors) {
  const std::string section = "measurement.bulk_density";
  check_box(section, b.min, b.max, errors);
  for (double Vec3::*along : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    if (b.min.*along >= domain.min.*along && b.max.*along <= domain.max.*along) continue;
    errors.add(section + ".max", "the box reaches out of the [domain]; it has to lie in the settled bed");
    return;
  }
}

void check_retained_slope(const RetainedSlopeDeck& r, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.retained_slope";
  check_open_height(section, deck, errors);
  check_upright(section, deck, errors);
  check_height(section, "orifice_height", r.orifice_height, deck.domain, errors);
  if (r.fit_from < r.fit_to) return;
  errors.add(section + ".fit_to",
             fmt::format("\"fit_to\" = {} must be greater than \"fit_from\" = {}", r.fit_to, r.fit_from));
}

}  // namespace

void check_height(const std::string& section, const char* key, double height, const DomainDeck& domain,
                  DeckErrors& errors) {
  if (height >= domain.min.z && height <= domain.max.z) return;
  errors.add(section + "." + key, fmt::format("\"{}\" = {} lies outside the [domain], from {} to {}", key, height,
                                              domain.min.z, domain.max.z));
}

void check_grain_measurements(const Deck& deck, DeckErrors& errors) {
  if (deck.discharge.enabled) check_discharge(deck, errors);
  if (deck.bulk_density.enabled) check_bulk_density(deck.bulk_density, deck.domain, errors);
  if (deck.retained_slope.enabled) check_retained_slope(deck.retained_slope, deck, errors);
  if (deck.angle_of_repose.enabled) check_angle_of_repose(deck.angle_of_repose, deck, errors);
  if (deck.scattering.enabled) check_scattering(deck.scattering, deck, errors);
}

}  // namespace repose
