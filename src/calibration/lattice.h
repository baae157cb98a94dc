#pragma once

#include <vector>

#include "calibration/linear_algebra.h"

namespace repose {

/// Nodes at equal distances over a rectangle of parameters, `side` in each direction, the first parameter fastest.
struct BoxLattice {
  Vector lower, upper;
  Index side = 2;

  Index dimensions() const { return lower.size(); }
  Index size() const {
    Index nodes = 1;
    for (Index j = 0; j < dimensions(); ++j) nodes *= side;
    return nodes;
  }
  Vector spacing() const { return (upper - lower) / static_cast<double>(side - 1); }
  /// Places along each direction, 0 to side - 1.
  std::vector<Index> places(Index node) const {
    std::vector<Index> result(static_cast<std::size_t>(dimensions()));
    for (Index& place : result) {
      place = node % side;
      node /= side;
    }
    return result;
  }
  Vector point(Index node) const {
    Vector result(dimensions());
    for (Index j = 0; j < dimensions(); ++j, node /= side) {
      // From both ends, so that the last node is the upper end exactly.
      const double share = static_cast<double>(node % side) / static_cast<double>(side - 1);
      result[j] = (1.0 - share) * lower[j] + share * upper[j];
    }
    return result;
  }
  /// The nodes about one, diagonal ones too: those of the block of 3 in each direction that exist, without itself.
  std::vector<Index> neighbours(Index node) const;
  /// The corners of the cell that a point is in (the nearest cell for a point outside).
  std::vector<Index> corners(const Vector& at) const;
};

inline BoxLattice unit_lattice(Index dimensions, Index side) {
  return {.lower = Vector::Zero(dimensions), .upper = Vector::Ones(dimensions), .side = side};
}

}  // namespace repose
