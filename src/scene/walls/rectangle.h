#pragma once

#include "deck/wall_keys.h"
#include "files/read_file.h"
#include "scene/walls/wall_face.h"
#include "scene/walls/wall_touch.h"

namespace repose {

/// A flat rectangle: one touch, on the face, an edge or a corner, whichever is nearest; all are feature 0, so that a
/// contact that rolls over the edge remains the same contact.
struct Rectangle {
  Vec3 corner;
  Vec3 u;  ///< unit, along the first edge
  Vec3 v;  ///< unit, along the second edge
  double length_u = 0.0;
  double length_v = 0.0;
  Vec3 normal;  ///< unit

  static bool is(WallType type) { return type == WallType::rectangle; }
  /// std::invalid_argument when it makes no sense.
  static Rectangle made(const WallDeck& deck, const ReadFile& read_file);
};

void find_touches(const Rectangle& rectangle, const Vec3& centre, double reach, int wall, TouchBuffer& out);
double distance(const Rectangle& rectangle, const Vec3& centre);
Face face_of(const Rectangle& rectangle, int feature);
double margin(const Rectangle& rectangle, int feature, const Vec3& centre);

}  // namespace repose
