#include "scene/walls/wall_touch.h"

namespace repose {

namespace {

// Whether `touch` gives way to `other`. An edge in the tangent plane of a face cannot be nearer than the face is, so no
// depth needs to be compared.
bool gives_way(const WallTouch& touch, const WallTouch& other, double tolerance) {
  const Vec3 between = touch.point - other.point;
  if (!touch.on_face && other.on_face) return std::fabs(dot(between, other.normal)) <= tolerance;
  return touch.on_face == other.on_face && other.wall < touch.wall && squared_norm(between) <= tolerance * tolerance;
}

}  // namespace

void resolve_touches(TouchBuffer& buffer, double tolerance) {
  for (int i = 0; i < buffer.size(); ++i) {
    buffer[i].superseded_by = -1;
    for (int j = 0; j < buffer.size() && buffer[i].superseded_by < 0; ++j) {
      if (gives_way(buffer[i], buffer[j], tolerance)) buffer[i].superseded_by = j;
    }
  }
  // A touch that stands for another may itself have given way: point to the one that counts. Each step goes from an
  // edge to a face or to a lower wall, so the chain ends.
  for (WallTouch& touch : buffer.touches()) {
    while (touch.superseded_by >= 0 && buffer[touch.superseded_by].superseded_by >= 0) {
      touch.superseded_by = buffer[touch.superseded_by].superseded_by;
    }
  }
}

}  // namespace repose
