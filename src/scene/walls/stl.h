#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/walls/triangle.h"

namespace repose {

/// The triangles of an STL file, in its units and order. `text` is the content of the file, `file` its name in
/// messages. It is binary when its size is 84 + 50 n bytes for the n it states at byte 80, else it must be ASCII; what
/// it says of normals is not used. DeckError in one line for what is neither, a file that ends too early, a corner that
/// is not finite or farther than 1e9 from the origin, or no triangle.
std::vector<Corners> parse_stl(std::string_view text, const std::string& file);

}  // namespace repose
