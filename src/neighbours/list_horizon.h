#pragma once

#include <array>
#include <cstdint>

#include "scene/particles/particles.h"

namespace repose {

/// How many steps at its present speed the outer skin of each particle is to cover. A list that lasts long is seldom
/// made anew. But where most particles move fast it holds far more pairs than touch, all of which are looked at for
/// each inner list. Chosen at every rebuild by what the lists would cost; no result depends on it.
class ListHorizon {
 public:
  static constexpr std::array<std::int64_t, 3> choices = {320, 160, 80};  ///< steps
  static constexpr std::int64_t inner = 32;                               ///< steps that inner skins are to cover

  /// What a rank knows, in integers, so that all ranks get the same sums: particles, pairs in the outer lists until
  /// now, and for each choice the sum of its reaches, cubed, in radii.
  using Counts = std::array<std::int64_t, 2 + choices.size()>;
  /// Of the owned particles that are not parked; `share` as in SkinRule, `dt` in s.
  static Counts count(const Particles& particles, double share, double dt, std::size_t listed);

  /// Chooses from the sums over all ranks.
  void choose(const Counts& all);
  std::int64_t steps() const { return choices[chosen_]; }

 private:
  std::size_t chosen_ = 0;
  double volume_ = 0.0;            ///< the sum of the present lists; zero before the first
  double pairs_per_volume_ = 1.0;  ///< as dense as the particles were
};

}  // namespace repose
