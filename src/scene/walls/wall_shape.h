#pragma once

#include <cstdlib>
#include <variant>

#include "scene/walls/mesh.h"
#include "scene/walls/plane.h"
#include "scene/walls/profile.h"
#include "scene/walls/rectangle.h"

/// The shapes of walls: surfaces without thickness, felt from both sides, a file each. Only plain arithmetic and square
/// roots, so that the results are the same bits everywhere. A shape has
///   static bool is(WallType), static Shape made(deck, read_file)
///   find_touches(shape, centre, reach, wall, out)   appends the features nearer to `centre` than `reach` (m, strictly)
///   distance(shape, centre)                         in m from `centre` to the surface
///   face_of(shape, feature)                         the face that a feature is
///   margin(shape, feature, centre)                  m that a centre which projects onto the face may move in any
///                                                   direction and still do so
/// and, where it has to differ from what is below, the functions there.
namespace repose {

using WallShape = std::variant<Plane, Rectangle, Profile, Mesh>;

/// Whether a motion brings every point of the shape to another of its points.
template <class Shape>
bool keeps(const Shape&, const MotionDeck&) {
  return false;
}

/// Whether the surface is nearer to `centre` than `reach` (m); it may also be true when it is farther by rounding.
template <class Shape>
bool is_within(const Shape& shape, const Vec3& centre, double reach) {
  return distance(shape, centre) < reach;
}

/// Whether a particle whose only touch within the reach (m, its radius and skin) is the face `feature` can touch
/// nothing else of the shape until it has moved by `skin` (m): the touches of most shapes are all their features within
/// reach, so only the end of the face can come nearer.
template <class Shape>
bool keeps_to_face(const Shape& shape, int feature, const Vec3& centre, double, double skin) {
  return margin(shape, feature, centre) > 1.001 * skin;
}

/// Whether two features meet (or are one), so that a contact may pass from one to the other with its history.
template <class Shape>
bool adjacent_features(const Shape&, int a, int b) {
  return std::abs(a - b) <= 2;
}

}  // namespace repose
