#include "deck/check_deck.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/core.h>

#include "deck/nearest.h"

namespace repose {
namespace {

std::string element(const char* section, std::size_t index, const char* key) {
  return fmt::format("{}.{}.{}", section, index, key);
}

bool is_name(const std::string& text) {
  const auto is_allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         std::all_of(text.begin(), text.end(), is_allowed);
}

template <class S>
std::vector<std::string> check_names(const char* section, const std::vector<S>& all, DeckErrors& errors) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    const std::string key = element(section, i, "name");
    if (!is_name(name)) {
      errors.add(key, fmt::format("\"{}\" is no name; begin with a letter, then letters, digits, _ or -", name));
    }
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      errors.add(key, fmt::format("there are two [[{}]] \"{}\"; a name is used once", section, name));
    }
    names.push_back(name);
  }
  return names;
}

void check_material(const std::string& key, const std::string& name, const std::vector<std::string>& materials,
                    DeckErrors& errors) {
  if (std::find(materials.begin(), materials.end(), name) != materials.end()) return;
  errors.add(key, fmt::format("unknown material \"{}\"; the nearest is \"{}\"", name, nearest(name, materials)));
}

void check_materials(const Deck& deck, const std::vector<std::string>& materials, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.pairs.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      check_material(fmt::format("pair.{}.materials.{}", i, k), deck.pairs[i].materials[k], materials, errors);
    }
  }
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    check_material(element("wall", i, "material"), deck.walls[i].material, materials, errors);
  }
  for (std::size_t i = 0; i < deck.particles.size(); ++i) {
    if (comes_from_file(deck.particles[i].type)) continue;
    check_material(element("particles", i, "material"), deck.particles[i].material, materials, errors);
  }
}

using PairName = std::pair<std::string, std::string>;

PairName sorted(const std::string& a, const std::string& b) { return a < b ? PairName{a, b} : PairName{b, a}; }

void check_pairs(const Deck& deck, DeckErrors& errors) {
  std::set<PairName> given;
  for (std::size_t i = 0; i < deck.pairs.size(); ++i) {
    const auto& [a, b] = deck.pairs[i].materials;
    if (given.insert(sorted(a, b)).second) continue;
    errors.add(element("pair", i, "materials"),
               fmt::format("the pair of \"{}\" and \"{}\" is given twice; the order of the two does not matter", a, b));
  }
  const auto check_given = [&](const std::string& key, const std::string& a, const std::string& b) {
    if (given.contains(sorted(a, b))) return;
    errors.add(
        key,
        fmt::format("no [[pair]] for \"{0}\" and \"{1}\", which can touch; add materials = [\"{0}\", \"{1}\"]", a, b));
  };
  for (std::size_t i = 0; i < deck.particles.size(); ++i) {
    if (comes_from_file(deck.particles[i].type)) continue;  // the materials of a list are known once it is read
    const std::string& material = deck.particles[i].material;
    for (std::size_t j = 0; j <= i; ++j) {
      if (comes_from_file(deck.particles[j].type)) continue;
      check_given(element("particles", i, "material"), material, deck.particles[j].material);
    }
    for (std::size_t w = 0; w < deck.walls.size(); ++w) {
      check_given(element("wall", w, "material"), material, deck.walls[w].material);
    }
  }
}

void check_height(const std::string& section, const char* key, double height, const DomainDeck& domain,
                  DeckErrors& errors) {
  if (height >= domain.min.z && height <= domain.max.z) return;
  errors.add(section + "." + key, fmt::format("\"{}\" = {} lies outside the [domain], from {} to {}", key, height,
                                              domain.min.z, domain.max.z));
}

void check_angle_of_repose(const AngleOfReposeDeck& a, const DomainDeck& domain, DeckErrors& errors) {
  const std::string section = "measurement.angle_of_repose";
  check_height(section, "plate_height", a.plate_height, domain, errors);
  if (a.fit_from >= a.fit_to) {
    errors.add(section + ".fit_to",
               fmt::format("\"fit_to\" = {} must be greater than \"fit_from\" = {}", a.fit_to, a.fit_from));
  }
  if (a.max_height <= a.plate_height) {
    errors.add(section + ".max_height",
               fmt::format("\"max_height\" = {} must be above \"plate_height\" = {}", a.max_height, a.plate_height));
  }
}

void check_scattering(const ScatteringDeck& s, const DomainDeck& domain, DeckErrors& errors) {
  const std::string section = "measurement.scattering";
  check_height(section, "plate_height", s.plate_height, domain, errors);
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

void check_retained_slope(const RetainedSlopeDeck& r, DeckErrors& errors) {
  if (r.fit_from < r.fit_to) return;
  errors.add("measurement.retained_slope.fit_to",
             fmt::format("\"fit_to\" = {} must be greater than \"fit_from\" = {}", r.fit_to, r.fit_from));
}

void check_shear(const ShearDeck& s, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.shear";
  find_walls(section + ".walls", s.walls, "one half of the cell", deck, errors);
  check_phase_names(section, {s.phase}, deck, errors);
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

void check_compression(const CompressionDeck& c, const Deck& deck, DeckErrors& errors) {
  const std::string section = "measurement.compression";
  const WallDeck* lid = find_wall(section + ".lid", c.lid, deck, errors);
  if (lid != nullptr && !(lid->servo.enabled && lid->servo.type == ServoType::translation)) {
    errors.add(section + ".lid", fmt::format("wall \"{}\" has no [wall.servo] that presses", c.lid));
  }
  check_phase_names(section, {c.load_phase, c.unload_phase}, deck, errors);
  const auto place = [&](const std::string& name) {
    return std::find_if(deck.phases.begin(), deck.phases.end(), [&](const PhaseDeck& p) { return p.name == name; });
  };
  if (place(c.load_phase) != deck.phases.end() && place(c.unload_phase) <= place(c.load_phase)) {
    errors.add(section + ".unload_phase",
               fmt::format("phase \"{}\" does not come after \"load_phase\" = \"{}\"", c.unload_phase, c.load_phase));
  }
}

void check_measurement(const Deck& deck, DeckErrors& errors) {
  if (deck.discharge.enabled) {
    check_height("measurement.discharge", "orifice_height", deck.discharge.orifice_height, deck.domain, errors);
  }
  if (deck.shear.enabled) check_shear(deck.shear, deck, errors);
  if (deck.compression.enabled) check_compression(deck.compression, deck, errors);
  if (deck.bulk_density.enabled) check_bulk_density(deck.bulk_density, deck.domain, errors);
  if (deck.retained_slope.enabled) check_retained_slope(deck.retained_slope, errors);
  if (deck.angle_of_repose.enabled) check_angle_of_repose(deck.angle_of_repose, deck.domain, errors);
  if (deck.scattering.enabled) check_scattering(deck.scattering, deck.domain, errors);
}

}  // namespace

void check_box(const std::string& section, const Vec3& min, const Vec3& max, DeckErrors& errors) {
  if (min.x < max.x && min.y < max.y && min.z < max.z) return;
  errors.add(section + ".max", "\"max\" must be greater than \"min\" in x, y and z");
}

void check_deck(const Deck& deck, DeckErrors& errors) {
  check_box("domain", deck.domain.min, deck.domain.max, errors);
  const std::vector<std::string> materials = check_names("material", deck.materials, errors);
  check_names("wall", deck.walls, errors);
  check_names("exit", deck.exits, errors);
  check_names("phase", deck.phases, errors);
  const std::size_t errors_before = errors.count();
  check_materials(deck, materials, errors);
  if (errors.count() == errors_before) check_pairs(deck, errors);  // a misspelled material would lack its pairs as well
  check_domain(deck, errors);
  check_contact(deck, errors);
  check_wall_shapes(deck, errors);
  check_particles(deck, errors);
  check_phases(deck, errors);
  check_motions(deck, errors);
  check_servos(deck, errors);
  check_heat(deck, errors);
  check_measurement(deck, errors);
  if (deck.neighbours.inner_skin > deck.neighbours.skin) {
    errors.add("neighbours.inner_skin", fmt::format("\"inner_skin\" = {} must be at most \"skin\" = {}",
                                                    deck.neighbours.inner_skin, deck.neighbours.skin));
  }
}

}  // namespace repose
