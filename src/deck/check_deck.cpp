#include "deck/check_deck.h"

#include <algorithm>
#include <cctype>
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
  check_time(deck, errors);
  const std::size_t errors_before_phases = errors.count();
  check_phases(deck, errors);
  if (errors.count() == errors_before_phases) {  // a misspelled wall would not be there, either
    check_moving_walls(deck, errors);
    check_driven_measurements(deck, errors);
  }
  check_motions(deck, errors);
  check_servos(deck, errors);
  check_tilt(deck, errors);
  check_heat(deck, errors);
  check_grain_measurements(deck, errors);
  if (deck.neighbours.inner_skin > deck.neighbours.skin) {
    errors.add("neighbours.inner_skin", fmt::format("\"inner_skin\" = {} must be at most \"skin\" = {}",
                                                    deck.neighbours.inner_skin, deck.neighbours.skin));
  }
}

}  // namespace repose
