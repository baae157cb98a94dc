#pragma once

#include "measurement/sphere.h"

namespace repose {

/// Volume in m^3 of the part of a sphere inside the box from `min` to `max` (m), which is not empty: exact but for
/// rounding, which is below 1e-14 of the sphere (docs/theory.md, "Bulk density").
double volume_in_box(const Sphere& sphere, const Vec3& min, const Vec3& max);

}  // namespace repose
