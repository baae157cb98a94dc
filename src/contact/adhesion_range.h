#pragma once

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "contact/general_law.h"

namespace repose {

/// m: how far apart any surfaces that have touched may hold together, with particles from `smallest` to `largest` m in
/// radius; 0 without adhesion. The neighbour lists have to reach so far. DeckError where it is not small.
inline double longest_holding_distance(const MaterialTable& materials, double smallest, double largest) {
  constexpr double greatest_share = 0.5;  // of the radius
  double longest = 0.0;
  if (!(largest > 0.0)) return longest;
  for (std::size_t a = 0; a < materials.size(); ++a) {
    for (std::size_t b = 0; b < materials.size(); ++b) {
      const PairParameters& pair = materials.pair(a, b);
      if (!adheres(pair)) continue;
      longest = std::max(longest, GeneralLaw::holding_distance(pair, largest));
      const double share = GeneralLaw::holding_distance(pair, smallest) / smallest;
      if (share <= greatest_share) continue;
      throw DeckError(fmt::format(
          "\"{}\" and \"{}\" would hold together at {:.3g} of the radius {:.3g} m, more than {}; give them {}",
          materials[a].name, materials[b].name, share, smallest, greatest_share,
          pair.options.normal_law == NormalLaw::jkr ? "less work_of_adhesion or stiffer solids"
                                                    : "a smaller bridge_volume"));
    }
  }
  return 1.000001 * longest;  // more than what rounding could add to a distance
}

}  // namespace repose
