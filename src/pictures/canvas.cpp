#include "pictures/canvas.h"

#include <algorithm>
#include <cmath>

#include <png.h>

#include "base/error.h"
#include "pictures/bitmap_font.h"

namespace repose {

Canvas::Canvas(std::size_t width, std::size_t height) : width_(width), height_(height), rgb_(3 * width * height, 255) {}

void Canvas::blend(std::size_t x, std::size_t y, double share, Colour colour) {
  std::uint8_t* pixel = &rgb_[3 * (y * width_ + x)];
  const double values[3] = {colour.red, colour.green, colour.blue};
  for (int k = 0; k < 3; ++k) {
    pixel[k] = static_cast<std::uint8_t>(std::lround((1.0 - share) * pixel[k] + share * values[k]));
  }
}

template <class Distance>
void Canvas::fill(Pixel low, Pixel high, Colour colour, Distance distance) {
  const auto first = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::floor(x - 1.0))); };
  const auto end = [](double x, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(std::ceil(x + 2.0), 0.0, static_cast<double>(size)));
  };
  for (std::size_t y = first(low.y); y < end(high.y, height_); ++y) {
    for (std::size_t x = first(low.x); x < end(high.x, width_); ++x) {
      const double share = std::clamp(0.5 - distance(static_cast<double>(x), static_cast<double>(y)), 0.0, 1.0);
      if (share > 0.0) blend(x, y, share, colour);
    }
  }
}

void Canvas::disc(Pixel centre, double radius, Colour colour) {
  fill({centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}, colour,
       [&](double x, double y) { return std::hypot(x - centre.x, y - centre.y) - radius; });
}

void Canvas::circle(Pixel centre, double radius, double thickness, Colour colour) {
  const double outer = radius + 0.5 * thickness;
  fill({centre.x - outer, centre.y - outer}, {centre.x + outer, centre.y + outer}, colour, [&](double x, double y) {
    return std::fabs(std::hypot(x - centre.x, y - centre.y) - radius) - 0.5 * thickness;
  });
}

void Canvas::rectangle(Pixel low, Pixel high, Colour colour) {
  fill(low, high, colour, [&](double x, double y) { return std::max({low.x - x, x - high.x, low.y - y, y - high.y}); });
}

void Canvas::line(Pixel from, Pixel to, double thickness, Colour colour) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double squared_length = std::max(dx * dx + dy * dy, 1e-12);
  const double half = 0.5 * thickness;
  fill({std::min(from.x, to.x) - half, std::min(from.y, to.y) - half},
       {std::max(from.x, to.x) + half, std::max(from.y, to.y) + half}, colour, [&](double x, double y) {
         const double along = std::clamp(((x - from.x) * dx + (y - from.y) * dy) / squared_length, 0.0, 1.0);
         return std::hypot(x - from.x - along * dx, y - from.y - along * dy) - half;
       });
}

void Canvas::dashed_line(Pixel from, Pixel to, double thickness, double dash, Colour colour) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto at = [&](double s) {
    const double share = std::min(s / length, 1.0);
    return Pixel{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  };
  for (double s = 0.0; s < length; s += 2.0 * dash) line(at(s), at(s + dash), thickness, colour);
}

void Canvas::text(Pixel at, std::string_view text, int scale, Colour colour) {
  const auto dot = static_cast<double>(scale);
  for (std::size_t k = 0; k < text.size(); ++k) {
    const Glyph& glyph = glyph_of(text[k]);
    for (std::size_t row = 0; row < glyph.size(); ++row) {
      for (std::size_t column = 0; column < glyph[row].size(); ++column) {
        if (glyph[row][column] != '#') continue;
        const double x = at.x + dot * static_cast<double>(column + (glyph_width + 1) * k);
        const double y = at.y + dot * static_cast<double>(row);
        fill({x, y}, {x + dot - 1.0, y + dot - 1.0}, colour, [&](double px, double py) {
          const bool inside = px >= x - 0.5 && px < x + dot - 0.5 && py >= y - 0.5 && py < y + dot - 0.5;
          return inside ? -1.0 : 1.0;
        });
      }
    }
  }
}

std::string Canvas::png() const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(bytes, '\0');
  if (png_image_write_to_memory(&image, png.data(), &bytes, 0, rgb_.data(), 0, nullptr) == 0) {
    throw FileError(std::string("a picture cannot be encoded: ") + image.message);
  }
  png.resize(bytes);
  return png;
}

}  // namespace repose
