#pragma once

namespace repose {

/// Where one parameter may lie, in its units, within its range.
struct ConfidenceInterval {
  double lower = 0.0;
  double upper = 0.0;
  bool open_below = false;  ///< it ends at the range's lower end only because nothing beyond was looked at
  bool open_above = false;
};

}  // namespace repose
