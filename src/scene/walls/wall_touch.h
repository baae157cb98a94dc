#pragma once

#include <array>
#include <span>

#include "base/vec3.h"

namespace repose {

/// One place where a sphere may touch a wall.
struct WallTouch {
  double distance = 0.0;   ///< m, from the sphere's centre to the wall's surface
  Vec3 normal;             ///< unit, from the touched point to the sphere's centre
  Vec3 point;              ///< the touched point
  int wall = 0;            ///< index of the wall
  int feature = 0;         ///< face, edge or corner of the wall (see adjacent_features)
  bool on_face = true;     ///< false: an edge or a corner
  int superseded_by = -1;  ///< set by resolve_touches: index in the buffer of the touch that stands for this one
};

/// The touches of one sphere. Fixed capacity, so that the wall search allocates nothing; what does not fit is dropped
/// and makes overflowed() true, which the caller must report.
class TouchBuffer {
 public:
  static constexpr int capacity = 16;

  void clear() {
    size_ = 0;
    overflowed_ = false;
  }
  void add(const WallTouch& touch) {
    if (size_ < capacity) {
      touches_[static_cast<std::size_t>(size_++)] = touch;
    } else {
      overflowed_ = true;
    }
  }
  int size() const { return size_; }
  bool overflowed() const { return overflowed_; }
  std::span<WallTouch> touches() { return {touches_.data(), static_cast<std::size_t>(size_)}; }
  std::span<const WallTouch> touches() const { return {touches_.data(), static_cast<std::size_t>(size_)}; }
  WallTouch& operator[](int i) { return touches_[static_cast<std::size_t>(i)]; }
  const WallTouch& operator[](int i) const { return touches_[static_cast<std::size_t>(i)]; }

 private:
  std::array<WallTouch, capacity> touches_;
  int size_ = 0;
  bool overflowed_ = false;
};

/// Settles which touches of one sphere count, by setting superseded_by of those that do not (-1: it counts). Flush
/// surfaces are felt once: an edge in the tangent plane of a touched face gives way to that face, and of two faces or
/// two edges of different walls touched at the same point the one of the lower wall index stays. A corner between two
/// walls stays two touches. The touch named in superseded_by always counts itself, and inherits the history of the one
/// it stands for. Surfaces are flush that are no further apart than the tolerance (m).
void resolve_touches(TouchBuffer& buffer, double tolerance);

}  // namespace repose
