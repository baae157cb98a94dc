#pragma once

#include <span>
#include <vector>

#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

/// Watches the owned particles' way since the inner and the outer neighbour lists were made.
class SkinWatch {
 public:
  SkinWatch(const SkinRule& inner, const SkinRule& outer) : inner_(inner), outer_(outer) {}

  /// To be called when an outer or an inner list has been made.
  void outer_listed(const Particles& particles);
  void inner_selected(const Particles& particles);

  /// The owned particles' inner skins: the list has to be made anew when one has moved by its own.
  std::span<const Mark> inner_marks() const { return inner_marks_; }
  /// Particles that were parked since the last call need no list.
  void ignore_parked(const Particles& particles);
  /// Whether a particle has too little left of its outer skin for another inner list. To be asked on all ranks as soon
  /// as the inner skin is used up on any: a new inner list grants every particle another inner skin.
  bool outer_is_too_short(const Particles& particles) const;

  /// How long, in s at present speed, inner and outer skins are to cover from now on; to be followed by a new outer
  /// list.
  void set_horizons(double inner, double outer) {
    inner_.horizon = inner;
    outer_.horizon = outer;
  }

  std::size_t bytes() const { return bytes_of(inner_marks_) + bytes_of(outer_marks_); }
  const SkinRule& inner() const { return inner_; }
  const SkinRule& outer() const { return outer_; }

 private:
  static void mark(const Particles& particles, const SkinRule& rule, BigVector<Mark>& marks);

  SkinRule inner_;
  SkinRule outer_;
  BigVector<Mark> inner_marks_;
  BigVector<Mark> outer_marks_;
};

}  // namespace repose
