#pragma once

#include "deck/wall_keys.h"
#include "files/read_file.h"
#include "scene/walls/wall_face.h"
#include "scene/walls/wall_touch.h"

namespace repose {

/// An infinite plane; feature 0.
struct Plane {
  Vec3 point;
  Vec3 normal;  ///< unit

  static bool is(WallType type) { return type == WallType::plane; }
  /// std::invalid_argument when it makes no sense.
  static Plane made(const WallDeck& deck, const ReadFile& read_file);
};

void find_touches(const Plane& plane, const Vec3& centre, double reach, int wall, TouchBuffer& out);
double distance(const Plane& plane, const Vec3& centre);
Face face_of(const Plane& plane, int feature);
double margin(const Plane& plane, int feature, const Vec3& centre);
/// Whether the motion brings every point of it to another of its points.
bool keeps(const Plane& plane, const MotionDeck& motion);

/// What a flat face does with a centre that projects onto it.
void add_face(const FlatFace& face, const Vec3& centre, double reach, int wall, TouchBuffer& out);

}  // namespace repose
