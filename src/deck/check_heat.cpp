#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

bool rises(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return b <= a; }) == values.end();
}

void check_same_length(const std::string& key, std::size_t count, std::size_t wanted, const char* of,
                       DeckErrors& errors) {
  if (count == wanted) return;
  errors.add(key, fmt::format("{} values for {} {}; give one each", count, wanted, of));
}

void check_table(const std::string& section, const HeatTableDeck& table, DeckErrors& errors) {
  const std::size_t wanted = table.temperatures.size();
  if (wanted == 0) errors.add(section + ".temperatures", "\"temperatures\" is empty; give at least one");
  if (!rises(table.temperatures)) errors.add(section + ".temperatures", "\"temperatures\" must rise");
  check_same_length(section + ".conductivities", table.conductivities.size(), wanted, "temperatures", errors);
  check_same_length(section + ".specific_heats", table.specific_heats.size(), wanted, "temperatures", errors);
}

void check_material(const std::string& section, const MaterialDeck& material, const HeatDeck& heat,
                    DeckErrors& errors) {
  if (material.heat_table.enabled) check_table(section + ".heat_table", material.heat_table, errors);
  if (material.heat_table.enabled && (!std::isnan(material.conductivity) || !std::isnan(material.specific_heat))) {
    errors.add(section + ".heat_table",
               "there is a heat_table beside \"conductivity\" or \"specific_heat\", which it replaces; keep one");
  }
  if (!heat.enabled) return;
  const auto check_given = [&](const char* key, bool is_there, const char* why) {
    if (!is_there) errors.add(section + "." + key, fmt::format("\"{}\" is missing; {} needs it", key, why));
  };
  check_given("conductivity", material.heat_table.enabled || !std::isnan(material.conductivity), "[heat]");
  check_given("specific_heat", material.heat_table.enabled || !std::isnan(material.specific_heat), "[heat]");
  if (heat.radiation) check_given("emissivity", !std::isnan(material.emissivity), "heat.radiation");
}

void check_wall(const std::string& section, const WallHeatDeck& wall, DeckErrors& errors) {
  check_course(section, wall.times, wall.factors, errors);
  if (wall.type == WallHeatType::power) return;
  if (std::find(wall.factors.begin(), wall.factors.end(), 0.0) != wall.factors.end()) {
    errors.add(section + ".factors", "\"factors\" of a temperature must be above 0");
  }
}

void check_warm_box(const std::string& section, const PhaseHeatDeck& box, DeckErrors& errors) {
  check_box(section, box.min, box.max, errors);
  if (std::isnan(box.temperature) && std::isnan(box.power)) {
    errors.add(section, "neither \"temperature\" nor \"power\" is given; give one");
  }
}

}  // namespace

void check_course(const std::string& section, const std::vector<double>& times, const std::vector<double>& factors,
                  DeckErrors& errors) {
  if (!rises(times)) errors.add(section + ".times", "\"times\" must rise");
  check_same_length(section + ".factors", factors.size(), times.size(), "times", errors);
}

void check_heat(const Deck& deck, DeckErrors& errors) {
  const auto check_on = [&](const std::string& key, bool is_asked_for) {
    if (is_asked_for && !deck.heat.enabled)
      errors.add(key, "there is no [heat], without which nothing has a temperature");
  };
  for (std::size_t i = 0; i < deck.materials.size(); ++i) {
    check_material(fmt::format("material.{}", i), deck.materials[i], deck.heat, errors);
  }
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    const std::string section = fmt::format("wall.{}.heat", i);
    check_on(section, deck.walls[i].heat.enabled);
    if (deck.walls[i].heat.enabled) check_wall(section, deck.walls[i].heat, errors);
  }
  for (std::size_t i = 0; i < deck.particles.size(); ++i) {
    const ParticlesDeck& block = deck.particles[i];
    check_on(fmt::format("particles.{}.temperature", i), !std::isnan(block.temperature));
    check_on(fmt::format("particles.{}.isothermal", i), block.isothermal);
    check_on(fmt::format("particles.{}.heating", i), block.heating != 0.0);
    if (block.isothermal && block.heating != 0.0) {
      errors.add(
          fmt::format("particles.{}.heating", i),
          "\"heating\" has no effect on \"isothermal\" particles, which keep their temperature; remove one of the "
          "two");
    }
  }
  for (std::size_t i = 0; i < deck.phases.size(); ++i) {
    check_on(fmt::format("phase.{}.mechanics", i), !deck.phases[i].mechanics);
    for (std::size_t k = 0; k < deck.phases[i].heat.size(); ++k) {
      const std::string section = fmt::format("phase.{}.heat.{}", i, k);
      check_on(section, true);
      check_warm_box(section, deck.phases[i].heat[k], errors);
    }
  }
}

}  // namespace repose
