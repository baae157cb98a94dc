#include "thermal/tools/mixture_tool.h"

#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "heat/air.h"
#include "thermal/beds/mixture.h"
#include "thermal/tool_deck.h"

namespace repose::thermal {

/// The bed at one temperature.
struct MixtureState {
  double temperature = 0.0;                                               ///< K
  double specific_heat = std::numeric_limits<double>::quiet_NaN();        ///< of the grains, J/(kg K)
  double measured_volumetric = std::numeric_limits<double>::quiet_NaN();  ///< of the bed, J/(m3 K)
  double measured_deviation = 0.0;
};

struct MixtureDeck {
  std::string title;
  double particle_density = 0.0;  ///< kg/m3
  double bulk_density = 0.0;
  double bulk_density_deviation = 0.0;
  double pressure = 101325.0;  ///< Pa
  double negligible = 1e-3;    ///< relative change of the heat capacities
  std::vector<MixtureState> states;
};

template <class V>
void describe(V& v, MixtureState& s) {
  v("temperature", s.temperature, Unit::kelvin, from_to(air_min_temperature, air_max_temperature), required,
    "of the bed");
  v("specific_heat", s.specific_heat, Unit::specific_heat, above(0), optional, "of the grains");
  v("measured_volumetric", s.measured_volumetric, Unit::volumetric_heat, above(0), optional, "of the bed");
  v("measured_deviation", s.measured_deviation, Unit::volumetric_heat, at_least(0), optional, "its standard deviation");
}

template <class V>
void describe(V& v, MixtureDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("particle_density", d.particle_density, Unit::density, above(0), required, "of the grains");
  v("bulk_density", d.bulk_density, Unit::density, above(0), required, "of the bed");
  v("bulk_density_deviation", d.bulk_density_deviation, Unit::density, at_least(0), optional, "its standard deviation");
  v("pressure", d.pressure, Unit::pascal, above(0), optional, "of the air");
  v("negligible", d.negligible, Unit::none, above(0), optional, "relative change that may be neglected");
  v.sections("state", d.states, required, "the bed at a temperature");
}

namespace {

void check(MixtureDeck& deck, DeckErrors& errors) {
  if (deck.bulk_density >= deck.particle_density) {
    errors.add("bulk_density", fmt::format("\"bulk_density\" = {} must be below \"particle_density\" = {}: the "
                                           "porosity would not be positive",
                                           deck.bulk_density, deck.particle_density));
  }
  for (std::size_t i = 0; i < deck.states.size(); ++i) {
    const MixtureState& s = deck.states[i];
    if (std::isnan(s.specific_heat) == std::isnan(s.measured_volumetric))
      errors.add(fmt::format("state.{}", i), "[[state]] needs one of \"specific_heat\" and \"measured_volumetric\"");
  }
}

Json state_json(const MixtureDeck& deck, const MixtureState& s) {
  Json json = {{"temperature_K", s.temperature}};
  double specific_heat = s.specific_heat;
  if (!std::isnan(s.measured_volumetric)) {
    specific_heat = s.measured_volumetric / deck.bulk_density;  // (A.5)
    const double deviation =
        std::hypot(s.measured_deviation / s.measured_volumetric, deck.bulk_density_deviation / deck.bulk_density);
    json["measured_volumetric_J_m3K"] = s.measured_volumetric;
    json["particle_specific_heat_deviation_J_kgK"] = specific_heat * deviation;
  }
  const HeatCapacity c = heat_capacity_of({.bulk_density = deck.bulk_density,
                                           .particle_density = deck.particle_density,
                                           .specific_heat = specific_heat,
                                           .gas_density = air_density(s.temperature, deck.pressure),
                                           .gas_specific_heat = air_specific_heat(s.temperature)});
  json.update(Json{{"particle_specific_heat_J_kgK", specific_heat},
                   {"specific_heat_J_kgK", c.specific_heat},
                   {"volumetric_J_m3K", c.volumetric},
                   {"volumetric_without_air_J_m3K", c.volumetric_without_gas},
                   {"air_mass_share", c.gas_mass_share},
                   {"specific_heat_difference", c.specific_heat_difference},
                   {"volumetric_difference", c.volumetric_difference},
                   {"air_is_negligible", std::abs(c.specific_heat_difference) <= deck.negligible &&
                                             c.volumetric_difference <= deck.negligible}});
  return json;
}

}  // namespace

std::string mixture_keys() { return key_reference<MixtureDeck>("Keys of a file for repose thermal mixture."); }

ToolResult mixture_tool(const ToolInput& input) {
  const auto deck = read_tool_deck<MixtureDeck>(input, check);
  Json states = Json::array();
  ToolResult result;
  result.text =
      "| T, K | c_p grains, J/(kg K) | c_p bed | C_v bed, J/(m3 K) | air's mass | c_p changes | C_v changes | air |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const MixtureState& s : deck.states) {
    const Json j = state_json(deck, s);
    const auto number = [&](const char* key) { return j[key].get<double>(); };
    result.text +=
        fmt::format("| {:.2f} | {:.2f} | {:.2f} | {:.5g} | {:.2e} | {:+.2e} | {:+.2e} | {} |\n", s.temperature,
                    number("particle_specific_heat_J_kgK"), number("specific_heat_J_kgK"), number("volumetric_J_m3K"),
                    number("air_mass_share"), number("specific_heat_difference"), number("volumetric_difference"),
                    j["air_is_negligible"].get<bool>() ? "negligible" : "counts");
    states.push_back(j);
  }
  result.json = {{"tool", "mixture"}, {"title", deck.title}, {"negligible", deck.negligible}, {"states", states}};
  return result;
}

}  // namespace repose::thermal
