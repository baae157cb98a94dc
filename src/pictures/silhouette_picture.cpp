#include "pictures/silhouette_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pictures/picture_parts.h"

namespace repose {
namespace {

constexpr double picture_width = 1200.0;
constexpr double margin = 60.0;
constexpr double header = 160.0;
constexpr double footer = 80.0;
constexpr double tallest_drawing = 1600.0;
constexpr Colour outline_colour{30, 90, 160};
constexpr Colour line_colour{205, 45, 40};

/// From the image plane (u, z in m) to pixels.
struct Frame {
  double left = 0.0;  ///< u of the left edge of the drawing
  double base = 0.0;  ///< z of the plate
  double pixels_per_metre = 1.0;
  double height = 0.0;  ///< of the drawing above the plate, px

  Pixel at(double u, double z) const {
    return {margin + pixels_per_metre * (u - left), header + height - pixels_per_metre * (z - base)};
  }
};

Frame frame_around(std::span<const Disc> discs, double base, double top) {
  Frame frame{.left = discs[0].u, .base = base};
  double right = discs[0].u;
  for (const Disc& disc : discs) {
    frame.left = std::min(frame.left, disc.u - disc.radius);
    right = std::max(right, disc.u + disc.radius);
  }
  frame.pixels_per_metre =
      std::min((picture_width - 2.0 * margin) / (right - frame.left), tallest_drawing / (top - base));
  frame.left = 0.5 * (frame.left + right) - (0.5 * picture_width - margin) / frame.pixels_per_metre;
  frame.height = frame.pixels_per_metre * (top - base);
  return frame;
}

/// In their order, from back to front, the farther the paler, each with a rim so that grains can be told apart.
void draw_grains(Canvas& canvas, const Frame& frame, const std::vector<Disc>& discs) {
  const double farthest = discs.front().nearness;
  const double depth = std::max(discs.back().nearness - farthest, 1e-300);
  for (const Disc& disc : discs) {
    const double shade = 20.0 * (disc.nearness - farthest) / depth;
    const double radius = frame.pixels_per_metre * disc.radius;
    const Pixel centre = frame.at(disc.u, disc.z);
    canvas.disc(centre, radius, {218.0 - shade, 208.0 - shade, 190.0 - shade});
    canvas.disc(centre, radius - std::clamp(0.1 * radius, 0.5, 1.5), {246.0 - shade, 239.0 - shade, 225.0 - shade});
  }
}

void draw_outline(Canvas& canvas, const Frame& frame, const Silhouette& outline) {
  for (const std::vector<double>* flank : {&outline.left, &outline.right}) {
    std::vector<Pixel> points;
    for (std::size_t row = 0; row <= flank->size(); ++row) {
      if (row < flank->size() && !std::isnan((*flank)[row])) {
        points.push_back(frame.at((*flank)[row], outline.row_z(row)));
        continue;
      }
      if (points.size() > 1) canvas.polyline(points, 2.0, outline_colour);
      points.clear();
    }
  }
}

void draw_fit(Canvas& canvas, const Frame& frame, const FlankView& view, const Silhouette& outline) {
  const double top = outline.top;
  for (const double z : {view.z_from, view.z_to}) {
    const double y = frame.at(0.0, z).y;
    canvas.dashed_line({margin, y}, {picture_width - margin, y}, 1.0, 6.0, grey);
  }
  for (const FlankLine* flank : {&view.left, &view.right}) {
    canvas.dashed_line(frame.at(flank->u(outline.base), outline.base), frame.at(flank->u(top), top), 1.5, 8.0,
                       line_colour);
    canvas.line(frame.at(flank->u(view.z_from), view.z_from), frame.at(flank->u(view.z_to), view.z_to), 3.5,
                line_colour);
  }
}

void draw_angles(Canvas& canvas, const AngleOfRepose& result) {
  const FlankView& view = result.views.front();
  const double centre = 0.5 * picture_width;
  const std::string summary =
      std::isnan(result.stderr_deg)
          ? fmt::format("mean {:.1f}° (1 view)", result.mean_deg)
          : fmt::format("mean {:.1f}° ± {:.1f}° ({} views)", result.mean_deg, result.stderr_deg, result.views.size());
  canvas.text({margin, 134.0}, fmt::format("Left {:.1f}°", view.left.angle_deg), large(canvas), line_colour);
  canvas.text({picture_width - margin, 134.0}, fmt::format("Right {:.1f}°", view.right.angle_deg), large(canvas),
              line_colour, Align::right);
  canvas.text({centre, 50.0}, "Angle of repose: " + summary, large(canvas), ink, Align::centre);
  canvas.text({centre, 86.0}, "Outline and lines: view from azimuth 0°, fitted between the dashed heights",
              small(canvas), grey, Align::centre);
}

void draw_plate(Canvas& canvas, const Frame& frame) {
  const double y = frame.at(0.0, frame.base).y;
  // A camera from above sees the near foot of the pile in front of the plate's line; it is not measured.
  const Colour white{255, 255, 255};
  canvas.line({0.0, y + footer}, {picture_width, y + footer}, 2.0 * footer, white);
  canvas.line({0.0, y + 2.0}, {picture_width, y + 2.0}, 4.0, ink);
  draw_scale_bar(canvas, {margin, y + 42.0}, frame.pixels_per_metre);
}

}  // namespace

Picture silhouette_picture(const AngleOfRepose& result, std::span<const Sphere> pile,
                           const AngleOfReposeParameters& parameters) {
  std::vector<Disc> discs = project(pile, view_at(parameters, result.views.front().azimuth));
  std::sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) { return a.nearness < b.nearness; });
  const Silhouette& outline = result.silhouette;
  const Frame frame = frame_around(discs, outline.base, outline.top);
  return make_picture(picture_width, std::ceil(header + frame.height + footer), [&](Canvas& canvas) {
    canvas.many_discs(2 * discs.size(), [&](Canvas& pixels) { draw_grains(pixels, frame, discs); });
    draw_outline(canvas, frame, outline);
    draw_fit(canvas, frame, result.views.front(), outline);
    draw_plate(canvas, frame);
    draw_angles(canvas, result);
  });
}

}  // namespace repose
