#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "comm/communicator.h"
#include "scene/insertion/new_particles.h"
#include "scene/insertion/pour.h"
#include "scene/insertion/sphere_grid.h"
#include "scene/particles/particles.h"
#include "scene/walls/wall.h"

namespace repose {

/// What a batch of new particles needs to know of the simulation.
struct PourMoment {
  std::int64_t step;
  std::uint64_t seed;
  Vec3 gravity;  ///< m/s^2
};

/// Brings the planned particles in while a run goes on, in batches at fixed steps. All it remembers is how many of each
/// pour have entered; everything else is a function of the deck, the step and the state of all particles, so that it
/// does the same on any number of ranks.
class Pouring {
 public:
  Pouring() = default;
  Pouring(std::vector<Pour> pours, double timestep);

  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

  /// The next step at which particles may enter, or never.
  std::int64_t next_step() const { return next_step_; }
  std::int64_t entered() const;
  /// Whether a pour has begun by this step and has still particles to bring in.
  bool is_under_way(std::int64_t step) const;
  bool is_complete() const { return next_step_ == never; }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v.each("flows", self.flows_);
    v("next_step", self.next_step_);
  }

  /// Collective. The particles that enter at next_step(), the same on all ranks: of those that are due the first ones,
  /// in their order, as long as each finds a place where it meets no particle and no present wall. The others wait for
  /// the next batch. `particles` after the drift. PhysicsError when one has waited for too many batches.
  NewParticles enter(const Communicator& comm, const PourMoment& now, const Particles& particles,
                     const std::vector<Wall>& walls);

 private:
  struct Flow {
    Pour pour;
    double largest;      ///< m, radius of the pour
    std::int64_t start;  ///< step
    std::int64_t every;  ///< steps between batches
    std::int64_t next;   ///< step of the next batch
    std::int64_t entered = 0;

    template <class Self, class Visitor>
    static void describe_state(Self& self, Visitor& v) {
      v("next", self.next);
      v("entered", self.entered);
    }
  };
  struct Batch;
  void enter(Flow& flow, Batch& batch) const;
  void wait(const Flow& flow, std::int64_t due, double time) const;

  double timestep_ = 0.0;
  std::vector<Flow> flows_;
  std::int64_t next_step_ = never;
};

}  // namespace repose
