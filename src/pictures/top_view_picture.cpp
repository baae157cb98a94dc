#include "pictures/top_view_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pictures/picture_parts.h"

namespace repose {
namespace {

constexpr double picture_width = 1600.0;
constexpr double tallest_drawing = 2400.0;
constexpr double margin = 50.0;
constexpr double header = 150.0;
constexpr double footer = 85.0;

constexpr Colour plate_colour{232, 234, 237};
constexpr Colour pile_colour{88, 84, 80};
constexpr Colour area_1_colour{30, 90, 160};
constexpr Colour area_2_colour{120, 116, 110};
constexpr Colour area_3_colour{205, 45, 40};

/// From the plate (x, y in m) to pixels.
struct Frame {
  double left = 0.0;  ///< px, of the plate
  double x_min = 0.0;
  double y_max = 0.0;
  double pixels_per_metre = 1.0;

  Pixel at(double x, double y) const {
    return {left + pixels_per_metre * (x - x_min), header + pixels_per_metre * (y_max - y)};
  }
};

Frame frame_around(const ScatteringDeck& deck) {
  const double width = deck.plate_max.x - deck.plate_min.x;
  const double depth = deck.plate_max.y - deck.plate_min.y;
  const double scale = std::min((picture_width - 2.0 * margin) / width, tallest_drawing / depth);
  return {.left = 0.5 * (picture_width - scale * width),
          .x_min = deck.plate_min.x,
          .y_max = deck.plate_max.y,
          .pixels_per_metre = scale};
}

Colour colour_at(const ScatteringDeck& deck, const Scattering& result, double distance) {
  if (distance < result.base_radius) return pile_colour;
  if (distance >= deck.area_3_radius) return area_3_colour;
  return distance < *result.area_1.to ? area_1_colour : area_2_colour;
}

Colour lighter(const Colour& c, double share) {
  return {c.red + share * (255.0 - c.red), c.green + share * (255.0 - c.green), c.blue + share * (255.0 - c.blue)};
}

Colour darker(const Colour& c, double share) {
  return {(1.0 - share) * c.red, (1.0 - share) * c.green, (1.0 - share) * c.blue};
}

/// From the plate upwards, the higher the lighter, each with a rim so that grains can be told apart.
void draw_grains(Canvas& canvas, const Frame& frame, const ScatteringDeck& deck, const Scattering& result,
                 std::span<const Sphere> grains) {
  std::vector<Sphere> shown;
  std::copy_if(grains.begin(), grains.end(), std::back_inserter(shown), [&](const Sphere& grain) {
    const double z = grain.centre.z;
    return z >= deck.plate_height && z <= deck.max_height;
  });
  if (shown.empty()) return;
  std::sort(shown.begin(), shown.end(), [](const Sphere& a, const Sphere& b) { return a.centre.z < b.centre.z; });
  const std::size_t nearly_highest = shown.size() - 1 - shown.size() / 100;  // a grain that still falls is no summit
  const double top = std::max(shown[nearly_highest].centre.z - deck.plate_height, 1e-300);
  for (const Sphere& grain : shown) {
    const double distance = std::hypot(grain.centre.x - deck.axis.x, grain.centre.y - deck.axis.y);
    const double height = std::min((grain.centre.z - deck.plate_height) / top, 1.0);
    const Colour colour = lighter(colour_at(deck, result, distance), 0.65 * height);
    const double radius = frame.pixels_per_metre * grain.radius;
    const Pixel centre = frame.at(grain.centre.x, grain.centre.y);
    canvas.disc(centre, radius, darker(colour, 0.4));
    canvas.disc(centre, radius - std::clamp(0.15 * radius, 0.5, 1.5), colour);
  }
}

void draw_circles(Canvas& canvas, const Frame& frame, const ScatteringDeck& deck, const Scattering& result) {
  const Pixel axis = frame.at(deck.axis.x, deck.axis.y);
  const auto circle = [&](double radius, double thickness, const Colour& colour) {
    canvas.circle(axis, frame.pixels_per_metre * radius, thickness, colour);
  };
  circle(result.base_radius, 3.0, ink);
  circle(*result.area_1.to, 2.5, area_1_colour);
  circle(deck.area_3_radius, 2.5, area_3_colour);
  for (const AreaCount& area : result.area_1_widened) circle(*area.to, 1.0, lighter(area_1_colour, 0.4));
  for (const AreaCount& area : result.area_3_widened) circle(area.from, 1.0, lighter(area_3_colour, 0.4));
}

std::string count_text(const char* name, const AreaCount& area) {
  return fmt::format("{}: {} ± {:.0f}", name, area.count, area.error);
}

void draw_counts(Canvas& canvas, const Scattering& result) {
  const double centre = 0.5 * picture_width;
  const double right = picture_width - margin;
  canvas.text({margin, 52.0}, base_text(result), large(canvas), ink);
  canvas.text({right, 52.0}, fmt::format("Off the plate: {}", result.off_plate), large(canvas), ink, Align::right);
  canvas.text({margin, 108.0}, count_text("Area 1", result.area_1), large(canvas), area_1_colour);
  canvas.text({centre, 108.0}, result.area_2 ? count_text("Area 2", *result.area_2) : "No area 2", large(canvas),
              area_2_colour, Align::centre);
  canvas.text({right, 108.0}, count_text("Area 3", result.area_3), large(canvas), area_3_colour, Align::right);
}

/// What lies or stands out beyond the plate's edge is covered, where the texts come.
void cover_surroundings(Canvas& canvas, const Pixel& low, const Pixel& high) {
  const Colour white{255, 255, 255};
  canvas.rectangle({0.0, 0.0}, {picture_width, header - 35.0}, white);
  canvas.rectangle({0.0, high.y + 25.0}, {picture_width, canvas.height()}, white);
  const Pixel corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  for (int k = 0; k < 4; ++k) canvas.line(corners[k], corners[(k + 1) % 4], 3.0, ink);
}

}  // namespace

std::string base_text(const Scattering& result) {
  if (!result.measured_base_radius) return "No base";
  return fmt::format("Base {:.1f} mm", 2e3 * *result.measured_base_radius);
}

Picture top_view_picture(const ScatteringDeck& deck, const Scattering& result, std::span<const Sphere> grains) {
  const Frame frame = frame_around(deck);
  const Pixel low = frame.at(deck.plate_min.x, deck.plate_max.y);
  const Pixel high = frame.at(deck.plate_max.x, deck.plate_min.y);
  return make_picture(picture_width, std::ceil(high.y + footer), [&](Canvas& canvas) {
    canvas.rectangle(low, high, plate_colour);
    canvas.many_discs(2 * grains.size(), [&](Canvas& pixels) { draw_grains(pixels, frame, deck, result, grains); });
    draw_circles(canvas, frame, deck, result);
    cover_surroundings(canvas, low, high);
    draw_counts(canvas, result);
    draw_scale_bar(canvas, {margin, high.y + 48.0}, frame.pixels_per_metre);
  });
}

}  // namespace repose
