#include "import/heat_commands.h"

#include <fmt/core.h>

namespace repose {

void translate_heat(Translation& to, Words& words) {
  words.expect("initial_temperature");
  ScriptHeat heat{.place = words.place(), .temperature = words.number("the initial temperature")};
  if (!(heat.temperature > 0.0)) words.fail("the initial temperature is above 0");
  std::string missing;
  while (!words.at_end()) {
    const std::string key = words.word("a key");
    const std::string value = words.word(key);
    if (key == "area_correction") {
      heat.area_correction = value == "yes";
    } else if (key == "contact_area") {
      if (value == "constant") words.word("the area");
      if (value != "overlap") missing = fmt::format("contact_area {}: contacts conduct by their overlap", value);
    } else if (key != "store_contact_data") {
      missing = fmt::format("\"{}\" of fix heat/gran", key);
    }
  }
  if (to.scene.has_run()) missing = "grains carry heat from the first run on or not at all";
  if (!missing.empty()) note_missing(to.scene, words.command(), missing);
  if (!to.scene.has_run()) to.scene.heat = heat;
}

void set_atom_property(Translation& to, Words& words, const std::string& style, const std::string& id) {
  ScriptHeating heating{.place = words.place(), .from = to.scene.runs.size()};
  const std::string name = words.word("the name of the property");
  if (name == "Temp" || name == "heatSource") {
    const double value = words.number(name);
    if (name == "Temp") {
      if (!(value > 0.0)) words.fail("a temperature is above 0");
      heating.temperature = value;
      heating.until = heating.from + 1;  // what it becomes then is up to the grains
    } else {
      heating.power = value * to.scene.units.power();
    }
  } else {
    words.rest();
    return note_missing(to.scene, words.command(), fmt::format("grains have no {}", name));
  }
  const auto note = [&](const std::string& reason) { note_missing(to.scene, words.command(), reason); };
  if (!words.at_end()) return note(fmt::format("\"{}\" of set", words.rest().front()));
  if (!to.scene.heat) return note("no fix heat/gran was there before");
  if (style == "region") {
    const ScriptRegion& region = find_item(to.scene.regions, id, words, "region");
    if (region.kind != "block" || !region.is_inside) return note("the heat of grains is set in blocks alone");
    heating.region = id;
  } else if (style != "group" || id != "all") {
    return note("the heat of grains is set by region, or of all");
  }
  to.scene.heatings.push_back(heating);
}

}  // namespace repose
