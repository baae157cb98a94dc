#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "deck/key.h"

/// Heat in the grains.
namespace repose {

enum class ContactConductance { hertz, intersection };
constexpr auto enumerators(ContactConductance) { return std::array<std::string_view, 2>{"hertz", "intersection"}; }

enum class GapGas { none, air };
constexpr auto enumerators(GapGas) { return std::array<std::string_view, 2>{"none", "air"}; }

struct HeatDeck {
  bool enabled = false;  ///< true when the deck has the section
  double temperature = 293.15;
  std::int64_t every = 10;
  ContactConductance conductance = ContactConductance::hertz;
  GapGas gas = GapGas::none;
  double pressure = 101325.0;
  bool radiation = false;
  double max_gap = 1.0;
  double porosity = 0.4;
};

inline bool crosses_gaps(const HeatDeck& h) { return h.gas != GapGas::none || h.radiation; }

template <class V>
void describe(V& v, HeatDeck& h) {
  v("temperature", h.temperature, Unit::kelvin, above_to(0, 5000), optional, "of all particles that enter");
  v("every", h.every, Unit::none, from_to(1, 1000000), optional, "mechanical steps in a thermal step");
  v("conductance", h.conductance, Unit::none, any_value, optional,
    "of contacts; hertz: by the radius of the contact; intersection: by the area in which the spheres cut (LIGGGHTS)");
  v("gas", h.gas, Unit::none, any_value, optional,
    "air: conducts in the gaps around contacts and between near surfaces");
  v("pressure", h.pressure, Unit::pascal, above(0), optional.when(h.gas == GapGas::air, "gas = air"), "of the gas");
  v("radiation", h.radiation, Unit::none, any_value, optional, "surfaces that are near radiate to one another");
  v("max_gap", h.max_gap, Unit::none, from_to(0, 2), optional.when(crosses_gaps(h), "gas or radiation"),
    "widest gap that heat crosses, over the mean radius");
  v("porosity", h.porosity, Unit::none, above_to(0, 0.95), optional.when(crosses_gaps(h), "gas or radiation"),
    "of the bed, which says how wide the column of a pair is");
}

/// [material.heat_table]: properties at temperatures, linear between them and constant beyond.
struct HeatTableDeck {
  bool enabled = false;  ///< true when the material has the section
  std::vector<double> temperatures;
  std::vector<double> conductivities;
  std::vector<double> specific_heats;
};

template <class V>
void describe(V& v, HeatTableDeck& t) {
  v("temperatures", t.temperatures, Unit::kelvin, above_to(0, 5000), required, "from low to high");
  v("conductivities", t.conductivities, Unit::conductivity, above(0), required, "one per temperature");
  v("specific_heats", t.specific_heats, Unit::specific_heat, above(0), required, "one per temperature");
}

enum class WallHeatType { temperature, power, ambient };
constexpr auto enumerators(WallHeatType) { return std::array<std::string_view, 3>{"temperature", "power", "ambient"}; }

/// [wall.heat]
struct WallHeatDeck {
  bool enabled = false;  ///< true when the wall has the section
  WallHeatType type = WallHeatType::temperature;
  double temperature = unset;
  double power = unset;
  double coefficient = unset;
  std::vector<double> times;
  std::vector<double> factors;
};

template <class V>
void describe(V& v, WallHeatDeck& w) {
  v("type", w.type, Unit::none, any_value, required,
    "temperature: it has one; power: it hands on so much; ambient: it meets the grains' heat from outside");
  const bool is_power = w.type == WallHeatType::power;
  const bool is_ambient = w.type == WallHeatType::ambient;
  v("temperature", w.temperature, Unit::kelvin, above_to(0, 5000),
    required.when(!is_power, "type = temperature, ambient"), "of the wall, or outside");
  v("power", w.power, Unit::watt, any_value, required.when(is_power, "type = power"),
    "into the grains at it, all in all; below 0 it cools");
  v("coefficient", w.coefficient, Unit::conductance, above(0), required.when(is_ambient, "type = ambient"),
    "heat per time and kelvin between the wall and outside");
  v("times", w.times, Unit::second, at_least(0), optional, "of the run, from small to large");
  v("factors", w.factors, Unit::none, at_least(0), required.when(!w.times.empty(), "times"),
    "of temperature or power at each of the times, linear between them and constant beyond");
}

}  // namespace repose
