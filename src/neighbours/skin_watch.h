#pragma once

#include <span>
#include <vector>

#include "scene/particles.h"
#include "scene/reach.h"

namespace repose {

/// Watches the owned particles' way since the inner and the outer neighbour lists were made.
class SkinWatch {
 public:
  SkinWatch(const SkinRule& inner, const SkinRule& outer) : inner_(inner), outer_(outer) {}

  void lists_rebuilt(const Particles& particles);
  void inner_selected(const Particles& particles);

  /// Whether a particle has moved by its inner skin.
  bool inner_is_used_up(const Particles& particles) const;
  /// Whether a particle has too little left of its outer skin for another inner list. To be asked on all ranks as soon
  /// as the inner skin is used up on any: a new inner list grants every particle another inner skin.
  bool outer_is_too_short(const Particles& particles) const;

  const SkinRule& inner() const { return inner_; }
  const SkinRule& outer() const { return outer_; }

 private:
  struct Mark {
    Vec3 position;
    double skin;
  };
  static void mark(const Particles& particles, const SkinRule& rule, std::vector<Mark>& marks);

  SkinRule inner_;
  SkinRule outer_;
  std::vector<Mark> inner_marks_;
  std::vector<Mark> outer_marks_;
};

}  // namespace repose
