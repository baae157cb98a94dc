#pragma once

#include <span>
#include <vector>

#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

/// Watches the way of particles since their inner and outer skins began. An inner skin keeps within the outer one: it
/// is no more than what is left of that. So outer lists hold every pair that inner ones may need until a particle has
/// nothing left of its outer skin.
///
/// Ghosts are watched as well: each rank begins their inner skins when it needs to, and the rank that owns them sees to
/// it that they keep within their outer ones.
class SkinWatch {
 public:
  SkinWatch(const SkinRule& inner, const SkinRule& outer) : inner_(inner), outer_(outer) {}

  /// To be called when an outer list has been made: all outer skins begin anew.
  void begin_outer(const Particles& particles);
  /// That of particle i does; its inner one has to follow.
  void begin_outer(const Particles& particles, std::size_t i);
  /// All inner skins begin anew.
  void begin_inner(const Particles& particles);
  /// Those of the particles `moved` do.
  void begin_inner(const Particles& particles, std::span<const std::int32_t> moved);

  /// The owned particles' inner skins: each has to begin anew when its particle has moved by as much.
  std::span<const Mark> inner_marks() const { return std::span(inner_marks_).first(owned_); }
  /// Of every particle, with its inner skin.
  std::span<const ReachSphere> inner_spheres() const { return inner_spheres_; }
  /// Particles that were parked since the last call need no list.
  void ignore_parked(const Particles& particles);
  /// The ghosts whose inner skins are used up, until the next call.
  std::span<const std::int32_t> moved_ghosts(const Particles& particles);
  /// Whether particle i, whose inner skin is used up, has nothing left of its outer skin.
  bool outer_is_used_up(const Particles& particles, std::size_t i) const;
  /// Where particle i was when its outer skin began, and its reach with that skin.
  ReachSphere outer_sphere(const Particles& particles, std::size_t i) const;

  /// How long, in s at present speed, outer skins are to cover from now on; to be followed by a new outer list.
  void set_outer_horizon(double horizon) { outer_.horizon = horizon; }

  std::size_t bytes() const {
    return bytes_of(inner_marks_) + bytes_of(outer_marks_) + bytes_of(inner_spheres_) + bytes_of(moved_ghosts_);
  }
  const SkinRule& inner() const { return inner_; }
  const SkinRule& outer() const { return outer_; }

 private:
  void begin_inner(const Particles& particles, std::size_t i);
  double left_of_outer(const Particles& particles, std::size_t i) const;

  SkinRule inner_;
  SkinRule outer_;
  std::size_t owned_ = 0;
  BigVector<Mark> inner_marks_;
  BigVector<ReachSphere> inner_spheres_;
  BigVector<Mark> outer_marks_;
  std::vector<std::int32_t> moved_ghosts_;
};

}  // namespace repose
