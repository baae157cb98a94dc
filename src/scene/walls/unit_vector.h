#pragma once

#include "base/vec3.h"

namespace repose {

/// v / |v|; exact for a multiple of a coordinate axis. std::invalid_argument when v has no direction.
Vec3 unit_vector(const Vec3& v);

}  // namespace repose
