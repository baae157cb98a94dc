#pragma once

#include <span>
#include <vector>

#include "scene/particles.h"
#include "scene/reach.h"

namespace repose {

/// What a list needs after the particles have moved; the worst over all ranks counts for all.
enum class ListState : int { valid = 0, inner_stale = 1, outer_stale = 2 };

/// Watches the owned particles' way since the inner and the outer neighbour lists were made.
class SkinWatch {
 public:
  SkinWatch(const SkinRule& inner, const SkinRule& outer) : inner_(inner), outer_(outer) {}

  void lists_rebuilt(const Particles& particles);
  void inner_selected(const Particles& particles);

  /// inner_stale when a particle has moved by its inner skin; outer_stale when, in addition, one has too little left of
  /// its outer skin for another inner list.
  ListState state(const Particles& particles) const;

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
