#include "scene/walls/unit_vector.h"

#include <stdexcept>

namespace repose {

Vec3 unit_vector(const Vec3& v) {
  const double length = norm(v);
  if (!(length > 1e-150 && length < 1e150)) throw std::invalid_argument("a direction must not be of zero length");
  return {v.x / length, v.y / length, v.z / length};
}

}  // namespace repose
