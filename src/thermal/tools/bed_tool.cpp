#include "thermal/tools/bed_tool.h"

#include <cmath>

#include <fmt/core.h>

#include "heat/air.h"
#include "thermal/beds/bed_conductivity.h"
#include "thermal/beds/temperatures.h"
#include "thermal/tool_deck.h"

namespace repose::thermal {

/// A conductivity that was measured.
struct BedMeasurement {
  std::string name;
  double temperature = 0.0;   ///< K
  double conductivity = 0.0;  ///< W/(m K)
  double deviation = 0.0;     ///< its standard deviation
};

struct BedDeck {
  std::string title;
  double particle_density = 0.0;  ///< kg/m3
  double particle_density_deviation = 0.0;
  double bulk_density = 0.0;
  double bulk_density_deviation = 0.0;
  Bed bed;
  double pressure = 101325.0;  ///< Pa
  TemperatureRange temperature;
  std::vector<BedMeasurement> measurements;
};

template <class V>
void describe(V& v, BedMeasurement& m) {
  v("name", m.name, Unit::none, any_value, required, "what was measured with");
  v("temperature", m.temperature, Unit::kelvin, from_to(air_min_temperature, air_max_temperature), required,
    "of the bed");
  v("conductivity", m.conductivity, Unit::conductivity, above(0), required, "measured");
  v("deviation", m.deviation, Unit::conductivity, at_least(0), optional, "its standard deviation");
}

template <class V>
void describe(V& v, BedDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("particle_density", d.particle_density, Unit::density, above(0), required, "of the grains");
  v("particle_density_deviation", d.particle_density_deviation, Unit::density, at_least(0), optional,
    "its standard deviation");
  v("bulk_density", d.bulk_density, Unit::density, above(0), required, "of the bed");
  v("bulk_density_deviation", d.bulk_density_deviation, Unit::density, at_least(0), optional, "its standard deviation");
  v("diameter", d.bed.diameter, Unit::metre, above(0), required, "mean diameter of the grains");
  v("particle_conductivity", d.bed.particle_conductivity, Unit::conductivity, above(0), required, "of the solid");
  v("emissivity", d.bed.emissivity, Unit::none, above_to(0, 1), required, "of the grains' surface");
  v("shape_factor", d.bed.shape_factor, Unit::none, above(0), optional, "C_f: 1.25 spheres, 1.40 broken grains");
  v("size_distribution", d.bed.distribution, Unit::none, above(0), optional, "f(zeta): 1 for one size");
  v("flattening", d.bed.flattening, Unit::none, from_to_below(0, 1), optional, "share of the section that is contact");
  v("pressure", d.pressure, Unit::pascal, above(0), optional, "of the air");
  v.section("temperature", d.temperature, optional, "where to evaluate");
  v.sections("measurement", d.measurements, optional, "a measured conductivity");
}

namespace {

void check(BedDeck& deck, DeckErrors& errors) {
  deck.bed.porosity = porosity_of(deck.bulk_density, deck.particle_density);
  if (deck.bed.porosity <= 0.0) {
    errors.add("bulk_density", fmt::format("\"bulk_density\" = {} gives the porosity {:.4g}; it must be below "
                                           "\"particle_density\" = {}",
                                           deck.bulk_density, deck.bed.porosity, deck.particle_density));
  }
  check_range(deck.temperature, errors);
}

/// Standard deviation of the porosity, from those of the densities.
double porosity_deviation(const BedDeck& d) {
  return d.bulk_density / d.particle_density *
         std::hypot(d.bulk_density_deviation / d.bulk_density, d.particle_density_deviation / d.particle_density);
}

/// That of the conductivity, by central difference.
double conductivity_deviation(const BedDeck& deck, const Gas& gas) {
  const double step = 1e-4;
  Bed lower = deck.bed;
  Bed upper = deck.bed;
  lower.porosity *= 1.0 - step;
  upper.porosity *= 1.0 + step;
  const double slope =
      (bed_conductivity(upper, gas) - bed_conductivity(lower, gas)) / (upper.porosity - lower.porosity);
  return std::abs(slope) * porosity_deviation(deck);
}

Json row_at(const BedDeck& deck, double temperature) {
  const Gas gas = air_at(temperature, deck.pressure);
  const BedRatios ratios = ratios_of(deck.bed, gas);
  BedRatios cold = ratios;
  cold.radiation = 0.0;
  const double conductivity = bed_conductivity(deck.bed, gas);
  return {{"temperature_K", temperature},
          {"conductivity_W_mK", conductivity},
          {"conductivity_deviation_W_mK", conductivity_deviation(deck, gas)},
          {"without_radiation_W_mK", relative_bed_conductivity(cold) * gas.conductivity},
          {"relative_conductivity", conductivity / gas.conductivity},
          {"air_conductivity_W_mK", gas.conductivity},
          {"air_specific_heat_J_kgK", gas.specific_heat},
          {"air_density_kg_m3", air_density(temperature, deck.pressure)},
          {"accommodation", gas.accommodation},
          {"free_path_m", modified_free_path(gas)},
          {"lambda_particle", ratios.particle},
          {"lambda_radiation", ratios.radiation},
          {"lambda_gas", ratios.gas}};
}

Json compared(const BedDeck& deck, const BedMeasurement& m) {
  const double model = bed_conductivity(deck.bed, air_at(m.temperature, deck.pressure));
  return {{"name", m.name},
          {"temperature_K", m.temperature},
          {"conductivity_W_mK", m.conductivity},
          {"deviation_W_mK", m.deviation},
          {"model_W_mK", model},
          {"difference_percent", 100.0 * (m.conductivity / model - 1.0)}};
}

std::string bed_text(const Json& json) {
  std::string text = fmt::format("porosity {:.4f} +- {:.4f}\n\n", json["porosity"].get<double>(),
                                 json["porosity_deviation"].get<double>());
  text += "| T, K | k, W/(m K) | +- | without radiation | air |\n|---|---|---|---|---|\n";
  const auto number = [](const Json& object, const char* key) { return object[key].get<double>(); };
  for (const Json& r : json["conductivity"]) {
    text += fmt::format("| {:.2f} | {:.4f} | {:.4f} | {:.4f} | {:.5f} |\n", number(r, "temperature_K"),
                        number(r, "conductivity_W_mK"), number(r, "conductivity_deviation_W_mK"),
                        number(r, "without_radiation_W_mK"), number(r, "air_conductivity_W_mK"));
  }
  if (json["measurements"].empty()) return text;
  text += "\n| measurement | T, K | k, W/(m K) | model | difference |\n|---|---|---|---|---|\n";
  for (const Json& m : json["measurements"]) {
    text += fmt::format("| {} | {:.2f} | {:.4g} | {:.4f} | {:+.1f} % |\n", m["name"].get<std::string>(),
                        number(m, "temperature_K"), number(m, "conductivity_W_mK"), number(m, "model_W_mK"),
                        number(m, "difference_percent"));
  }
  return text;
}

}  // namespace

std::string bed_keys() { return key_reference<BedDeck>("Keys of a file for repose thermal bed."); }

ToolResult bed_tool(const ToolInput& input) {
  const auto deck = read_tool_deck<BedDeck>(input, check);
  Json rows = Json::array();
  Json measurements = Json::array();
  for (const double t : temperatures_of(deck.temperature)) rows.push_back(row_at(deck, t));
  for (const BedMeasurement& m : deck.measurements) measurements.push_back(compared(deck, m));
  ToolResult result;
  result.json = {{"tool", "bed"},
                 {"title", deck.title},
                 {"porosity", deck.bed.porosity},
                 {"porosity_deviation", porosity_deviation(deck)},
                 {"deformation_parameter", deformation_parameter(ratios_of(deck.bed, air_at(300.0, deck.pressure)))},
                 {"conductivity", rows},
                 {"measurements", measurements}};
  result.text = bed_text(result.json);
  return result;
}

}  // namespace repose::thermal
