#pragma once

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "contact/jkr.h"

namespace repose {

/// m: how far apart any surfaces that have touched may hold together, with particles from `smallest` to `largest` m in
/// radius; 0 without adhesion. The neighbour lists have to reach so far. DeckError where it is not small.
inline double longest_pull_off_distance(const MaterialTable& materials, double smallest, double largest) {
  constexpr double greatest_share = 0.2;  // of the radius: Hertz's solids are nearly flat where they touch
  double longest = 0.0;
  if (!(largest > 0.0)) return longest;
  for (std::size_t a = 0; a < materials.size(); ++a) {
    for (std::size_t b = 0; b < materials.size(); ++b) {
      const PairParameters& pair = materials.pair(a, b);
      if (!adheres(pair)) continue;
      longest = std::max(longest, jkr_pull_off_distance(pair, largest));
      if (jkr_pull_off_distance(pair, smallest) <= greatest_share * smallest) continue;
      throw DeckError(fmt::format(
          "work_of_adhesion = {:.4g} J/m2 of \"{}\" with \"{}\" is too much for their Young's moduli: a particle of "
          "{:.4g} "
          "m would hold at a distance of more than {} of its radius; JKR's law needs less, or stiffer solids",
          pair.coefficients.work_of_adhesion, materials[a].name, materials[b].name, smallest, greatest_share));
    }
  }
  return 1.000001 * longest;  // more than what rounding could add to a distance
}

}  // namespace repose
