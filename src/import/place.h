#pragma once

#include <string>

namespace repose {

/// A line of a script or of a file that it names.
struct Place {
  std::string file = {};
  std::size_t line = 0;  ///< from 1 on
};

/// "file:line"
std::string text(const Place& place);

/// Throws DeckError as "file:line: what".
[[noreturn]] void refuse(const Place& place, const std::string& what);

}  // namespace repose
