#include "run/summary_figures.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "deck/nearest.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

/// A section of a deck and the figures that runs with it have.
struct Measured {
  const char* section;
  bool enabled;
  std::vector<std::string> figures;
};

std::vector<Measured> measured_by(const Deck& deck) {
  return {
      {"measurement.discharge",
       deck.discharge.enabled,
       {"discharged_mass_kg", "retained_mass_kg", "discharge_time_s", "discharge_rate_kg_s"}},
      {"measurement.angle_of_repose",
       deck.angle_of_repose.enabled,
       {"angle_of_repose_deg", "angle_of_repose_left_deg", "angle_of_repose_right_deg", "pile_height_m"}},
      {"measurement.scattering",
       deck.scattering.enabled,
       {"scattering.area_1.count", "scattering.area_2.count", "scattering.area_3.count", "scattering.off_plate",
        "scattering.base_diameter_m"}},
      {"measurement.tilt_onset", deck.tilt_onset.enabled, {"tilt_onset_deg", "tilt_onset_excess_deg"}},
      {"measurement.surface_angle", deck.surface_angle.enabled, {"surface_angle_deg", "surface_angle_deviation_deg"}}};
}

}  // namespace

std::optional<double> figure_in(const Json& summary, const std::string& figure) {
  Json::json_pointer pointer;
  for (std::size_t at = 0; at <= figure.size();) {
    const std::size_t dot = std::min(figure.find('.', at), figure.size());
    pointer /= figure.substr(at, dot - at);
    at = dot + 1;
    if (!summary.contains(pointer)) throw DeckError(fmt::format("figure \"{}\": summary.json has no such key", figure));
    if (summary[pointer].is_null()) return {};
  }
  if (!summary[pointer].is_number()) throw DeckError(fmt::format("figure \"{}\": is not one number", figure));
  return summary[pointer].get<double>();
}

std::optional<double> error_in(const Json& summary, const std::string& figure) {
  std::string name = figure;
  if (name.ends_with(".count")) {
    name.replace(name.size() - 5, 5, "error");
  } else if (name.ends_with("_deg")) {
    name.insert(name.size() - 4, "_stderr");
  } else {
    return {};
  }
  try {
    return figure_in(summary, name);
  } catch (const DeckError&) {
    return {};
  }
}

void require_figure(const Deck& deck, const std::string& figure) {
  std::vector<std::string> all;
  for (const Measured& measured : measured_by(deck)) {
    all.insert(all.end(), measured.figures.begin(), measured.figures.end());
    if (std::find(measured.figures.begin(), measured.figures.end(), figure) == measured.figures.end()) continue;
    if (measured.enabled) return;
    throw DeckError(fmt::format("\"{}\" is measured by [{}], which the base deck lacks", figure, measured.section));
  }
  throw DeckError(
      fmt::format("\"{}\" is no figure that runs have; did you mean \"{}\"?", figure, nearest(figure, all)));
}

}  // namespace repose
