#pragma once

#include <cstdint>
#include <vector>

namespace repose {

/// Particles as output sees them, SI units: rows in the order of ids, each rank holding the rows [offset, offset +
/// id.size()) of `total`, the blocks in rank order. A rank may hold none. Vectors are stored x, y, z per particle.
struct ParticleTable {
  std::int64_t total = 0;
  std::int64_t offset = 0;
  std::vector<std::int64_t> id;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> angular_velocity;
  std::vector<double> radius;
  std::vector<double> mass;
  std::vector<double> temperature;     ///< K; of the same length or, when has_temperature is false, empty
  bool has_temperature = false;        ///< the same on all ranks
  std::vector<std::int32_t> material;  ///< index into the list of materials
};

}  // namespace repose
