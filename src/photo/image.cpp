#include "photo/image.h"

#include <algorithm>
#include <cmath>

namespace repose::photo {

double sample(const Image& image, double x, double y) {
  const double right = static_cast<double>(image.width - 1);
  const double bottom = static_cast<double>(image.height - 1);
  x = std::clamp(x, 0.0, right);
  y = std::clamp(y, 0.0, bottom);
  const auto x0 = static_cast<std::size_t>(x);
  const auto y0 = static_cast<std::size_t>(y);
  const std::size_t x1 = std::min(x0 + 1, image.width - 1);
  const std::size_t y1 = std::min(y0 + 1, image.height - 1);
  const double u = x - static_cast<double>(x0);
  const double v = y - static_cast<double>(y0);
  return (1.0 - v) * ((1.0 - u) * image.at(x0, y0) + u * image.at(x1, y0)) +
         v * ((1.0 - u) * image.at(x0, y1) + u * image.at(x1, y1));
}

Image cropped(const Image& image, std::array<std::size_t, 2> low, std::array<std::size_t, 2> high) {
  Image part(high[0] - low[0], high[1] - low[1]);
  for (std::size_t y = 0; y < part.height; ++y) {
    for (std::size_t x = 0; x < part.width; ++x) part.at(x, y) = image.at(low[0] + x, low[1] + y);
  }
  return part;
}

Pixel before_levelling(const Image& image, double angle, Pixel place) {
  const double cx = 0.5 * static_cast<double>(image.width - 1);
  const double cy = 0.5 * static_cast<double>(image.height - 1);
  const double dx = place.x - cx;
  const double dy = place.y - cy;
  return {cx + std::cos(angle) * dx - std::sin(angle) * dy, cy + std::sin(angle) * dx + std::cos(angle) * dy};
}

Image levelled(const Image& image, double angle) {
  if (angle == 0.0) return image;
  Image turned(image.width, image.height);
  for (std::size_t y = 0; y < turned.height; ++y) {
    for (std::size_t x = 0; x < turned.width; ++x) {
      const Pixel from = before_levelling(image, angle, {static_cast<double>(x), static_cast<double>(y)});
      turned.at(x, y) = static_cast<float>(sample(image, from.x, from.y));
    }
  }
  return turned;
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace repose::photo
