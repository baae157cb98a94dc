#include <cmath>

#include <fmt/core.h>

#include "base/math.h"
#include "import/translate.h"

namespace repose {
namespace {

/// fix property/global NAME KIND VALUE...
void property(Translation& to, Words& words) {
  const std::string name = words.word("the name of the property");
  Property property{words.place(), words.word("the kind of the property"), {}};
  if (property.kind == "atomtype" || property.kind == "atomtypepair") property.kind = "per" + property.kind;
  if (property.kind == "peratomtypepair" || property.kind == "matrix") words.integer("the number of types");
  for (const std::string& value : words.rest()) property.values.push_back(number_of(value, words.place(), name));
  if (property.values.empty()) words.fail(fmt::format("property \"{}\" has no value", name));
  const auto before = to.scene.properties.find(name);
  if (to.scene.has_run() && before != to.scene.properties.end() && before->second.values != property.values) {
    return note_missing(to.scene, words.command(), "properties stay as they are in the first run");
  }
  to.scene.properties[name] = property;
}

void gravity(Translation& to, Words& words) {
  const double size = words.number("the acceleration") * to.scene.units.acceleration();
  const std::string& style = words.word("the direction of gravity");
  Vec3 direction;
  if (style == "vector") {
    direction = words.vector("the direction of gravity");
  } else if (style == "chute") {
    const double angle = words.number("the angle of the chute") * pi / 180.0;
    direction = {std::sin(angle), 0.0, -std::cos(angle)};
  } else {
    words.fail(fmt::format("gravity {}: vector and chute are known", style));
  }
  if (!(norm(direction) > 0.0)) words.fail("the direction of gravity has no length");
  if (to.scene.has_run()) {
    return note_missing(to.scene, words.command(), "gravity stays as it is in the first run");
  }
  to.scene.gravities[words.command().words[1]] = {words.place(), (size / norm(direction)) * direction};
}

void integrator(Translation& to, Words& words) {
  note_needless(to.scene, words.command(), "grains move by themselves");
}

}  // namespace

const Translations& property_fixes() {
  static const Translations fixes = {{"property/global", property}, {"gravity", gravity}, {"nve/sphere", integrator}};
  return fixes;
}

}  // namespace repose
