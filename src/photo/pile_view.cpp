#include "photo/pile_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "photo/pile_outline.h"

namespace repose::photo {
namespace {

constexpr double default_threshold = 0.3;  // low, so that a flank in the shade belongs to the pile
constexpr double least_rows = 30.0;
constexpr double second_share = 0.25;    // of the area of the pile, which another one must not have
constexpr double most_roughness = 0.08;  // deviation of the outline from its lines over the pile's height
constexpr double most_threshold_deg = 0.5;
constexpr double steepest_deg = 80.0;

/// How much smaller the camera sees what is at the plate's edge than what is in the plane of the axis.
double size_at_edge(const PhotoDeck& deck, const AngleOfReposeParameters& parameters) {
  return 1.0 / (1.0 + deck.pile.edge_behind_axis / parameters.camera_distance);
}

/// px/m in the plane of the axis.
double scale_of(const PhotoDeck& deck, const AngleOfReposeParameters& parameters, const Level& level,
                const std::string& name) {
  if (const auto given = pixels_per_metre(deck.scale)) return *given;
  if (!level.plate_pixels) {
    throw DeckError(
        fmt::format("{}: scale.plate_width: the plate is not seen before the background; give pixels_per_mm, "
                    "or bar_from and bar_to with bar_length",
                    name));
  }
  return *level.plate_pixels / (deck.scale.plate_width * size_at_edge(deck, parameters));
}

/// By how much the plate's edge that is seen lies above the plate in the plane of the axis, in the picture (m).
double rise_of_edge(const PhotoDeck& deck, const AngleOfReposeParameters& parameters) {
  return (1.0 - size_at_edge(deck, parameters)) * (parameters.camera_height - parameters.plate_height);
}

void check_extent(const Extent& extent, const std::string& name) {
  if (extent.found.first < 0) no_pile(name, "nothing stands out above the base line");
  const Patch& pile = extent.pile();
  const double rows = static_cast<double>(pile.bottom - pile.top + 1);
  if (rows < least_rows) {
    no_pile(name, fmt::format("what stands out above the base line is {:.0f} pixels high, at least {:.0f} are needed",
                              rows, least_rows));
  }
  if (extent.found.second >= 0) {
    const double other = extent.patches.all[static_cast<std::size_t>(extent.found.second)].area;
    if (other >= second_share * pile.area) {
      throw DeckError(
          fmt::format("{}: two piles are found, the smaller with {:.0f} % of the area of the greater; crop_from "
                      "and crop_to choose one, a lower threshold joins what belongs together",
                      name, 100.0 * other / pile.area));
    }
  }
}

/// Of the outline in px between the fitted heights and above: a layer of grains on the plate may go on beyond the
/// picture.
void check_edges(const Silhouette& outline, const FlankView& lines, const Extent& extent, const Level& level,
                 const std::string& name) {
  const double right_edge = static_cast<double>(level.excess.width) - 2.0;
  const char* edge = extent.pile().top == 0 ? "upper" : nullptr;
  for (std::size_t i = 0; i < outline.left.size(); ++i) {
    if (outline.row_z(i) < lines.z_from || std::isnan(outline.left[i])) continue;
    if (outline.left[i] < 1.0) edge = "left";
    if (outline.right[i] > right_edge) edge = "right";
  }
  if (edge == nullptr) return;
  throw DeckError(
      fmt::format("{}: the pile is cut off at the {} edge of what is looked at; take the photograph from farther "
                  "away, or widen crop_from and crop_to",
                  name, edge));
}

/// From px to m, with u from `axis`.
Silhouette in_metres(Silhouette outline, double axis, double scale) {
  outline.row_height /= scale;
  outline.top /= scale;
  for (std::vector<double>* flank : {&outline.left, &outline.right}) {
    for (double& u : *flank) u = (u - axis) / scale;
  }
  return outline;
}

}  // namespace

PileView measure_pile(const Image& image, const PhotoDeck& deck, const AngleOfReposeParameters& parameters,
                      const std::string& name) {
  const Subject subject = find_subject(image, deck, Ground::above, name);
  Level level = find_level(subject, deck, name);
  const double scale = scale_of(deck, parameters, level, name);
  level.base_row += scale * rise_of_edge(deck, parameters);
  const Extent first = extent_of(level, rough_threshold(subject));
  check_extent(first, name);
  const double contrast = contrast_of_pile(level, first);

  const auto outline_at = [&](double share) {
    const double threshold = std::max(4.0 * subject.noise, share * contrast);
    const Extent extent = extent_of(level, threshold);
    check_extent(extent, name);
    return outline_of(level, extent, threshold);
  };
  const auto fit_of = [&](const Silhouette& outline) {
    return fit_flanks(outline, parameters.fit_from, parameters.fit_to);
  };
  const Thresholds thresholds = thresholds_of(deck, default_threshold);
  const Silhouette pixels = outline_at(thresholds.best);
  const FlankView lines = fit_of(pixels);
  check_edges(pixels, lines, first, level, name);
  const Silhouette lower = outline_at(thresholds.lower);
  const Silhouette upper = outline_at(thresholds.upper);

  PileView view;
  view.blur = blur_of(level, pixels, contrast) * std::sin(lines.mean_deg() * pi / 180.0);  // across the flank
  if (view.blur > deck.pile.most_blur * pixels.top) {
    throw DeckError(
        fmt::format("{}: the pile is out of focus: its outline is {:.1f} pixels wide, {:.1f} % of its height, "
                    "above pile.most_blur = {:.3g}; focus on the pile's outline",
                    name, view.blur, 100.0 * view.blur / pixels.top, deck.pile.most_blur));
  }
  if (const double steepest = std::max(lines.left.angle_deg, lines.right.angle_deg); steepest > steepest_deg) {
    no_pile(name, fmt::format("a flank of {:.0f} degrees is none of a heap", steepest));
  }
  if (const double rms = roughness(pixels, lines); rms > most_roughness * pixels.top) {
    no_pile(name,
            fmt::format("the outline of what stands out deviates by {:.0f} % of its height from two straight flanks",
                        100.0 * rms / pixels.top));
  }
  view.axis_column = 0.5 * (lines.left.u_mid + lines.right.u_mid);
  view.outline = in_metres(pixels, view.axis_column, scale);
  view.fit = fit_of(view.outline);
  view.height = view.outline.top;
  view.base_width = view.fit.right.u(0.0) - view.fit.left.u(0.0);
  view.threshold_deg = 0.5 * std::abs(fit_of(upper).mean_deg() - fit_of(lower).mean_deg());
  if (view.threshold_deg > most_threshold_deg) {
    throw DeckError(
        fmt::format("{}: the angle changes by {:.2g} degrees with the threshold's deviation, so that the outline is "
                    "uncertain: light the pile from both sides, or choose another threshold",
                    name, view.threshold_deg));
  }
  view.threshold_height = 0.5 * std::abs(upper.top - lower.top) / scale;
  view.pixels_per_metre = scale;
  view.tilt = level.tilt;
  view.base_row = level.base_row;
  view.contrast = contrast;
  view.noise = subject.noise;
  view.is_light = subject.is_light;
  view.plate_is_seen = level.plate_pixels.has_value();
  return view;
}

}  // namespace repose::photo
