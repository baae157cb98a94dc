#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace repose {

inline constexpr std::size_t glyph_width = 5;
inline constexpr std::size_t glyph_height = 9;  ///< seven above the base line, two below

/// The rows of a letter from the top, '#' where it is inked.
using Glyph = std::array<std::string_view, glyph_height>;

/// Digits, small letters, space, and . , + - : ( ) ~ (a degree sign) ^ (plus or minus); any other character is an empty
/// box.
const Glyph& glyph_of(char letter);

}  // namespace repose
