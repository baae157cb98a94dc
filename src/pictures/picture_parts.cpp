#include "pictures/picture_parts.h"

#include <cmath>

#include <fmt/core.h>

namespace repose {
namespace {

double scale_bar_length(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  return decade * (most >= 5.0 * decade ? 5.0 : most >= 2.0 * decade ? 2.0 : 1.0);
}

}  // namespace

void draw_scale_bar(Canvas& canvas, Pixel at, double pixels_per_metre) {
  const double length = scale_bar_length(0.2 * canvas.width() / pixels_per_metre);
  const double end = at.x + length * pixels_per_metre;
  canvas.line(at, {end, at.y}, 2.0, ink);
  for (const double x : {at.x, end}) canvas.line({x, at.y - 7.0}, {x, at.y + 7.0}, 2.0, ink);
  canvas.text({end + 14.0, at.y + 0.36 * small(canvas)}, fmt::format("{:g} mm", 1e3 * length), small(canvas), ink);
}

}  // namespace repose
