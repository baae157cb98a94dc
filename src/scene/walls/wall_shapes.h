#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"
#include "scene/walls/wall_face.h"
#include "scene/walls/wall_touch.h"

/// The shapes of walls: surfaces without thickness, felt from both sides. Each shape has find_touches, which appends
/// the features nearer to `centre` than `reach` (in m, strictly), and distance, the distance from `centre` to the
/// surface. Only plain arithmetic and square roots, so that the results are the same bits everywhere.
namespace repose {

/// An infinite plane; feature 0.
struct Plane {
  Vec3 point;
  Vec3 normal;  ///< unit
};

/// A flat rectangle: one touch, on the face, an edge or a corner, whichever is nearest; all are feature 0, so that a
/// contact that rolls over the edge remains the same contact.
struct Rectangle {
  Vec3 corner;
  Vec3 u;  ///< unit, along the first edge
  Vec3 v;  ///< unit, along the second edge
  double length_u = 0.0;
  double length_v = 0.0;
  Vec3 normal;  ///< unit
};

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
};

void find_touches(const Plane& plane, const Vec3& centre, double reach, int wall, TouchBuffer& out);
void find_touches(const Rectangle& rectangle, const Vec3& centre, double reach, int wall, TouchBuffer& out);
void find_touches(const Profile& profile, const Vec3& centre, double reach, int wall, TouchBuffer& out);

double distance(const Plane& plane, const Vec3& centre);
double distance(const Rectangle& rectangle, const Vec3& centre);
double distance(const Profile& profile, const Vec3& centre);

/// The face that feature `feature` is.
Face face_of(const Plane& plane, int feature);
Face face_of(const Rectangle& rectangle, int feature);
Face face_of(const Profile& profile, int feature);

/// How far in m `centre`, which projects onto the face, may move in any direction and still do so.
double margin(const Plane& plane, int feature, const Vec3& centre);
double margin(const Rectangle& rectangle, int feature, const Vec3& centre);
double margin(const Profile& profile, int feature, const Vec3& centre);

/// Profile from points (r, z) in m, r >= 0; the axis need not be of unit length. A last point equal to the first closes
/// the chain. std::invalid_argument, saying what is wrong, for fewer than two points, r < 0, a segment without length
/// or along the axis, or an axis without direction.
Profile make_profile(const std::vector<std::array<double, 2>>& points, const Vec3& origin, const Vec3& axis);

/// v / |v|; exact for a multiple of a coordinate axis. std::invalid_argument when v has no direction.
Vec3 unit_vector(const Vec3& v);

}  // namespace repose
