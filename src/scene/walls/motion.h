#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/math.h"
#include "base/vec3.h"
#include "deck/deck.h"

namespace repose {

/// How the surface of a rigid body moves: the velocity of its point at x is velocity + angular_velocity cross x, and
/// that of the belt which runs along it.
struct SurfaceMotion {
  Vec3 velocity;          ///< m/s, of the point at the origin of coordinates
  Vec3 angular_velocity;  ///< rad/s
  Vec3 belt;              ///< m/s, of all conveyors together

  Vec3 at(const Vec3& x) const { return velocity + cross(angular_velocity, x); }
};

/// Where a rigid body is that stood elsewhere in the deck, and how it moves.
struct Placement {
  std::array<Vec3, 3> rows = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};  ///< of the rotation
  Vec3 shift;  ///< m, of the point at the origin of coordinates
  SurfaceMotion motion;

  /// A direction and a point of the deck as they are now.
  template <class Real>
  [[gnu::always_inline]] Vector3<Real> turn(const Vector3<Real>& v) const {
    return {dot(broadcast<Real>(rows[0]), v), dot(broadcast<Real>(rows[1]), v), dot(broadcast<Real>(rows[2]), v)};
  }
  Vec3 place(const Vec3& x) const { return turn(x) + shift; }
  /// Where in the deck a point of the present was.
  template <class Real>
  [[gnu::always_inline]] Vector3<Real> back(const Vector3<Real>& x) const {
    const Vector3<Real> v = x - broadcast<Real>(shift);
    return v.x * broadcast<Real>(rows[0]) + v.y * broadcast<Real>(rows[1]) + v.z * broadcast<Real>(rows[2]);
  }
};

/// What a turn by `angle` (rad) about the axis through `origin` (m) along `axis` (unit) does to a body, by the
/// right-hand rule; it rests there.
Placement turned_about(const Vec3& origin, const Vec3& axis, double angle);

/// `inner`, carried along by `outer`.
Placement carried(const Placement& outer, const Placement& inner);

/// The prescribed motions of one body. The first is applied first, a later one carries its result along. Each advances
/// during its phases only, so that where the body is depends on nothing but how many steps each has advanced.
class Motions {
 public:
  Motions() = default;
  explicit Motions(const std::vector<MotionDeck>& motions) : motions_(motions), clocks_(motions.size()) {}

  bool empty() const { return motions_.empty(); }
  const std::vector<MotionDeck>& motions() const { return motions_; }

  /// Motions advance in the phases they name, or in all.
  void begin_phase(const std::string& phase);
  void step();
  /// After all steps so far of `dt` s.
  Placement placement(double dt) const;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v.each("clocks", self.clocks_);
  }

 private:
  struct Clock {
    std::int64_t steps = 0;
    bool runs = false;

    template <class Self, class Visitor>
    static void describe_state(Self& self, Visitor& v) {
      v("steps", self.steps);
      v("runs", self.runs);
    }
  };
  std::vector<MotionDeck> motions_;
  std::vector<Clock> clocks_;
};

/// The greatest speed in m/s that the motions can give a point within the domain.
double greatest_speed(const std::vector<MotionDeck>& motions, const DomainDeck& domain);

/// `v` turned by an angle about the direction `axis` (unit) by the right-hand rule (Rodrigues' formula).
Vec3 turned(const Vec3& v, const Vec3& axis, const SineCosine& angle);

}  // namespace repose
