#pragma once

#include <algorithm>
#include <cstdint>

namespace repose {

/// How many steps at its present speed the inner skin of each particle is to cover. An outer list is used up when a
/// particle has less left of its outer skin than another inner skin would grant it. Where steps are long (soft grains),
/// a slow grain that has been hit soon has, and outer lists last for hardly longer than one inner list: inner skins are
/// then made thinner, which costs more inner lists and fewer outer ones. No result depends on it.
class InnerHorizon {
 public:
  static constexpr std::int64_t longest = 32;
  static constexpr std::int64_t shortest = 8;

  /// To be called with the steps after which an outer list was used up, the same on all ranks, and to be followed by a
  /// new outer list.
  void outer_lasted(std::int64_t steps) {
    if (steps < 4 * steps_) {
      steps_ = std::max(shortest, steps_ / 2);
    } else if (steps > 8 * steps_) {
      steps_ = std::min(longest, steps_ * 2);
    }
  }

  std::int64_t steps() const { return steps_; }

 private:
  std::int64_t steps_ = longest;
};

}  // namespace repose
