#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pictures/canvas.h"

namespace repose::photo {

inline constexpr double most_pixels = 4e8;  ///< of an image that is read or drawn

/// Grey values from 0 (black) to 1 (white), row by row from the top. The centre of the first pixel is at (0, 0), x is
/// to the right, y downwards.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<float> grey;

  Image() = default;
  Image(std::size_t w, std::size_t h, float value = 0.0F) : width(w), height(h), grey(w * h, value) {}

  float& at(std::size_t x, std::size_t y) { return grey[y * width + x]; }
  float at(std::size_t x, std::size_t y) const { return grey[y * width + x]; }
};

/// Bilinear between the pixels; beyond the edge the value of its pixels.
double sample(const Image& image, double x, double y);

/// The part from `low` (inclusive) to `high` (exclusive), px, both within the image.
Image cropped(const Image& image, std::array<std::size_t, 2> low, std::array<std::size_t, 2> high);

/// Turned about its centre by `angle` (rad; positive: what descends to the right becomes level), in a frame of the
/// same size; what comes from outside has the value of the edge.
Image levelled(const Image& image, double angle);

/// Where `levelled` finds the pixel at this place of its result.
Pixel before_levelling(const Image& image, double angle, Pixel place);

/// Of the values, which it reorders; the upper one of two. Not empty.
float median(std::vector<float>& values);

}  // namespace repose::photo
