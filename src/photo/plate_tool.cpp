#include <fmt/format.h>

#include "base/error.h"
#include "files/json_text.h"
#include "photo/found_picture.h"
#include "photo/looked.h"
#include "photo/photo_tool.h"

namespace repose::photo {
namespace {

Json json_of(const CountedArea& area) {
  return {{"from_m", area.from},   {"to_m", json_number(area.to)}, {"count", area.count},
          {"chance", area.chance}, {"threshold", area.threshold},  {"scale", area.scale}};
}

Json json_of(const std::string& name, const PlateView& view) {
  Json json = {{"file", name},
               {"base_diameter_m", view.measured_base_radius ? Json(2.0 * *view.measured_base_radius) : Json(nullptr)}};
  for (const CountedArea& area : view.areas) json[fmt::format("area_{}", area.number)] = json_of(area);
  json.update(Json{{"single", view.single},
                   {"merged", view.merged},
                   {"doubtful", view.doubtful},
                   {"specks", view.specks},
                   {"seen_share", view.seen_share},
                   {"grain_diameter_m", view.grain_diameter},
                   {"axis_px", {view.axis.x, view.axis.y}},
                   {"pixels_per_mm", 1e-3 * view.pixels_per_metre},
                   {"contrast", view.contrast},
                   {"noise", view.noise},
                   {"grains", view.is_light ? "light" : "dark"}});
  return json;
}

std::string text_of(const std::string& name, const PlateView& view) {
  std::string text = name + ":";
  if (view.measured_base_radius) text += fmt::format(" base {:.4g} mm,", 2e3 * *view.measured_base_radius);
  for (const CountedArea& area : view.areas) text += fmt::format(" area {}: {:.0f},", area.number, area.count);
  text += fmt::format(" beside the pile {:.0f} single and {:.0f} merged grains ({:.0f} doubtful), {:.0f} specks\n",
                      view.single, view.merged, view.doubtful, view.specks);
  if (view.seen_share < 0.98) {
    text +=
        fmt::format("{}: shows {:.0f} % of the plate beyond the outermost circle: area 3 is counted on that alone\n",
                    name, 100.0 * view.seen_share);
  }
  return text;
}

/// The figure of one area over the views, as many as have it.
MeasuredFigure figure_of(int number, const std::vector<PlateView>& views) {
  std::vector<double> counts;
  double systematic = 0.0, chance = 0.0;
  for (const PlateView& view : views) {
    for (const CountedArea& area : view.areas) {
      if (area.number != number) continue;
      counts.push_back(area.count);
      systematic += std::hypot(area.threshold, area.scale);
      chance += area.chance;
    }
  }
  const auto n = static_cast<double>(counts.size());
  return {.figure = fmt::format("scattering.area_{}.count", number),
          .value = counts.empty() ? Measured{} : measured(counts, systematic / n, chance / n),
          .photographs = counts.size(),
          .is_count = true};
}

/// The one diameter of all grains; NaN when they have several.
double diameter_in(const Deck& base) {
  double diameter = unset;
  for (const ParticlesDeck& section : base.particles) {
    if (std::isnan(section.diameter) || (!std::isnan(diameter) && section.diameter != diameter)) return unset;
    diameter = section.diameter;
  }
  return diameter;
}

}  // namespace

PhotoResult measure_plates(const std::vector<PhotoFile>& photographs, const PhotoDeck& given, const Deck& base) {
  PhotoDeck deck = given;
  if (std::isnan(deck.plate.grain_diameter)) deck.plate.grain_diameter = diameter_in(base);
  if (!base.scattering.enabled) {
    throw DeckError(fmt::format("{}: has no [measurement.scattering], which says how grains are counted", deck.base));
  }
  PhotoResult result;
  std::vector<PlateView> views;
  Json list = Json::array();
  for (const PhotoFile& file : photographs) {
    const Looked looked = look_at(file, deck);
    views.push_back(measure_plate(looked.image, looked.deck, base.scattering, file.name));
    PlateView& view = views.back();
    result.pictures.push_back(found_plate_picture(looked.image, view));
    list.push_back(json_of(file.name, view));
    result.text += text_of(file.name, view);
    view.grains = {};  // as large as the photograph
    view.peaks = {};
  }
  result.json = Json::object();
  for (const int number : {1, 2, 3}) {
    const MeasuredFigure figure = figure_of(number, views);
    // An area that some photographs have and others have not is none to compare with.
    if (figure.photographs != views.size()) continue;
    result.figures.push_back(figure);
    result.json[fmt::format("area_{}", number)] = json_of(figure.value);
    result.text += fmt::format("grains on area {} {:.1f} +- {:.1f} ({} photograph{})\n", number, figure.value.mean,
                               figure.value.error, views.size(), views.size() > 1 ? "s" : "");
  }
  result.json["photographs"] = list;
  return result;
}

}  // namespace repose::photo
