#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "import/translate.h"

namespace repose {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void units(Translation& to, Words& words) {
  const std::string& system = words.word("the units");
  if (system == "si") {
    to.scene.units = si_units;
  } else if (system == "cgs") {
    to.scene.units = cgs_units;
  } else {
    words.fail(fmt::format("units {}: only si and cgs are known", system));
  }
}

void dimension(Translation& to, Words& words) {
  if (words.integer("the number of dimensions") != 3) words.fail("grains are spheres in three dimensions");
  note_needless(to.scene, words.command(), "space has three dimensions");
}

void clear(Translation& to, Words& words) {
  if (to.scene.has_run()) words.fail("a deck is one simulation; make a script of its own of what comes after clear");
  to.scene = ImportedScene();
  note_needless(to.scene, words.command(), "nothing has been run before");
}

void neigh_modify(Translation& to, Words& words) {
  while (!words.at_end()) {
    if (words.take("exclude") && !words.take("none")) {
      return note_missing(to.scene, words.command(), "all grains touch one another");
    }
    if (!words.at_end()) words.word("a key");
  }
  note_needless(to.scene, words.command(), "neighbour lists adapt by themselves");
}

void atom_style(Translation&, Words& words) {
  for (const std::string& style : words.rest()) {
    if (style == "granular" || style == "sphere" || style == "hybrid") continue;
    words.fail(fmt::format("atom_style {}: only grains that are spheres (granular, sphere) have a counterpart", style));
  }
}

void boundary(Translation& to, Words& words) {
  for (std::string& side : to.scene.boundary) {
    side = words.word("the boundaries of x, y and z");
    const bool is_known = !side.empty() && side.size() <= 2 && side.find_first_not_of("pfsm") == std::string::npos;
    if (!is_known || (side.size() == 2 && side.find('p') != std::string::npos)) {
      words.fail(fmt::format("boundary \"{}\"; p, f, s, m or two of the last three are known", side));
    }
  }
}

/// A bound of a block; EDGE is that of the box.
double bound(Words& words, const ImportedScene& scene, double Vec3::*component, bool is_upper) {
  if (words.take("INF")) return is_upper ? infinite : -infinite;
  if (words.take("EDGE")) {
    if (!scene.box) return is_upper ? infinite : -infinite;
    return (is_upper ? scene.box->max : scene.box->min).*component;
  }
  return words.number("a bound of the region") * scene.units.length;
}

Extent block(Words& words, const ImportedScene& scene) {
  Extent extent;
  for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    extent.min.*component = bound(words, scene, component, false);
    extent.max.*component = bound(words, scene, component, true);
    if (!(extent.min.*component < extent.max.*component)) words.fail("the region has no volume");
  }
  return extent;
}

void cylinder(ScriptRegion& region, Words& words, const ImportedScene& scene) {
  const std::string& axis = words.word("the axis of the cylinder");
  if (axis != "x" && axis != "y" && axis != "z")
    words.fail(fmt::format("a cylinder along \"{}\"; x, y, z are known", axis));
  region.axis = axis[0];
  region.c1 = words.number("the axis of the cylinder") * scene.units.length;
  region.c2 = words.number("the axis of the cylinder") * scene.units.length;
  region.radius = words.number("the radius") * scene.units.length;
  double Vec3::*along = region.axis == 'x' ? &Vec3::x : region.axis == 'y' ? &Vec3::y : &Vec3::z;
  region.low = bound(words, scene, along, false);
  region.high = bound(words, scene, along, true);
  if (!(region.radius > 0.0) || !(region.low < region.high)) words.fail("the region has no volume");
}

void region(Translation& to, Words& words) {
  const std::string name = words.word("the name of the region");
  ScriptRegion region{.place = words.place(), .kind = words.word("the shape of the region")};
  if (region.kind == "delete") {
    if (!is_in_use(to.scene, name)) to.scene.regions.erase(name);
    return;
  }
  refuse_second(to.scene, name, words);
  if (region.kind == "block") {
    region.block = block(words, to.scene);
  } else if (region.kind == "cylinder") {
    cylinder(region, words, to.scene);
  } else {
    words.rest();
  }
  while (!words.at_end()) {
    const std::string& key = words.word("a key");
    if (key == "units") {
      words.expect("box");
    } else if (key == "side") {
      region.is_inside = words.word("the side") != "out";
    } else if (key == "seed" || key == "volume_limit") {
      words.word(key);
    } else {
      words.fail(fmt::format("region: \"{}\" has no counterpart", key));
    }
  }
  to.scene.regions[name] = region;
}

void create_box(Translation& to, Words& words) {
  const std::int64_t types = words.integer("the number of types");
  const ScriptRegion& region = find_item(to.scene.regions, words.word("the region of the box"), words, "region");
  if (types < 1 || types > 1000) words.fail(fmt::format("{} types", types));
  if (region.kind != "block")
    words.fail(fmt::format("a box of a region that is a {}; only a block is one", region.kind));
  const auto& [min, max] = region.block;
  for (const double value : {min.x, min.y, min.z, max.x, max.y, max.z}) {
    if (!std::isfinite(value)) words.fail("the box is not finite");
  }
  to.scene.box = region.block;
  to.scene.box_place = words.place();
  to.scene.types = static_cast<int>(types);
}

}  // namespace

const Translations& box_commands() {
  static const Translations commands = {
      {"units", units},           {"dimension", dimension}, {"clear", clear},   {"neigh_modify", neigh_modify},
      {"atom_style", atom_style}, {"boundary", boundary},   {"region", region}, {"create_box", create_box}};
  return commands;
}

}  // namespace repose
