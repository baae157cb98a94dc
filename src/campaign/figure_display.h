#pragma once

#include <string>

namespace repose {

/// How a figure of summary.json is shown to a person.
struct FigureDisplay {
  std::string name;       ///< with its unit: "discharged mass, g"
  double factor = 1.0;    ///< from SI
  bool is_count = false;  ///< its key names no unit
};

/// By the unit at the end of its key.
FigureDisplay display_of(const std::string& figure);

}  // namespace repose
