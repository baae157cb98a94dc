#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/insertion/insertion.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"
#include "scene/walls/motion.h"

namespace repose {

/// The particles that forces do not move: fixed ones and those on a prescribed path; and those that never turn.
/// Integration treats them like all others, then they are put back to where they have to be.
class HeldParticles {
 public:
  HeldParticles() = default;
  HeldParticles(const Deck& deck, const Insertion& insertion);

  /// After reading it, place has to be called.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v.each("blocks", self.blocks_);
  }

  void begin_phase(const std::string& phase);
  /// Finds them among the owned particles of this rank, and makes forces or torques without effect on them. To be
  /// called when the particles have been sorted anew.
  void list(Particles& particles);

  /// One step of `dt` s has passed.
  void step(double dt);
  /// Brings the blocks to where their motions are after all steps so far of `dt` s.
  void place(double dt);
  /// Puts the listed particles to where they are now, with the velocity and spin of their motion.
  void hold(Particles& particles) const;
  /// Those of them that have used up their skins, where hold has put them, into `moved`. How many they are.
  std::size_t find_moved(std::span<const Mark> marks, const Particles& particles, std::span<std::int32_t> moved) const;
  /// Whether hold has put one of them out of the domain that is not parked.
  bool is_any_outside(const DomainDeck& domain, const Particles& particles) const;
  std::size_t listed() const { return held_.size(); }

 private:
  /// A block of the deck with particles first to end - 1.
  struct Block {
    std::int64_t first, end;
    bool held;                ///< else only its rotation is blocked
    std::vector<Vec3> start;  ///< m, where they begin, when they have motions
    Motions motions;
    Placement placement;

    bool contains(std::int64_t id) const { return id >= first && id < end; }

    template <class Self, class Visitor>
    static void describe_state(Self& self, Visitor& v) {
      v("motions", self.motions);
    }
  };
  struct Held {
    std::size_t index;  ///< of the particle
    std::size_t block;
    Vec3 position;  ///< m, in the deck; of a fixed one where it is
  };
  std::vector<Block> blocks_;
  std::vector<Held> held_;
};

}  // namespace repose
