#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "photo/image.h"

namespace repose::photo {

/// A connected part of a picture. Lengths in px, from the centre of the first pixel.
struct Patch {
  double area = 0.0;  ///< px^2
  double x = 0.0, y = 0.0;
  std::size_t left = 0, right = 0, top = 0, bottom = 0;  ///< inclusive
  /// Area squared over 2 pi times the polar second moment: 1 for a disc, 0.67 for two that touch, 0.82 for three.
  double roundness = 0.0;
};

struct Patches {
  std::size_t width = 0;
  std::vector<std::int32_t> label;  ///< of each pixel, row by row; -1: of none
  std::vector<Patch> all;           ///< in the order of their first pixels

  std::int32_t at(std::size_t x, std::size_t y) const { return label[y * width + x]; }

  /// Calls visit(x, y) for the pixels of a patch, row by row.
  template <class Visit>
  void for_each_pixel(std::int32_t which, Visit&& visit) const {
    const Patch& patch = all[static_cast<std::size_t>(which)];
    for (std::size_t y = patch.top; y <= patch.bottom; ++y) {
      for (std::size_t x = patch.left; x <= patch.right; ++x) {
        if (at(x, y) == which) visit(x, y);
      }
    }
  }
};

/// The parts of pixels that `belongs`, connected over edges and corners.
Patches find_patches(std::size_t width, std::size_t height,
                     const std::function<bool(std::size_t x, std::size_t y)>& belongs);

/// The number of the patch with the greatest area, and of the next; -1 where there is none.
struct Largest {
  std::int32_t first = -1;
  std::int32_t second = -1;
};
Largest largest(const std::vector<Patch>& patches);

}  // namespace repose::photo
