#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "base/error.h"
#include "import/formula.h"
#include "import/grain_list.h"
#include "import/heat_commands.h"
#include "import/translate.h"

namespace repose {
namespace {

/// What a command may change of a grain before the first run; after it a deck cannot say so.
bool comes_too_late(Translation& to, Words& words) {
  if (!to.scene.has_run()) return false;
  words.rest();
  note_missing(to.scene, words.command(), "grains are not changed between runs");
  return true;
}

/// The grains that are inserted are not known before the run.
void note_insertions(Translation& to, Words& words) {
  if (!to.scene.insertions.empty()) {
    note_missing(to.scene, words.command(), "it holds for the grains of lists alone, not for those that are inserted");
  }
}

void read_data(Translation& to, Words& words) {
  const std::string& file = words.word("the file");
  if (comes_too_late(to, words)) return;
  const GrainList list = parse_data_file(to.read_file(file), file, to.scene.units);
  if (!list.box) words.fail(fmt::format("{} has no box (xlo xhi, ...)", file));
  to.scene.box = list.box;
  to.scene.box_place = words.place();
  to.scene.types = std::max(1, list.types);
  to.scene.grains = list.grains;
  to.scene.grain_origins.push_back(words.command());
  for (const std::string& more : words.rest()) {
    note_missing(to.scene, words.command(), fmt::format("\"{}\" of read_data", more));
  }
}

/// read_restart FILE: its grains, box and step are those of the dump. The box may also be that of create_box.
void read_restart(Translation& to, Words& words) {
  words.rest();
  if (to.dump.empty())
    words.fail(
        "read_restart: binary restart files are read by the program that wrote them alone; give a dump (--dump)");
  if (comes_too_late(to, words)) return;
  const GrainList list = parse_dump(to.read_file(to.dump), to.dump, to.scene.units);
  if (!list.box) words.fail(fmt::format("{} has no box (ITEM: BOX BOUNDS)", to.dump));
  to.scene.box = list.box;
  to.scene.box_place = words.place();
  to.scene.types = list.types;
  to.scene.grains = list.grains;
  to.scene.first_step = list.step;
  to.scene.has_restarted = true;
  to.scene.grain_origins.push_back(words.command());
  note_missing(to.scene, words.command(), fmt::format("the grains of {} are there instead", to.dump));
}

/// create_atoms TYPE single X Y Z
void create_atoms(Translation& to, Words& words) {
  const std::int64_t type = words.integer("the type");
  const std::string& style = words.word("the style");
  if (style != "single") {
    return note_missing(to.scene, words.command(),
                        "grains on a lattice are [[particles]] of type lattice; write them by hand");
  }
  if (comes_too_late(to, words)) return;
  if (type < 1 || type > 1000) words.fail("types are counted from 1 on");
  Grain grain;
  grain.type = static_cast<int>(type);
  grain.position = to.scene.units.length * words.vector("the position");
  grain.radius = 0.5 * to.scene.units.length;  // as LAMMPS makes it
  grain.density = to.scene.units.density();
  for (const Grain& other : to.scene.grains) grain.id = std::max(grain.id, other.id);
  ++grain.id;
  to.scene.grains.push_back(grain);
  to.scene.grain_origins.push_back(words.command());
}

/// Of types or ids: N or FROM:TO, each.
void group_by_number(std::set<std::int64_t>& made, bool is_by_type, const ImportedScene& scene, Words& words) {
  for (const std::string& range : words.rest()) {
    const std::size_t colon = std::min(range.find(':'), range.size());
    const double low = number_of(range.substr(0, colon), words.place(), "type or id");
    const double high = colon == range.size() ? low : number_of(range.substr(colon + 1), words.place(), "type or id");
    for (const Grain& grain : scene.grains) {
      const auto number = static_cast<double>(is_by_type ? grain.type : grain.id);
      if (number >= low && number <= high) made.insert(grain.id);
    }
  }
}

/// union, intersect or subtract, as LIGGGHTS does it: only subtract takes grains out of a group that was there.
void group_by_groups(std::set<std::int64_t>& made, const std::string& style, const ImportedScene& scene, Words& words) {
  std::vector<const ScriptGroup*> groups;
  while (!words.at_end()) groups.push_back(&find_item(scene.groups, words.word("a group"), words, "group"));
  if (groups.empty()) words.fail("a group of no groups");
  for (const Grain& grain : scene.grains) {
    const auto has = [&](const ScriptGroup* group) { return group->holds(grain); };
    const bool is_in_others = std::any_of(groups.begin() + 1, groups.end(), has);
    if (style == "subtract" && is_in_others) {
      made.erase(grain.id);
    } else if (style == "intersect" ? std::all_of(groups.begin(), groups.end(), has)
                                    : is_in_others || has(groups.front())) {
      made.insert(grain.id);
    }
  }
}

/// group NAME type N... | region NAME | id FROM:TO... | union NAME... | ...
void group(Translation& to, Words& words) {
  const std::string name = words.word("the name of the group");
  const std::string style = words.word("the style of the group");
  std::set<std::int64_t>& made = to.scene.groups[name].grains;
  if (style == "type" || style == "id") {
    group_by_number(made, style == "type", to.scene, words);
  } else if (style == "union" || style == "intersect" || style == "subtract") {
    group_by_groups(made, style, to.scene, words);
  } else if (style == "region") {
    const ScriptRegion& region = find_item(to.scene.regions, words.word("the region"), words, "region");
    for (const Grain& grain : to.scene.grains) {
      if (is_inside(region, grain.position)) made.insert(grain.id);
    }
  } else if (style == "clear" || style == "delete") {
    made.clear();
  } else if (style != "empty" && style != "initialize" && !to.scene.grains.empty()) {
    words.fail(fmt::format("a group by \"{}\" has no counterpart", style));
  }
}

/// The grains of the list that a command names by STYLE ID.
std::vector<Grain*> chosen_grains(Translation& to, Words& words) {
  const std::string style = words.word("which grains");
  const std::string name = words.word("which grains");
  const auto whole = [&](const std::string& text) { return number_of(text, words.place(), "which grains"); };
  std::vector<Grain*> chosen;
  for (Grain& grain : to.scene.grains) {
    bool is_chosen = false;
    if (style == "group") {
      is_chosen = find_item(to.scene.groups, name, words, "group").holds(grain);
    } else if (style == "type") {
      is_chosen = static_cast<double>(grain.type) == whole(name);
    } else if (style == "atom") {
      is_chosen = static_cast<double>(grain.id) == whole(name);
    } else if (style == "region") {
      is_chosen = is_inside(find_item(to.scene.regions, name, words, "region"), grain.position);
    } else {
      words.fail(fmt::format("grains by \"{}\"; group, type, atom and region are known", style));
    }
    if (is_chosen) chosen.push_back(&grain);
  }
  return chosen;
}

/// A member of a grain by the word of `set`, and the unit of its value.
double* member(Grain& grain, const std::string& key) {
  const std::map<std::string, double*> members = {
      {"density", &grain.density}, {"diameter", &grain.radius}, {"x", &grain.position.x},  {"y", &grain.position.y},
      {"z", &grain.position.z},    {"vx", &grain.velocity.x},   {"vy", &grain.velocity.y}, {"vz", &grain.velocity.z},
      {"omegax", &grain.spin.x},   {"omegay", &grain.spin.y},   {"omegaz", &grain.spin.z},
  };
  const auto found = members.find(key);
  return found == members.end() ? nullptr : found->second;
}

double unit_of(const std::string& key, const ScriptUnits& units) {
  if (key == "density") return units.density();
  if (key == "diameter") return 0.5 * units.length;
  if (key.starts_with("omega")) return 1.0 / units.time;
  return key.starts_with("v") ? units.speed() : units.length;
}

/// set STYLE ID KEY VALUE ...
void set(Translation& to, Words& words) {
  const std::vector<std::string>& all = words.command().words;
  if (all.size() > 3 && all[3] == "property/atom") {
    const std::string style = words.word("which grains");
    const std::string id = words.word("which grains");
    words.expect("property/atom");
    return set_atom_property(to, words, style, id);
  }
  if (comes_too_late(to, words)) return;
  note_insertions(to, words);
  const std::vector<Grain*> grains = chosen_grains(to, words);
  Grain any;
  while (!words.at_end()) {
    const std::string key = words.word("a key");
    if (key == "type") {
      const int type = words.type();
      for (Grain* grain : grains) grain->type = type;
    } else if (member(any, key) != nullptr) {
      const double value = words.number(key) * unit_of(key, to.scene.units);
      if ((key == "density" || key == "diameter") && !(value > 0.0)) words.fail(fmt::format("{} is above 0", key));
      for (Grain* grain : grains) *member(*grain, key) = value;
    } else {
      words.rest();
      return note_missing(to.scene, words.command(), fmt::format("\"{}\" of grains", key));
    }
  }
  to.scene.grain_origins.push_back(words.command());
}

/// velocity GROUP set VX VY VZ
void velocity(Translation& to, Words& words) {
  if (comes_too_late(to, words)) return;
  note_insertions(to, words);
  const ScriptGroup& group = find_item(to.scene.groups, words.word("the group"), words, "group");
  if (!words.take("set")) return note_missing(to.scene, words.command(), "only velocity ... set has a counterpart");
  for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    if (words.take("NULL")) continue;
    const double value = words.number("the velocity") * to.scene.units.speed();
    for (Grain& grain : to.scene.grains) {
      if (group.holds(grain)) grain.velocity.*component = value;
    }
  }
  to.scene.grain_origins.push_back(words.command());
}

/// delete_atoms group NAME | region NAME
void delete_atoms(Translation& to, Words& words) {
  if (comes_too_late(to, words)) return;
  note_insertions(to, words);
  std::set<std::int64_t> ids;
  for (const Grain* grain : chosen_grains(to, words)) ids.insert(grain->id);
  std::erase_if(to.scene.grains, [&](const Grain& grain) { return ids.contains(grain.id); });
  to.scene.grain_origins.push_back(words.command());
}

/// fix ID GROUP freeze: acts when the first run begins (settle_groups).
void freeze(Translation& to, Words& words) { comes_too_late(to, words); }

/// The factor by which a formula of the radii, `c_NAME`, makes diameters larger; none when it is no such formula.
std::optional<double> growth_factor(const std::string& formula, const std::set<std::string>& radius_computes) {
  const auto diameter_for = [&](double radius) {
    return evaluate(formula, [&](const std::string& name) -> std::optional<double> {
      if (!name.starts_with("c_") || !radius_computes.contains(name.substr(2))) return {};
      return radius;
    });
  };
  try {
    const double of_one = diameter_for(1.0);
    const double factor = 0.5 * of_one;
    if (std::fabs(diameter_for(2.0) - 2.0 * of_one) <= 1e-12 * of_one && factor >= 1.0) return factor;
  } catch (const DeckError&) {
    return {};
  }
  return {};
}

/// fix ID GROUP adapt N atom diameter FORMULA
void adapt(Translation& to, Words& words) {
  const std::int64_t every = words.steps("the steps between two changes");
  const auto note = [&](const std::string& reason) {
    words.rest();
    note_missing(to.scene, words.command(), reason);
  };
  if (every < 1 || !words.take("atom") || !words.take("diameter"))
    return note("only atom diameter of fix adapt has a counterpart");
  const std::optional<double> factor = growth_factor(words.word("the diameter"), to.scene.radius_computes);
  if (!words.at_end()) return note(fmt::format("\"{}\" of fix adapt", words.word("a key")));
  if (!factor) return note("only diameters that grow by a factor have a counterpart");
  const bool is_second = std::any_of(to.scene.growths.begin(), to.scene.growths.end(),
                                     [](const ScriptGrowth& growth) { return growth.until == never_removed; });
  if (is_second) return note("grains grow by another fix already");
  if (words.command().words[2] != "all" && !to.scene.grains.empty())
    note_missing(to.scene, words.command(), "all grains grow, also those of other groups");
  to.scene.growths.push_back({.place = words.place(),
                              .name = words.command().words[1],
                              .factor = *factor,
                              .every = every,
                              .from = to.scene.runs.size()});
}

}  // namespace

const Translations& grain_commands() {
  static const Translations commands = {{"read_data", read_data},
                                        {"read_restart", read_restart},
                                        {"create_atoms", create_atoms},
                                        {"group", group},
                                        {"set", set},
                                        {"velocity", velocity},
                                        {"delete_atoms", delete_atoms}};
  return commands;
}

const Translations& grain_fixes() {
  static const Translations fixes = {
      {"freeze", freeze}, {"adapt", adapt}, {"heat/gran", translate_heat}, {"heat/gran/conduction", translate_heat}};
  return fixes;
}

}  // namespace repose
