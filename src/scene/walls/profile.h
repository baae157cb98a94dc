#pragma once

#include <array>
#include <vector>

#include "deck/wall_keys.h"
#include "files/read_file.h"
#include "scene/walls/wall_face.h"
#include "scene/walls/wall_touch.h"

namespace repose {

/// A polyline (r, z) turned around an axis. Works in the meridian half-plane of the sphere's centre. A segment is
/// touched when the centre projects onto it, a vertex when the centre projects onto none of its segments: a concave
/// corner gives two touches, a convex one gives one, and so does the seam of two segments in line. Vertex k of the
/// chain is feature 2k, segment k is 2k+1.
struct Profile {
  struct Segment {
    double dr = 0.0;  ///< unit direction (dr, dz)
    double dz = 0.0;
    bool in_line = false;  ///< with the segment before it: the vertex between them is no corner
  };

  Vec3 origin;          ///< where z = 0
  Vec3 axis;            ///< unit
  Vec3 aside;           ///< unit, perpendicular to the axis: the meridian of a centre on the axis
  bool closed = false;  ///< the last segment ends at the first vertex
  std::vector<std::array<double, 2>> vertices;  ///< (r, z); a closed chain does not repeat its first vertex
  std::vector<Segment> segments;                ///< segment k runs from vertex k to the next

  static bool is(WallType type) { return type == WallType::profile || type == WallType::disc; }
  /// std::invalid_argument when it makes no sense.
  static Profile made(const WallDeck& deck, const ReadFile& read_file);
};

void find_touches(const Profile& profile, const Vec3& centre, double reach, int wall, TouchBuffer& out);
double distance(const Profile& profile, const Vec3& centre);
Face face_of(const Profile& profile, int feature);
double margin(const Profile& profile, int feature, const Vec3& centre);
bool keeps(const Profile& profile, const MotionDeck& motion);
bool adjacent_features(const Profile& profile, int a, int b);

/// Profile from points (r, z) in m, r >= 0; the axis need not be of unit length. A last point equal to the first closes
/// the chain. std::invalid_argument, saying what is wrong, for fewer than two points, r < 0, a segment without length
/// or along the axis, or an axis without direction.
Profile make_profile(const std::vector<std::array<double, 2>>& points, const Vec3& origin, const Vec3& axis);

}  // namespace repose
