#include "scene/walls/profile.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "scene/walls/unit_vector.h"

namespace repose {

namespace {

// Segments that turn by less than this angle are in line. At such a seam the distance is wrong by less than the
// sphere's radius times the square of the angle.
constexpr double in_line_angle = 1e-6;

using Meridian = BasicMeridian<double>;

Meridian meridian(const Profile& profile, const Vec3& centre) {
  return repose::meridian(profile.origin, profile.axis, profile.aside, centre);
}

// A feature of the profile that is the nearest one of its neighbourhood, in the meridian half-plane.
struct NearFeature {
  int feature;
  bool on_face;
  double distance;
  double normal_r;  // unit, towards the centre
  double normal_z;
};

NearFeature near_face(int feature, double r, double z, const Profile::Segment& segment) {
  const double signed_distance = segment.dr * z - segment.dz * r;
  const double side = signed_distance < 0.0 ? -1.0 : 1.0;
  return {feature, true, std::fabs(signed_distance), -side * segment.dz, side * segment.dr};
}

NearFeature near_vertex(int feature, double r, double z) {
  const double distance = std::sqrt(r * r + z * z);
  if (distance == 0.0) return {feature, false, 0.0, 1.0, 0.0};
  return {feature, false, distance, r / distance, z / distance};
}

// Calls visit(NearFeature) for each segment onto which the centre projects and each vertex beyond both its segments.
// The two segments of a vertex are asked the same question, once, so that rounding can neither open a gap between their
// regions nor, for segments in line, let them overlap.
template <class Visit>
void visit_near_features(const Profile& profile, const Meridian& centre, Visit&& visit) {
  const std::size_t vertices = profile.vertices.size();
  const std::size_t segments = profile.segments.size();
  bool past_start = false;  // of the segment that leads to the current vertex
  for (std::size_t k = 0; k < vertices + (profile.closed ? 1 : 0); ++k) {
    const std::size_t v = k % vertices;
    const double r = centre.rho - profile.vertices[v][0];
    const double z = centre.z - profile.vertices[v][1];
    const bool has_before = k > 0 || profile.closed;
    const bool has_after = v < segments;
    bool past_end = true;
    bool past_next_start = true;
    if (has_before) {
      const std::size_t s = (v + segments - 1) % segments;
      const Profile::Segment& before = profile.segments[s];
      past_end = before.dr * r + before.dz * z > 0.0;
      if (k > 0 && past_start && !past_end) visit(near_face(static_cast<int>(2 * s + 1), r, z, before));
    }
    if (has_after) {
      const Profile::Segment& after = profile.segments[v];
      past_next_start = after.in_line ? past_end : after.dr * r + after.dz * z >= 0.0;
    }
    const bool beyond_after = !has_after || !past_next_start;
    if (k < vertices && past_end && beyond_after) visit(near_vertex(static_cast<int>(2 * v), r, z));
    past_start = past_next_start;
  }
}

Profile::Segment make_segment(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  const double dr = to[0] - from[0];
  const double dz = to[1] - from[1];
  const double length = std::sqrt(dr * dr + dz * dz);
  if (!(length > 0.0)) throw std::invalid_argument("two neighbouring points of a profile must not be equal");
  if (from[0] == 0.0 && to[0] == 0.0) throw std::invalid_argument("a profile must not run along its axis");
  return {dr / length, dz / length};
}

bool in_line(const Profile::Segment& a, const Profile::Segment& b) {
  if (std::fabs(a.dr * b.dz - a.dz * b.dr) >= in_line_angle) return false;
  if (a.dr * b.dr + a.dz * b.dz < 0.0) throw std::invalid_argument("a profile must not fold back onto itself");
  return true;
}

Vec3 perpendicular(const Vec3& axis) {
  const Vec3 other = std::fabs(axis.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  return unit_vector(other - dot(other, axis) * axis);
}

}  // namespace

double distance(const Profile& profile, const Vec3& centre) {
  double least = 1e300;
  visit_near_features(profile, meridian(profile, centre),
                      [&](const NearFeature& near) { least = std::min(least, near.distance); });
  return least;
}

void find_touches(const Profile& profile, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const Meridian at = meridian(profile, centre);
  visit_near_features(profile, at, [&](const NearFeature& near) {
    if (!(near.distance < reach)) return;
    const Vec3 normal = near.normal_r * at.outward + near.normal_z * profile.axis;
    out.add({.distance = near.distance,
             .normal = normal,
             .point = centre - near.distance * normal,
             .wall = wall,
             .feature = near.feature,
             .on_face = near.on_face});
  });
}

Face face_of(const Profile& profile, int feature) {
  const auto k = static_cast<std::size_t>(feature / 2);
  const auto [r, z] = profile.vertices[(k + 1) % profile.vertices.size()];  // as visit_near_features measures it
  const Profile::Segment& segment = profile.segments[k];
  return TurnedFace{profile.origin, profile.axis, profile.aside, r, z, segment.dr, segment.dz};
}

double margin(const Profile& profile, int feature, const Vec3& centre) {
  const Meridian at = meridian(profile, centre);
  const auto k = static_cast<std::size_t>(feature / 2);
  const auto along = [&](const std::array<double, 2>& vertex) {
    return profile.segments[k].dr * (at.rho - vertex[0]) + profile.segments[k].dz * (at.z - vertex[1]);
  };
  return std::min(along(profile.vertices[k]), -along(profile.vertices[(k + 1) % profile.vertices.size()]));
}

Profile make_profile(const std::vector<std::array<double, 2>>& points, const Vec3& origin, const Vec3& axis) {
  if (points.size() < 2) throw std::invalid_argument("a profile needs at least two points");
  for (const auto& point : points) {
    if (!(point[0] >= 0.0)) throw std::invalid_argument("a profile's r must not be negative");
  }
  Profile profile{
      .origin = origin, .axis = unit_vector(axis), .aside = {}, .closed = false, .vertices = points, .segments = {}};
  profile.aside = perpendicular(profile.axis);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    profile.segments.push_back(make_segment(points[k], points[k + 1]));
    if (k > 0) profile.segments[k].in_line = in_line(profile.segments[k - 1], profile.segments[k]);
  }
  profile.closed = points.front() == points.back();
  if (profile.closed) {
    profile.vertices.pop_back();
    profile.segments.front().in_line = in_line(profile.segments.back(), profile.segments.front());
  }
  return profile;
}

/// A disc is a profile of one segment.
Profile Profile::made(const WallDeck& deck, const ReadFile&) {
  if (deck.type == WallType::profile) return make_profile(deck.points, deck.axis_origin, deck.axis_direction);
  if (!(deck.radius > 0.0)) throw std::invalid_argument("the radius of a disc must be positive");
  return make_profile({{0.0, 0.0}, {deck.radius, 0.0}}, deck.centre, deck.normal);
}

bool keeps(const Profile& profile, const MotionDeck& motion) {
  return motion.type == MotionType::rotation && cross(motion.axis_direction, profile.axis) == Vec3{} &&
         cross(motion.axis_origin - profile.origin, profile.axis) == Vec3{};
}

bool adjacent_features(const Profile& profile, int a, int b) {
  const int apart = std::abs(a - b);
  return apart <= 2 || (profile.closed && apart >= 2 * static_cast<int>(profile.vertices.size()) - 2);
}

}  // namespace repose
