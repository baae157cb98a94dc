#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"

/// Vectors in arrays of numbers as files have them: x, y, z one after the other.
namespace repose {

/// The vector that begins at column `first` of a row.
inline Vec3 vector_at(std::span<const double> values, std::size_t row, std::size_t columns = 3, std::size_t first = 0) {
  const double* v = values.data() + row * columns + first;
  return {v[0], v[1], v[2]};
}

inline void append_vector(std::vector<double>& values, const Vec3& v) { values.insert(values.end(), {v.x, v.y, v.z}); }

}  // namespace repose
