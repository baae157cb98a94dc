#pragma once

#include <cstdint>

namespace repose {

/// What went wrong in a loop over contacts, as counts; the caller looks for the culprit.
struct ContactAlarms {
  std::int64_t too_deep = 0;      ///< contacts whose overlap exceeds the bound
  std::int64_t out_of_range = 0;  ///< blocks with a force (or NaN) that the fixed-point sum cannot hold
  bool any() const { return too_deep + out_of_range > 0; }
  ContactAlarms& operator+=(const ContactAlarms& more) {
    too_deep += more.too_deep;
    out_of_range += more.out_of_range;
    return *this;
  }
};

}  // namespace repose
