#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "comm/communicator.h"
#include "integration/time_step.h"
#include "neighbours/near_pairs.h"
#include "output/particle_table.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

/// What the guards look at: the particles of this rank at a step.
struct GuardView {
  const Particles& particles;
  const MaterialTable& materials;
  std::span<const Mark> marks;  ///< where the owned particles were when they were listed; may be empty
  std::int64_t step;
  double dt;  ///< s
};

/// A guard that was hit on this rank.
struct Alarm {
  std::int64_t step;
  double time;                  ///< s
  std::string message;          ///< one line: step, what, which particles, where, remedy
  ParticleTable neighbourhood;  ///< what this rank knows of the particles around; ghosts, too
};

/// A guard was hit. Thrown on all ranks alike, but for the neighbourhood, whose rows one rank holds.
class GuardError : public PhysicsError {
 public:
  explicit GuardError(Alarm alarm) : PhysicsError(alarm.message), alarm_(std::move(alarm)) {}
  const Alarm& alarm() const { return alarm_; }

 private:
  Alarm alarm_;
};

/// Collective. The alarm of the lowest rank that has one, on all ranks; the rows of the neighbourhood on that rank
/// alone.
std::optional<Alarm> agree_on(const Communicator& comm, const std::optional<Alarm>& alarm);

/// Collective. GuardError on all ranks when there is an alarm on any.
void throw_if_any(const Communicator& comm, const std::optional<Alarm>& alarm);

/// An alarm about particle `index` with the neighbourhood of `place` (m): what is within six radii of it. `what` is the
/// message without the step.
Alarm alarm_at(const GuardView& view, std::size_t index, const Vec3& place, const std::string& what);

/// What is said of a particle, as `who` names it, whose speed (m/s) takes it by this `share` of its radius in a step of
/// `dt` s, and what may help besides a shorter one.
std::string too_far_text(const std::string& who, double speed, double share, double dt, const std::string& remedy);

/// What is said of a particle that is too fast for the criteria of the time step.
std::string too_fast_text(const std::string& who, double speed, const TimeStep& time_step);

/// (x, y, z) in m, as the messages have it.
std::string place_text(const Vec3& place);

/// The first owned particle with a position, velocity or spin that is not finite (or too large to be squared), or that
/// moves by longest_way of its radius in a step (velocity_verlet.h). Nothing when all are fit.
std::optional<Alarm> find_unfit(const GuardView& view);

/// The time step may be so many times its criteria for a particle's true speed before a run stops.
inline constexpr double greatest_excess = 2.0;

/// The first owned particle that is faster; nothing when there is none. To be asked at each step: an answer that
/// depended on when lists are made would differ from one number of ranks to another.
std::optional<Alarm> find_too_fast(const GuardView& view, const TimeStep& time_step);

/// So many contributions and as many again, with those of walls, are less than a force sum holds, each being in its own
/// range (contact/fixed_point.h).
constexpr std::size_t crowd = 2000;

/// The owned particles with so many near pairs, a crowd or more, that their force sums could come to be beyond half of
/// their range, each contribution being in its own (contact/fixed_point.h). A big ball among small grains is one.
std::vector<std::int32_t> crowded_particles(std::span<const IndexPair> near, std::size_t owned);

/// The first of the `crowded` particles whose force sum is beyond half of its range; nothing when there is none.
std::optional<Alarm> find_full_sum(const GuardView& view, std::span<const std::int32_t> crowded);

/// Of the owned ones; nothing when there is none.
std::optional<std::size_t> fastest_particle(const Particles& particles);

/// Collective. A warning, the same on all ranks, when the time step is beyond its criteria for the fastest particle of
/// all ranks, by fastest_particle of each.
std::optional<std::string> warning_of_time_step(const Communicator& comm, const GuardView& view,
                                                const TimeStep& time_step, std::optional<std::size_t> fastest_here);

}  // namespace repose
