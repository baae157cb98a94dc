#include "measurement/scattering.h"

#include <fmt/core.h>

#include "files/json_text.h"
#include "pictures/top_view_picture.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

constexpr const char* top_view_name = "top_view";  // name of the picture, without its ending

Figures area_json(const AreaCount& area) {
  return {{"from_m", area.from}, {"to_m", json_number(area.to)}, {"count", area.count}, {"error", area.error}};
}

Figures areas_json(const std::vector<AreaCount>& areas) {
  Figures list = Figures::array();
  for (const AreaCount& area : areas) list.push_back(area_json(area));
  return list;
}

Figures scattering_json(const Scattering& s) {
  return {{"base_diameter_m", s.measured_base_radius ? Figures(2.0 * *s.measured_base_radius) : Figures(nullptr)},
          {"area_1", area_json(s.area_1)},
          {"area_2", s.area_2 ? area_json(*s.area_2) : Figures(nullptr)},
          {"area_3", area_json(s.area_3)},
          {"area_1_widened", areas_json(s.area_1_widened)},
          {"area_3_widened", areas_json(s.area_3_widened)},
          {"off_plate", s.off_plate}};
}

void measure(const FinishedState& state, Figures& figures) {
  const ScatteringDeck& deck = state.deck.scattering;
  const std::optional<Scattering> found = scattering(deck, state.grains, state.left.value_or(0));
  if (!found) return;
  if (!state.directory.empty()) {
    write_picture(state.directory + "/" + top_view_name, top_view_picture(deck, *found, state.grains));
  }
  figures["scattering"] = scattering_json(*found);
}

std::string area_text(const Figures& area) {
  const auto to = number_in(area, "to_m");
  const std::string end = to ? fmt::format("to {:.4g} mm", 1e3 * *to) : "to the edge";
  return fmt::format("{} +- {:.0f} (from {:.4g} {})", area["count"].get<std::int64_t>(), area["error"].get<double>(),
                     1e3 * area["from_m"].get<double>(), end);
}

std::string lines(const Figures& figures) {
  const auto found = figures.find("scattering");
  if (found == figures.end() || found->is_null()) return {};
  const Figures& s = *found;
  const auto base = number_in(s, "base_diameter_m");
  std::string text =
      base ? fmt::format("base of the pile {:.4g} mm in diameter\n", 1e3 * *base) : std::string("no base of a pile\n");
  for (const int n : {1, 2, 3}) {
    const Figures& area = s[fmt::format("area_{}", n)];
    if (!area.is_null()) text += fmt::format("grains on area {} {}\n", n, area_text(area));
  }
  for (const int n : {1, 3}) {
    for (const Figures& area : s[fmt::format("area_{}_widened", n)]) {
      text += fmt::format("area {} widened {}\n", n, area_text(area));
    }
  }
  return text + fmt::format("grains off the plate {}\n", s["off_plate"].get<std::int64_t>());
}

}  // namespace

MeasurementKind scattering_measurement() {
  return {.section = "measurement.scattering",
          .is_enabled = [](const Deck& deck) { return deck.scattering.enabled; },
          .figures = {{.key = "scattering", .kind = Figure::Kind::other, .from = Figure::From::grains},
                      {.key = "scattering.area_1.count"},
                      {.key = "scattering.area_2.count"},
                      {.key = "scattering.area_3.count"},
                      {.key = "scattering.off_plate"},
                      {.key = "scattering.base_diameter_m"}},
          .files = picture_files(top_view_name),
          .measure = measure,
          .lines = lines};
}

}  // namespace repose
