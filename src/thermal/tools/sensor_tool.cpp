#include "thermal/tools/sensor_tool.h"

#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "thermal/plane_source/sensor_correction.h"
#include "thermal/tool_deck.h"

namespace repose::thermal {

enum class InsulationType { kapton, mica };
constexpr auto enumerators(InsulationType) { return std::array<std::string_view, 2>{"kapton", "mica"}; }

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// What a sensor has read of a sample.
struct ReadingDeck {
  InsulationType insulation = InsulationType::kapton;
  double radius = 0.0;                             ///< m
  double temperature = 0.0;                        ///< K; of readings at temperature alone
  Measured specific_heat;                          ///< J/(kg K)
  Measured conductivity;                           ///< W/(m K)
  double printed_specific_heat_error = not_given;  ///< percent
  double printed_conductivity_error = not_given;
};

/// A reading at temperature, which is with mica.
struct HotReadingDeck {
  ReadingDeck reading;
};

struct MaterialReadings {
  std::string name;
  double specific_heat = not_given;  ///< of the literature
  double conductivity = not_given;
  std::vector<ReadingDeck> room;
  std::vector<HotReadingDeck> hot;
};

struct SensorCorrectionDeck {
  std::string title;
  double specific_heat_half_unit = 0.005;
  double conductivity_half_unit = 0.005;
  double printed_error_half_unit = 0.005;  ///< percent
  std::vector<MaterialReadings> materials;
};

template <class V>
void describe_values(V& v, ReadingDeck& r) {
  v("radius", r.radius, Unit::metre, above(0), required, "of the sensor");
  v("specific_heat", r.specific_heat.value, Unit::specific_heat, above(0), required, "read");
  v("specific_heat_deviation", r.specific_heat.deviation, Unit::specific_heat, at_least(0), optional,
    "its standard deviation");
  v("conductivity", r.conductivity.value, Unit::conductivity, above(0), required, "read");
  v("conductivity_deviation", r.conductivity.deviation, Unit::conductivity, at_least(0), optional,
    "its standard deviation");
}

template <class V>
void describe(V& v, ReadingDeck& r) {
  v("insulation", r.insulation, Unit::none, any_value, required, "of the sensor");
  describe_values(v, r);
  v("printed_specific_heat_error", r.printed_specific_heat_error, Unit::none, at_least(0), optional,
    "percent, that somebody has printed");
  v("printed_conductivity_error", r.printed_conductivity_error, Unit::none, at_least(0), optional,
    "percent, that somebody has printed");
}

template <class V>
void describe(V& v, HotReadingDeck& r) {
  v("temperature", r.reading.temperature, Unit::kelvin, above(0), required, "of the sample");
  describe_values(v, r.reading);
}

template <class V>
void describe(V& v, MaterialReadings& m) {
  v("name", m.name, Unit::none, any_value, required, "of the sample");
  v("specific_heat", m.specific_heat, Unit::specific_heat, above(0), optional, "of the literature");
  v("conductivity", m.conductivity, Unit::conductivity, above(0), optional, "of the literature");
  v.sections("room", m.room, required, "a reading at room temperature");
  v.sections("hot", m.hot, optional, "a reading with mica at temperature");
}

template <class V>
void describe(V& v, SensorCorrectionDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("specific_heat_half_unit", d.specific_heat_half_unit, Unit::specific_heat, at_least(0), optional,
    "half a unit of the last digit of the specific heats");
  v("conductivity_half_unit", d.conductivity_half_unit, Unit::conductivity, at_least(0), optional,
    "half a unit of the last digit of the conductivities");
  v("printed_error_half_unit", d.printed_error_half_unit, Unit::none, at_least(0), optional,
    "half a unit of the last digit of the printed errors, percent");
  v.sections("material", d.materials, required, "a sample");
}

namespace {

const ReadingDeck* find(const MaterialReadings& m, InsulationType insulation, double radius) {
  for (const ReadingDeck& r : m.room)
    if (r.insulation == insulation && std::abs(r.radius - radius) <= 1e-9 * radius) return &r;
  return nullptr;
}

void check(SensorCorrectionDeck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.materials.size(); ++i) {
    const MaterialReadings& m = deck.materials[i];
    for (std::size_t j = 0; j < m.hot.size(); ++j) {
      const double radius = m.hot[j].reading.radius;
      for (const InsulationType type : {InsulationType::kapton, InsulationType::mica}) {
        if (find(m, type, radius) != nullptr) continue;
        errors.add(fmt::format("material.{}.hot.{}.radius", i, j),
                   fmt::format("\"{}\" has no reading at room temperature with {} of radius {} m; without it there is "
                               "no correction",
                               m.name, enumerators(type).at(static_cast<std::size_t>(type)), radius));
      }
    }
  }
}

/// The error against the literature, beside the one that was printed and those that rounding allows. `half_unit` is
/// half a unit of the last digit of value and reference.
Json error_json(double value, double reference, double half_unit, double printed, double printed_half_unit) {
  if (std::isnan(reference)) return nullptr;
  const double error = error_percent(value, reference);
  const ErrorInterval possible = possible_errors(value, reference, half_unit);
  Json json = {{"percent", error}, {"lowest_possible", possible.low}, {"highest_possible", possible.high}};
  if (std::isnan(printed)) return json;
  json["printed"] = printed;
  json["difference"] = error - printed;
  json["printed_is_possible"] = possible.allows(printed, printed_half_unit);
  return json;
}

Json room_json(const SensorCorrectionDeck& deck, const MaterialReadings& m, const ReadingDeck& r) {
  return {{"insulation", enumerators(r.insulation).at(static_cast<std::size_t>(r.insulation))},
          {"radius_m", r.radius},
          {"specific_heat_J_kgK", r.specific_heat.value},
          {"conductivity_W_mK", r.conductivity.value},
          {"specific_heat_error", error_json(r.specific_heat.value, m.specific_heat, deck.specific_heat_half_unit,
                                             r.printed_specific_heat_error, deck.printed_error_half_unit)},
          {"conductivity_error", error_json(r.conductivity.value, m.conductivity, deck.conductivity_half_unit,
                                            r.printed_conductivity_error, deck.printed_error_half_unit)}};
}

Json correction_json(const Measured& reading, const Measured& mica, const Measured& kapton, double reference) {
  const Measured bias = sensor_bias(mica, kapton);
  const Measured result = corrected(reading, bias);
  Json json = {{"reading", reading.value},
               {"reading_deviation", reading.deviation},
               {"bias", bias.value},
               {"bias_deviation", bias.deviation},
               {"corrected", result.value},
               {"corrected_deviation", result.deviation},
               {"reading_error_percent", nullptr},
               {"corrected_error_percent", nullptr}};
  if (std::isnan(reference)) return json;
  json["reading_error_percent"] = error_percent(reading.value, reference);
  json["corrected_error_percent"] = error_percent(result.value, reference);
  return json;
}

Json hot_json(const MaterialReadings& m, const ReadingDeck& r) {
  const ReadingDeck& mica = *find(m, InsulationType::mica, r.radius);
  const ReadingDeck& kapton = *find(m, InsulationType::kapton, r.radius);
  return {
      {"temperature_K", r.temperature},
      {"radius_m", r.radius},
      {"specific_heat_J_kgK",
       correction_json(r.specific_heat, mica.specific_heat, kapton.specific_heat, m.specific_heat)},
      {"conductivity_W_mK", correction_json(r.conductivity, mica.conductivity, kapton.conductivity, m.conductivity)}};
}

std::string error_text(const Json& e) {
  if (e.is_null()) return "- | - | -";
  if (!e.contains("printed")) return fmt::format("{:.2f} | - | -", e["percent"].get<double>());
  return fmt::format("{:.2f} | {:.2f} | {:+.2f}{}", e["percent"].get<double>(), e["printed"].get<double>(),
                     e["difference"].get<double>(), e["printed_is_possible"].get<bool>() ? "" : " impossible");
}

/// Without deviations of the readings nothing is known of that of the result: then none is shown.
std::string corrected_text(const Json& c, const char* shown) {
  const double deviation = c["corrected_deviation"].get<double>();
  return fmt::format("  {}: {:.5g} read, {:+.5g} bias, {:.5g}{} corrected\n", shown, c["reading"].get<double>(),
                     c["bias"].get<double>(), c["corrected"].get<double>(),
                     deviation > 0.0 ? fmt::format(" +- {:.3g}", deviation) : "");
}

std::string correction_text(const Json& json) {
  std::string text =
      "Errors in percent of the literature; a printed one is impossible when no rounding gives it.\n\n"
      "| sample | sensor | c_p error | printed | difference | k error | printed | difference |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const Json& m : json["materials"]) {
    for (const Json& r : m["room"]) {
      text += fmt::format("| {} | {}, {:.3g} mm | {} | {} |\n", m["name"].get<std::string>(),
                          r["insulation"].get<std::string>(), 1e3 * r["radius_m"].get<double>(),
                          error_text(r["specific_heat_error"]), error_text(r["conductivity_error"]));
    }
  }
  for (const Json& m : json["materials"]) {
    for (const Json& h : m["hot"]) {
      text += fmt::format("\n{} at {:.2f} K, mica {:.3g} mm\n", m["name"].get<std::string>(),
                          h["temperature_K"].get<double>(), 1e3 * h["radius_m"].get<double>());
      text += corrected_text(h["specific_heat_J_kgK"], "specific heat, J/(kg K)") +
              corrected_text(h["conductivity_W_mK"], "conductivity, W/(m K)");
    }
  }
  return text;
}

}  // namespace

std::string sensor_keys() { return key_reference<SensorCorrectionDeck>("Keys of a file for repose thermal sensor."); }

ToolResult sensor_tool(const ToolInput& input) {
  const auto deck = read_tool_deck<SensorCorrectionDeck>(input, check);
  Json materials = Json::array();
  for (const MaterialReadings& m : deck.materials) {
    Json room = Json::array();
    Json hot = Json::array();
    for (const ReadingDeck& r : m.room) room.push_back(room_json(deck, m, r));
    for (const HotReadingDeck& h : m.hot) hot.push_back(hot_json(m, h.reading));
    materials.push_back({{"name", m.name}, {"room", room}, {"hot", hot}});
  }
  ToolResult result;
  result.json = {{"tool", "sensor"}, {"title", deck.title}, {"materials", materials}};
  result.text = correction_text(result.json);
  return result;
}

}  // namespace repose::thermal
