#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "base/vec3.h"

namespace repose {

/// Calls found(i, j), j < i, for each pair of spheres whose centres (m) are nearer than the sum of their radii (m), in
/// an order that depends on the arguments alone. The effort is linear in the number of spheres also when their sizes
/// differ widely: one hashed cell grid per power of two of the radius.
void for_each_overlap(std::span<const Vec3> position, std::span<const double> radius,
                      const std::function<void(std::size_t, std::size_t)>& found);

}  // namespace repose
