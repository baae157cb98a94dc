#pragma once

#include <string>

#include "pictures/canvas.h"

/// What the pictures of a pile have in common.
namespace repose {

inline constexpr int large = 3;  ///< scale of a text
inline constexpr int small = 2;

inline constexpr Colour ink{40, 44, 52};
inline constexpr Colour grey{150, 154, 160};

/// Width in pixels of a text at the given scale.
double text_width(const std::string& text, int scale);

/// A bar from `at` to the right, of 1, 2 or 5 times a power of ten of metres and at most a fifth of the picture's
/// width, with its length behind it.
void draw_scale_bar(Canvas& canvas, Pixel at, double pixels_per_metre);

}  // namespace repose
