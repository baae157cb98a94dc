#include <fmt/format.h>

#include "base/error.h"
#include "base/math.h"
#include "files/json_text.h"
#include "photo/found_picture.h"
#include "photo/looked.h"
#include "photo/photo_tool.h"

namespace repose::photo {
namespace {

constexpr double degrees = 180.0 / pi;

Json json_of(const std::string& name, const PileView& view) {
  return {{"file", name},
          {"angle_of_repose_deg", view.fit.mean_deg()},
          {"angle_of_repose_left_deg", view.fit.left.angle_deg},
          {"angle_of_repose_right_deg", view.fit.right.angle_deg},
          {"pile_height_m", view.height},
          {"base_width_m", view.base_width},
          {"threshold_deg", view.threshold_deg},
          {"threshold_height_m", view.threshold_height},
          {"tilt_deg", degrees * view.tilt},
          {"pixels_per_mm", 1e-3 * view.pixels_per_metre},
          {"blur_px", view.blur},
          {"contrast", view.contrast},
          {"noise", view.noise},
          {"grains", view.is_light ? "light" : "dark"},
          {"plate_is_seen", view.plate_is_seen}};
}

/// The mean of a member over the views.
template <class F>
double mean_of(const std::vector<PileView>& views, const F& value) {
  double sum = 0.0;
  for (const PileView& view : views) sum += value(view);
  return sum / static_cast<double>(views.size());
}

}  // namespace

PhotoResult measure_piles(const std::vector<PhotoFile>& photographs, const PhotoDeck& deck, const Deck& base) {
  if (!base.angle_of_repose.enabled) {
    throw DeckError(
        fmt::format("{}: has no [measurement.angle_of_repose], which says how a pile is measured", deck.base));
  }
  const AngleOfReposeParameters parameters = parameters_of(base.angle_of_repose);
  PhotoResult result;
  std::vector<PileView> views;
  std::vector<double> angles, heights;
  Json list = Json::array();
  for (const PhotoFile& file : photographs) {
    const Looked looked = look_at(file, deck);
    const PileView view = measure_pile(looked.image, looked.deck, parameters, file.name);
    result.pictures.push_back(found_pile_picture(looked.image, view));
    list.push_back(json_of(file.name, view));
    angles.push_back(view.fit.mean_deg());
    heights.push_back(view.height);
    result.text += fmt::format(
        "{}: {:.2f} degrees (left {:.2f}, right {:.2f}), height {:.4g} mm, tilt {:.2f} degrees\n", file.name,
        angles.back(), view.fit.left.angle_deg, view.fit.right.angle_deg, 1e3 * view.height, degrees * view.tilt);
    views.push_back(view);
  }
  const double one_sided = 0.5 * std::abs(views.front().fit.left.angle_deg - views.front().fit.right.angle_deg);
  const Measured angle = measured(angles, mean_of(views, [](const PileView& v) { return v.threshold_deg; }), one_sided);
  const double threshold = mean_of(views, [](const PileView& v) { return v.threshold_height; });
  const double scale = deck.scale.deviation * mean_of(views, [](const PileView& v) { return v.height; });
  const Measured height = measured(heights, std::hypot(threshold, scale), 0.0);
  result.figures = {{.figure = "angle_of_repose_deg", .value = angle, .photographs = photographs.size()}};
  result.text += fmt::format("angle of repose {:.2f} +- {:.2f} degrees, height {:.4g} +- {:.2g} mm ({} photograph{})\n",
                             angle.mean, angle.error, 1e3 * height.mean, 1e3 * height.error, views.size(),
                             views.size() > 1 ? "s" : "");
  result.json = {{"angle_of_repose", json_of(angle, "_deg")},
                 {"angle_of_repose_left_deg", mean_of(views, [](const PileView& v) { return v.fit.left.angle_deg; })},
                 {"angle_of_repose_right_deg", mean_of(views, [](const PileView& v) { return v.fit.right.angle_deg; })},
                 {"pile_height", json_of(height, "_m")},
                 {"base_width_m", mean_of(views, [](const PileView& v) { return v.base_width; })},
                 {"photographs", list}};
  return result;
}

}  // namespace repose::photo
