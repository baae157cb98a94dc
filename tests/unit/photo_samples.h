#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/math.h"
#include "photo/image.h"
#include "photo/photo_deck.h"

/// Pictures whose answer is known.
namespace repose::photo {

/// Light grains before a dark background that becomes brighter to the right, with noise.
struct Backdrop {
  std::size_t width = 600;
  std::size_t height = 400;
  double level = 0.2;
  double slope = 0.1;  ///< of brightness over the width
  double noise = 0.01;
};

/// Pixels on which `share(x, y)`, from 0 to 1, of a grain of brightness `front` lies.
template <class Share>
Image picture(const Backdrop& backdrop, double front, const Share& share) {
  Image image(backdrop.width, backdrop.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) {
      const double u = static_cast<double>(x) / static_cast<double>(image.width) - 0.5;
      const double noise = std::sin(12.9898 * static_cast<double>(x) + 78.233 * static_cast<double>(y)) * 43758.5453;
      const double back =
          backdrop.level + backdrop.slope * u + backdrop.noise * 1.7 * (2.0 * (noise - std::floor(noise)) - 1.0);
      const double s = std::clamp(share(static_cast<double>(x), static_cast<double>(y)), 0.0, 1.0);
      image.at(x, y) = static_cast<float>((1.0 - s) * back + s * front);
    }
  }
  return image;
}

/// How far a place lies within a heap of straight flanks: px from the nearer of its lines, rounded to an edge one pixel
/// wide. Its foot is the line through `foot` that descends to the right by `tilt`.
struct Heap {
  Pixel foot{300.0, 330.0};  ///< middle of its base
  double half_width = 180.0;
  double left_deg = 30.0, right_deg = 30.0;
  double tilt = 0.0;  ///< rad

  double share(double x, double y) const {
    const double dx = x - foot.x;
    const double dy = y - foot.y;
    const double u = std::cos(tilt) * dx + std::sin(tilt) * dy;
    const double z = std::sin(tilt) * dx - std::cos(tilt) * dy;
    const double left = left_deg * pi / 180.0;
    const double right = right_deg * pi / 180.0;
    const double from_left = (u + half_width) * std::sin(left) - z * std::cos(left);
    const double from_right = (half_width - u) * std::sin(right) - z * std::cos(right);
    return std::min({from_left, from_right, z}) + 0.5;
  }
};

/// Discs of one radius, px.
struct Discs {
  std::vector<Pixel> centres;
  double radius = 6.0;

  double share(double x, double y) const {
    double nearest = 1e9;
    for (const Pixel& c : centres) nearest = std::min(nearest, std::hypot(x - c.x, y - c.y));
    return radius - nearest + 0.5;
  }
};

inline PhotoDeck deck_with_scale(double pixels_per_mm) {
  PhotoDeck deck;
  deck.scale.pixels_per_mm = pixels_per_mm;
  return deck;
}

}  // namespace repose::photo
