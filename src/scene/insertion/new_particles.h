#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace repose {

/// Particles that enter a run, in the order of their numbers.
struct NewParticles {
  std::vector<std::int64_t> id;
  std::vector<Vec3> position;            ///< m
  std::vector<Vec3> velocity;            ///< m/s
  std::vector<Vec3> spin;                ///< rad/s
  std::vector<double> radius;            ///< m
  std::vector<double> temperature = {};  ///< K, NaN where none is known; empty: of none
  std::vector<int> material;  ///< index into the MaterialTable: that of the deck, or of the twin of a held one

  std::size_t size() const { return position.size(); }
};

}  // namespace repose
