#include "photo/rendered.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "measurement/angle_of_repose.h"

namespace repose::photo {
namespace {

constexpr float background = 0.12F;
constexpr float brightest = 0.9F;
constexpr double ambient = 0.4;         // share of the light that comes from everywhere
constexpr double margin = 0.1;          // of the width of what is shown, on each side
constexpr Vec3 lamp{-0.4, 0.5, 0.768};  // towards it, of unit length: to the right, up, to the camera

std::vector<Sphere> between(std::span<const Sphere> grains, double low, double high) {
  std::vector<Sphere> result;
  for (const Sphere& grain : grains) {
    if (grain.centre.z >= low && grain.centre.z <= high) result.push_back(grain);
  }
  if (result.empty()) throw DeckError("no grains on the plate: there is nothing to draw with --pixels-per-mm");
  return result;
}

/// Half the width and the height that hold the discs, with a margin.
struct Window {
  double half_width = 0.0;
  double low = 0.0, high = 0.0;
};

Image draw(std::span<const Disc> discs, const Window& window, double scale) {
  const double width = std::ceil(2.0 * scale * window.half_width);
  const double height = std::ceil(scale * (window.high - window.low));
  if (width * height > most_pixels) {
    throw DeckError(
        fmt::format("--pixels-per-mm {:.6g} would make a picture of {:.0f} x {:.0f} pixels; choose a smaller number",
                    1e-3 * scale, width, height));
  }
  Image image(static_cast<std::size_t>(width), static_cast<std::size_t>(height), background);
  std::vector<float> depth(image.grey.size(), -std::numeric_limits<float>::infinity());
  for (const Disc& disc : discs) {
    const double x = scale * (disc.u + window.half_width) - 0.5;
    const double y = scale * (window.high - disc.z) - 0.5;
    const double r = scale * disc.radius;
    const auto first = [](double v) { return static_cast<std::size_t>(std::max(0.0, std::ceil(v))); };
    for (std::size_t row = first(y - r); row < image.height && static_cast<double>(row) <= y + r; ++row) {
      for (std::size_t column = first(x - r); column < image.width && static_cast<double>(column) <= x + r; ++column) {
        const double dx = (static_cast<double>(column) - x) / r;
        const double dy = (y - static_cast<double>(row)) / r;
        const double square = 1.0 - dx * dx - dy * dy;
        if (square < 0.0) continue;
        const double near = std::sqrt(square);
        float& deepest = depth[row * image.width + column];
        const auto here = static_cast<float>(scale * disc.nearness + r * near);
        if (here <= deepest) continue;
        deepest = here;
        const double light = ambient + (1.0 - ambient) * std::max(0.0, lamp.x * dx + lamp.y * dy + lamp.z * near);
        image.at(column, row) = background + (brightest - background) * static_cast<float>(light);
      }
    }
  }
  return image;
}

Window window_around(std::span<const Disc> discs) {
  Window window{.half_width = 0.0, .low = discs[0].z, .high = discs[0].z};
  for (const Disc& disc : discs) {
    window.half_width = std::max(window.half_width, std::abs(disc.u) + disc.radius);
    window.low = std::min(window.low, disc.z - disc.radius);
    window.high = std::max(window.high, disc.z + disc.radius);
  }
  const double beside = 2.0 * margin * window.half_width;
  return {window.half_width + beside, window.low - beside, window.high + beside};
}

}  // namespace

Image rendered_pile(std::span<const Sphere> grains, const AngleOfReposeDeck& deck, double pixels_per_mm) {
  const std::vector<Disc> discs =
      project(between(grains, deck.plate_height, deck.max_height), view_at(parameters_of(deck), 0.0));
  return draw(discs, window_around(discs), 1e3 * pixels_per_mm);
}

Image rendered_plate(std::span<const Sphere> grains, const ScatteringDeck& deck, double pixels_per_mm) {
  std::vector<Disc> discs;
  for (const Sphere& grain : between(grains, deck.plate_height, deck.max_height)) {
    const Vec3 p = grain.centre - deck.axis;
    discs.push_back({.u = p.x, .z = p.y, .radius = grain.radius, .nearness = p.z});
  }
  Window window = window_around(discs);
  // The areas reach to the outermost circle at least.
  window.half_width = std::max(window.half_width, 1.05 * deck.area_3_radius);
  window.high = std::max({window.high, -window.low, window.half_width});
  window.low = -window.high;
  return draw(discs, window, 1e3 * pixels_per_mm);
}

}  // namespace repose::photo
