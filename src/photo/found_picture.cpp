#include "photo/found_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/math.h"
#include "pictures/picture_parts.h"

namespace repose::photo {
namespace {

constexpr double picture_width = 1200.0;
constexpr double header = 70.0;
constexpr Colour outline_colour{40, 130, 230};
constexpr Colour line_colour{225, 50, 40};
constexpr Colour circle_colour{255, 45, 30};
constexpr double circle_width = 4.0;
constexpr double mark_width = 2.0;
constexpr Colour base_colour{30, 170, 70};
constexpr Colour clump_colour{255, 120, 0};
constexpr Colour speck_colour{170, 80, 200};

/// From pixels of the photograph to those of the picture.
struct Frame {
  double zoom = 1.0;

  Pixel at(double x, double y) const { return {zoom * (x + 0.5), header + zoom * (y + 0.5)}; }
};

/// The photograph at the picture's size, each of its pixels the mean of those that it covers.
void draw_photograph(Canvas& canvas, const Image& image, const Frame& frame) {
  const auto columns = static_cast<std::size_t>(picture_width);
  const auto rows = std::max<std::size_t>(1, static_cast<std::size_t>(frame.zoom * static_cast<double>(image.height)));
  std::vector<float> sum(columns * rows, 0.0F), count(columns * rows, 0.0F);
  const bool is_coarse = image.width < columns;
  for (std::size_t y = 0; y < (is_coarse ? rows : image.height); ++y) {
    for (std::size_t x = 0; x < (is_coarse ? columns : image.width); ++x) {
      const std::size_t sx = is_coarse ? x * image.width / columns : x;
      const std::size_t sy = is_coarse ? std::min(image.height - 1, y * image.height / rows) : y;
      const std::size_t tx = is_coarse ? x : x * columns / image.width;
      const std::size_t ty = is_coarse ? y : std::min(rows - 1, y * rows / image.height);
      sum[ty * columns + tx] += image.at(sx, sy);
      count[ty * columns + tx] += 1.0F;
    }
  }
  std::vector<unsigned char> grey(columns * rows, 0);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    if (count[i] > 0.0F)
      grey[i] = static_cast<unsigned char>(std::lround(255.0F * std::clamp(sum[i] / count[i], 0.0F, 1.0F)));
  }
  canvas.photograph({0.0, header}, {picture_width, header + static_cast<double>(rows)}, grey, columns);
}

Picture picture_of(const Image& image, const std::string& title,
                   const std::function<void(Canvas&, const Frame&)>& draw) {
  const Frame frame{.zoom = picture_width / static_cast<double>(image.width)};
  const double height = std::ceil(header + frame.zoom * static_cast<double>(image.height));
  return make_picture(picture_width, height, [&](Canvas& canvas) {
    draw_photograph(canvas, image, frame);
    draw(canvas, frame);
    canvas.text({0.5 * picture_width, 46.0}, title, large(canvas), ink, Align::centre);
  });
}

/// From u and z of the pile to the photograph as it was before levelling.
struct PilePlace {
  const Image& image;
  const PileView& view;
  const Frame& frame;

  Pixel at(double u, double z) const {
    const Pixel level{view.axis_column + view.pixels_per_metre * u, view.base_row - view.pixels_per_metre * z};
    const Pixel p = before_levelling(image, view.tilt, level);
    return frame.at(p.x, p.y);
  }
};

void draw_flank(Canvas& canvas, const PilePlace& place, const std::vector<double>& us, const Silhouette& outline) {
  std::vector<Pixel> points;
  for (std::size_t row = 0; row < us.size(); ++row) {
    if (!std::isnan(us[row])) points.push_back(place.at(us[row], outline.row_z(row)));
  }
  canvas.polyline(points, 2.0, outline_colour);
}

}  // namespace

Picture found_pile_picture(const Image& image, const PileView& view) {
  const std::string title =
      fmt::format("Angle of repose {:.2f}° (left {:.2f}°, right {:.2f}°), height {:.2f} mm", view.fit.mean_deg(),
                  view.fit.left.angle_deg, view.fit.right.angle_deg, 1e3 * view.height);
  return picture_of(image, title, [&](Canvas& canvas, const Frame& frame) {
    const PilePlace place{image, view, frame};
    draw_flank(canvas, place, view.outline.left, view.outline);
    draw_flank(canvas, place, view.outline.right, view.outline);
    const double reach = 0.6 * view.base_width;
    canvas.line(place.at(-reach, 0.0), place.at(reach, 0.0), 2.0, base_colour);
    for (const FlankLine* flank : {&view.fit.left, &view.fit.right}) {
      canvas.line(place.at(flank->u(view.fit.z_from), view.fit.z_from),
                  place.at(flank->u(view.fit.z_to), view.fit.z_to), 3.0, line_colour);
    }
  });
}

std::string found_plate_title(const PlateView& view) {
  std::string title = view.measured_base_radius ? fmt::format("Base {:.2f} mm", 2e3 * *view.measured_base_radius)
                                                : std::string("No base");
  for (const CountedArea& area : view.areas) title += fmt::format(", area {}: {:.0f}", area.number, area.count);
  return title;
}

Picture found_plate_picture(const Image& image, const PlateView& view) {
  return picture_of(image, found_plate_title(view), [&](Canvas& canvas, const Frame& frame) {
    canvas.many_discs(view.grains.kind.size() + view.peaks.size(), [&](Canvas& pixels) {
      for (std::size_t i = 0; i < view.grains.kind.size(); ++i) {
        const Patch& p = view.grains.patches.all[i];
        const bool is_single = view.grains.kind[i] == GrainPatches::Kind::single;
        if (!is_single && view.grains.kind[i] != GrainPatches::Kind::speck) continue;
        const double radius = std::max(2.0, frame.zoom * 1.5 * std::sqrt(p.area / pi));
        pixels.circle(frame.at(p.x, p.y), radius, mark_width, is_single ? outline_colour : speck_colour);
      }
      const double radius = std::max(2.0, frame.zoom * std::sqrt(view.grains.grain_area / pi));
      for (const GrainPeak& peak : view.peaks) {
        pixels.circle(frame.at(peak.at.x, peak.at.y), radius, mark_width, clump_colour);
      }
    });
    for (const CountedArea& area : view.areas) {
      canvas.circle(frame.at(view.axis.x, view.axis.y), frame.zoom * view.pixels_per_metre * area.from, circle_width,
                    circle_colour);
    }
  });
}

}  // namespace repose::photo
