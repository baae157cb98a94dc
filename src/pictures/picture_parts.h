#pragma once

#include "pictures/canvas.h"

/// What the pictures of a pile have in common.
namespace repose {

/// Sizes of texts, which in a figure of 16 cm are letters of 11 and 7.5 points.
inline double large(const Canvas& canvas) { return canvas.width() / 40.0; }
inline double small(const Canvas& canvas) { return canvas.width() / 60.0; }

inline constexpr Colour ink{40, 44, 52};
inline constexpr Colour grey{150, 154, 160};

/// A bar from `at` to the right, of 1, 2 or 5 times a power of ten of metres and at most a fifth of the picture's
/// width, with its length behind it.
void draw_scale_bar(Canvas& canvas, Pixel at, double pixels_per_metre);

}  // namespace repose
