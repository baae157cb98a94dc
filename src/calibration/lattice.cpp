#include "calibration/lattice.h"

#include <algorithm>
#include <cmath>

namespace repose {

std::vector<Index> BoxLattice::neighbours(Index node) const {
  std::vector<Index> found = {node};
  Index stride = 1;
  for (const Index place : places(node)) {
    const std::size_t known = found.size();
    for (std::size_t i = 0; i < known; ++i) {
      if (place > 0) found.push_back(found[i] - stride);
      if (place + 1 < side) found.push_back(found[i] + stride);
    }
    stride *= side;
  }
  found.erase(found.begin());
  return found;
}

std::vector<Index> BoxLattice::corners(const Vector& at) const {
  std::vector<Index> found = {0};
  Index stride = 1;
  for (Index j = 0; j < dimensions(); ++j, stride *= side) {
    const double cell = std::floor((at[j] - lower[j]) / spacing()[j]);
    const auto place = static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(side - 2)));
    const std::size_t known = found.size();
    for (std::size_t i = 0; i < known; ++i) {
      found[i] += place * stride;
      found.push_back(found[i] + stride);
    }
  }
  return found;
}

}  // namespace repose
