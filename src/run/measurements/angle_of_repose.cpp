#include "measurement/angle_of_repose.h"

#include <cmath>

#include <fmt/core.h>

#include "measurement/pile.h"
#include "pictures/silhouette_picture.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

constexpr const char* silhouette_name = "silhouette";  // name of the picture, without its ending

/// Nothing where there is no pile, and none of a plugged vessel, from which a few grains have fallen.
void measure(const FinishedState& state, Figures& figures) {
  if (figures.contains("plugged") && figures["plugged"] == true) return;
  const AngleOfReposeDeck& deck = state.deck.angle_of_repose;
  const AngleOfReposeParameters parameters = parameters_of(deck);
  const std::vector<Sphere> pile = find_pile(state.grains, deck.plate_height, deck.max_height);
  const std::optional<AngleOfRepose> angle = angle_of_repose(pile, parameters);
  if (!angle) return;
  if (!state.directory.empty()) {
    write_picture(state.directory + "/" + silhouette_name, silhouette_picture(*angle, pile, parameters));
  }
  figures["angle_of_repose_deg"] = angle->mean_deg;
  figures["angle_of_repose_left_deg"] = angle->left_deg;
  figures["angle_of_repose_right_deg"] = angle->right_deg;
  figures["angle_of_repose_stderr_deg"] = angle->stderr_deg;
  figures["pile_height_m"] = angle->pile_height;
}

std::string lines(const Figures& figures) {
  if (!number_in(figures, "angle_of_repose_deg")) return {};
  const auto degrees = [&](const char* key) {
    const auto value = number_in(figures, key);
    return value && std::isfinite(*value) ? fmt::format("{:.4g}", *value) : std::string("-");
  };
  return fmt::format("angle of repose {} +- {} degrees (left {}, right {})\n", degrees("angle_of_repose_deg"),
                     degrees("angle_of_repose_stderr_deg"), degrees("angle_of_repose_left_deg"),
                     degrees("angle_of_repose_right_deg"));
}

}  // namespace

MeasurementKind angle_of_repose_measurement() {
  return {.section = "measurement.angle_of_repose",
          .is_enabled = [](const Deck& deck) { return deck.angle_of_repose.enabled; },
          .figures = {{.key = "angle_of_repose_deg", .from = Figure::From::grains},
                      {.key = "angle_of_repose_left_deg", .from = Figure::From::grains},
                      {.key = "angle_of_repose_right_deg", .from = Figure::From::grains},
                      {.key = "angle_of_repose_stderr_deg", .kind = Figure::Kind::other, .from = Figure::From::grains},
                      {.key = "pile_height_m", .from = Figure::From::grains}},
          .files = picture_files(silhouette_name),
          .measure = measure,
          .lines = lines};
}

}  // namespace repose
