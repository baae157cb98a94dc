#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace repose {

/// Whether what acts in these phases, in all when none is named, acts in this one.
inline bool acts_in(const std::vector<std::string>& phases, const std::string& phase) {
  return phases.empty() || std::find(phases.begin(), phases.end(), phase) != phases.end();
}

}  // namespace repose
