#include "photo/grain_peaks.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"

namespace repose::photo {
namespace {

constexpr double smoothed_over = 0.4;  // of a diameter
constexpr double alone_within = 0.35;

/// Means over `width` (odd) pixels along one direction; the edge goes on beyond the picture.
void smooth_rows(Image& image, int width) {
  std::vector<double> sums(image.width + 1);
  const auto last = static_cast<int>(image.width) - 1;
  const int half = width / 2;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) sums[x + 1] = sums[x] + static_cast<double>(image.at(x, y));
    const double first_value = sums[1];
    const double last_value = sums[image.width] - sums[image.width - 1];
    for (int x = 0; x <= last; ++x) {
      const int low = std::max(0, x - half);
      const int high = std::min(last, x + half);
      const double sum = sums[static_cast<std::size_t>(high) + 1] - sums[static_cast<std::size_t>(low)] +
                         first_value * (low - (x - half)) + last_value * ((x + half) - high);
      image.at(static_cast<std::size_t>(x), y) = static_cast<float>(sum / width);
    }
  }
}

Image transposed(const Image& image) {
  Image result(image.height, image.width);
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) result.at(y, x) = image.at(x, y);
  }
  return result;
}

/// Twice over a square of this width.
Image smoothed(const Image& image, int width) {
  Image result = image;
  for (int direction = 0; direction < 2; ++direction) {
    for (int pass = 0; pass < 2; ++pass) smooth_rows(result, width);
    result = transposed(result);
  }
  return result;
}

/// Whether no pixel within `reach` is greater, nor any before it in the order of reading as great.
bool is_peak(const Image& image, std::size_t x, std::size_t y, double reach) {
  const float value = image.at(x, y);
  const auto n = static_cast<int>(reach);
  for (const int step : {1, n}) {  // its neighbours first: they refuse most
    for (int dy = -step; dy <= step; ++dy) {
      const int row = static_cast<int>(y) + dy;
      if (row < 0 || row >= static_cast<int>(image.height)) continue;
      for (int dx = -step; dx <= step; ++dx) {
        const int column = static_cast<int>(x) + dx;
        if (column < 0 || column >= static_cast<int>(image.width) || std::hypot(dx, dy) > std::max(reach, 1.5))
          continue;
        const float other = image.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
        if (other > value || (other == value && (dy < 0 || (dy == 0 && dx < 0)))) return false;
      }
    }
  }
  return true;
}

double diameter_of(const GrainPatches& grains) { return 2.0 * std::sqrt(grains.grain_area / pi); }

}  // namespace

Image smoothed_for(const Subject& subject, const GrainPatches& grains) {
  return smoothed(subject.excess, 2 * static_cast<int>(0.5 * smoothed_over * diameter_of(grains)) + 1);
}

std::vector<GrainPeak> find_peaks(const Image& image, const GrainPatches& grains, Pixel axis, double beyond) {
  const double diameter = diameter_of(grains);
  std::vector<GrainPeak> peaks;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) {
      const std::int32_t patch = grains.patches.at(x, y);
      if (patch < 0) continue;
      const GrainPatches::Kind kind = grains.kind[static_cast<std::size_t>(patch)];
      if (kind != GrainPatches::Kind::clump && kind != GrainPatches::Kind::pile) continue;
      const Pixel at{static_cast<double>(x), static_cast<double>(y)};
      if (std::hypot(at.x - axis.x, at.y - axis.y) < beyond) continue;
      if (is_peak(image, x, y, alone_within * diameter)) peaks.push_back({at, patch});
    }
  }
  return peaks;
}

}  // namespace repose::photo
