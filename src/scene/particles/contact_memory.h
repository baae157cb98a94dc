#pragma once

#include <cstdint>
#include <cstring>

#include "base/csr.h"
#include "base/vec3.h"

namespace repose {

/// What a contact remembers between steps. It is forgotten as soon as the surfaces part or, with JKR or a liquid
/// bridge, as soon as what holds them together breaks.
template <class Real>
struct BasicContactHistory {
  Vector3<Real> spring;   ///< m, tangential displacement xi
  Vector3<Real> rolling;  ///< N m, rolling moment M
};
using ContactHistory = BasicContactHistory<double>;

/// Whether nothing is remembered: all bits are zero (a history of negative zeros is one, and is kept as it is).
inline bool is_blank(const ContactHistory& h) {
  constexpr ContactHistory blank = {};
  return std::memcmp(&h, &blank, sizeof(ContactHistory)) == 0;
}

/// What a particle carries of one contact with another when lists are rebuilt or when it changes its rank. The history
/// is oriented from the higher to the lower id, as in the pair loop, whoever carries it.
struct PairMemory {
  std::int64_t partner;
  ContactHistory history;
};

/// The same of a contact with a feature of a wall.
struct WallMemory {
  std::int32_t wall;
  std::int32_t feature;
  ContactHistory history;
};

/// The contact memories of all owned particles, by local index.
struct ContactMemory {
  Csr<PairMemory> pairs;
  Csr<WallMemory> walls;
};

}  // namespace repose
