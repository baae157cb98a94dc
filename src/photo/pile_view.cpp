#include "photo/pile_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "photo/base_line.h"
#include "photo/patches.h"
#include "photo/subject.h"

namespace repose::photo {
namespace {

constexpr double default_threshold = 0.3;  // low, so that a flank in the shade belongs to the pile
constexpr double least_rows = 30.0;
constexpr double second_share = 0.25;    // of the area of the pile, which another one must not have
constexpr double most_roughness = 0.12;  // deviation of the outline from its lines over the pile's height
constexpr double most_threshold_deg = 0.5;
constexpr double rough_threshold = 0.25;  // share of the contrast, to find where the pile is

/// The levelled picture and where the pile stands in it.
struct Level {
  Image excess;
  double tilt = 0.0;
  double base_row = 0.0;
  std::optional<double> plate_pixels;
  bool plate_is_seen = false;
};

BaseLine given_line(const PhotoDeck& deck) {
  const auto& from = deck.pile.base_from;
  const auto& to = deck.pile.base_to;
  const double slope = (to[1] - from[1]) / (to[0] - from[0]);
  return {.y_at_0 = from[1] - slope * from[0], .slope = slope, .plate_left = {}, .plate_right = {}};
}

[[noreturn]] void no_pile(const std::string& name, const std::string& what) {
  throw DeckError(
      fmt::format("{}: no pile is found: {}; crop_from and crop_to, grains or pile.base_from and base_to say "
                  "where it is",
                  name, what));
}

Level level(const Subject& subject, const PhotoDeck& deck, const std::string& name) {
  BaseLine line;
  if (is_given(deck.pile.base_from)) {
    line = given_line(deck);
  } else {
    const double threshold = std::max(6.0 * subject.noise, rough_threshold * subject.contrast);
    const Patches patches =
        find_patches(subject.excess.width, subject.excess.height,
                     [&](std::size_t x, std::size_t y) { return subject.excess.at(x, y) > threshold; });
    if (patches.all.empty()) no_pile(name, "nothing stands out from the background");
    line = find_base_line(subject.excess, patches, largest(patches.all).first);
  }
  Level result;
  result.tilt = std::atan(line.slope);
  result.excess = levelled(subject.excess, result.tilt);
  const double middle = 0.5 * static_cast<double>(subject.excess.width - 1);
  result.base_row = before_levelling(subject.excess, -result.tilt, {middle, line.y(middle)}).y;
  result.plate_is_seen = line.plate_left.has_value();
  if (line.plate_left) result.plate_pixels = (*line.plate_right - *line.plate_left) / std::cos(result.tilt);
  return result;
}

double pixels_per_metre(const PhotoDeck& deck, const Level& level, const std::string& name) {
  const ScaleDeck& scale = deck.scale;
  if (!std::isnan(scale.pixels_per_mm)) return 1e3 * scale.pixels_per_mm;
  if (is_given(scale.bar_from)) {
    return std::hypot(scale.bar_to[0] - scale.bar_from[0], scale.bar_to[1] - scale.bar_from[1]) / scale.bar_length;
  }
  if (!level.plate_pixels) {
    throw DeckError(
        fmt::format("{}: scale.plate_width: the plate is not seen before the background; give pixels_per_mm, "
                    "or bar_from and bar_to with bar_length",
                    name));
  }
  return *level.plate_pixels / scale.plate_width;
}

/// By how much the plate's edge that is seen lies above the plate in the plane of the axis, in the picture (m).
double rise_of_edge(const PhotoDeck& deck, const AngleOfReposeParameters& parameters) {
  if (std::isinf(parameters.camera_distance)) return 0.0;
  const double scale = 1.0 / (1.0 + deck.pile.edge_behind_axis / parameters.camera_distance);
  return (1.0 - scale) * (parameters.camera_height - parameters.plate_height);
}

/// The pile above the base line at a threshold, with its first and last column in each row of the picture.
struct Extent {
  Patches patches;
  Largest found;

  const Patch& pile() const { return patches.all[static_cast<std::size_t>(found.first)]; }
};

Extent extent_of(const Level& level, double threshold) {
  Extent extent;
  extent.patches = find_patches(level.excess.width, level.excess.height, [&](std::size_t x, std::size_t y) {
    return static_cast<double>(y) <= level.base_row - 0.5 && level.excess.at(x, y) > threshold;
  });
  extent.found = largest(extent.patches.all);
  return extent;
}

/// Between the column `outside` and its neighbour inside at a row between two of the picture.
double crossing(const Image& excess, double outside, double inside, double row, double threshold) {
  const double a = sample(excess, outside, row);
  const double b = sample(excess, inside, row);
  if (a >= threshold || b <= threshold) return 0.5 * (outside + inside);
  return outside + (inside - outside) * (threshold - a) / (b - a);
}

/// The outline in px: rows from the base line upwards, u from the left edge of the picture.
Silhouette outline_of(const Level& level, const Extent& extent, double threshold) {
  const Patch& pile = extent.pile();
  Silhouette outline{.base = 0.0, .row_height = 1.0, .top = 0.0, .left = {}, .right = {}};
  outline.top = level.base_row - static_cast<double>(pile.top) + 0.5;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto rows = static_cast<std::size_t>(outline.top);
  outline.left.assign(rows, nan);
  outline.right.assign(rows, nan);
  for (std::size_t i = 0; i < rows; ++i) {
    const double row = level.base_row - outline.row_z(i);
    const auto y = static_cast<std::size_t>(std::max(0.0, std::round(row)));
    for (std::size_t x = pile.left; x <= pile.right; ++x) {
      if (extent.patches.at(x, y) != extent.found.first) continue;
      const auto column = static_cast<double>(x);
      if (std::isnan(outline.left[i])) outline.left[i] = crossing(level.excess, column - 1.0, column, row, threshold);
      outline.right[i] = column;
    }
    if (!std::isnan(outline.right[i])) {
      outline.right[i] = crossing(level.excess, outline.right[i] + 1.0, outline.right[i], row, threshold);
    }
  }
  return outline;
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

/// The width of the edge along the rows from 25 to 75 % of the contrast, as that from 10 to 90 % of an edge that is
/// blurred as by a lens out of focus (normally distributed: 1.9 times as wide). That which a fifth of the rows have at
/// most: grains that fade into their shadow have wide edges in focus, too.
double blur_of(const Level& level, const Silhouette& outline, double contrast) {
  constexpr double wider = 1.9;
  std::vector<float> widths;
  for (std::size_t i = 0; i < outline.left.size(); ++i) {
    const double row = level.base_row - outline.row_z(i);
    for (const double side : {-1.0, 1.0}) {
      const double edge = side < 0.0 ? outline.left[i] : outline.right[i];
      if (std::isnan(edge)) continue;
      const double reach = 0.25 * (outline.right[i] - outline.left[i]);
      const auto distance_to = [&](double share, double way) {
        double d = 0.0;
        while (std::abs(d) < reach + 1.0) {
          const double value = sample(level.excess, edge + side * d, row);
          if (way > 0.0 ? value < share * contrast : value > share * contrast) break;
          d += 0.5 * way;
        }
        return std::abs(d);
      };
      widths.push_back(static_cast<float>(distance_to(0.25, 1.0) + distance_to(0.75, -1.0)));
    }
  }
  if (widths.empty()) return 0.0;
  const auto fifth = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 5);
  std::nth_element(widths.begin(), fifth, widths.end());
  return wider * static_cast<double>(*fifth);
}

/// Root mean square of the outline's distance from its lines between the fitted heights, in its own unit.
double roughness(const Silhouette& outline, const FlankView& fit) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < outline.left.size(); ++i) {
    const double z = outline.row_z(i);
    if (z < fit.z_from || z > fit.z_to || std::isnan(outline.left[i])) continue;
    for (const double off : {outline.left[i] - fit.left.u(z), outline.right[i] - fit.right.u(z)}) {
      sum += off * off;
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
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

double contrast_of_pile(const Level& level, const Extent& extent) {
  const Patch& pile = extent.pile();
  std::vector<float> values;
  for (std::size_t y = pile.top; y <= pile.bottom; ++y) {
    for (std::size_t x = pile.left; x <= pile.right; ++x) {
      if (extent.patches.at(x, y) == extent.found.first) values.push_back(level.excess.at(x, y));
    }
  }
  return static_cast<double>(median(values));
}

}  // namespace

PileView measure_pile(const Image& image, const PhotoDeck& deck, const AngleOfReposeParameters& parameters,
                      const std::string& name) {
  const Subject subject = find_subject(image, deck, Ground::above, name);
  Level level = photo::level(subject, deck, name);
  const double scale = pixels_per_metre(deck, level, name);
  level.base_row += scale * rise_of_edge(deck, parameters);
  const double rough = std::max(6.0 * subject.noise, rough_threshold * subject.contrast);
  const Extent first = extent_of(level, rough);
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
  const double threshold = std::isnan(deck.threshold) ? default_threshold : deck.threshold;
  const Silhouette pixels = outline_at(threshold);
  const FlankView lines = fit_of(pixels);
  check_edges(pixels, lines, first, level, name);
  const Silhouette lower = outline_at(std::max(0.05, threshold - deck.threshold_deviation));
  const Silhouette upper = outline_at(std::min(0.95, threshold + deck.threshold_deviation));

  PileView view;
  view.blur = blur_of(level, pixels, contrast) * std::sin(lines.mean_deg() * pi / 180.0);  // across the flank
  if (view.blur > deck.pile.most_blur * pixels.top) {
    throw DeckError(
        fmt::format("{}: the pile is out of focus: its outline is {:.1f} pixels wide, {:.1f} % of its height, "
                    "above pile.most_blur = {:.3g}; focus on the pile's outline",
                    name, view.blur, 100.0 * view.blur / pixels.top, deck.pile.most_blur));
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
  view.plate_is_seen = level.plate_is_seen;
  return view;
}

}  // namespace repose::photo
