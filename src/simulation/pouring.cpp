#include "simulation/pouring.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "base/error.h"
#include "base/philox.h"
#include "integration/time_step.h"
#include "scene/insertion/region.h"

namespace repose {
namespace {

constexpr std::uint32_t tries = 64;          // places a particle tries in one batch: one bit each
constexpr std::int64_t most_at_once = 4096;  // particles in one reduction
constexpr double patience = 50.0;            // batches a particle may wait for

/// The box that spheres of at most `r` m enter in.
Box entrance(const Pour& pour, double r) {
  const auto& [min, max] = pour.bounds;
  return {min - Vec3{r, r, r}, max + Vec3{r, r, r}};
}

bool reaches_into(const Box& box, const Vec3& x, double r) {
  return x.x + r > box.min.x && x.x - r < box.max.x && x.y + r > box.min.y && x.y - r < box.max.y &&
         x.z + r > box.min.z && x.z - r < box.max.z;
}

/// The particles of this rank that reach into a box, and their images across periodic boundaries that do.
SphereGrid spheres_in(const Box& box, const Particles& particles) {
  const double farthest = norm(box.max - box.min);
  SphereGrid grid;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const double r = particles.record[i].radius;
    if (is_parked(particles.record[i])) continue;
    const Vec3 position = particles.position(i);
    particles.periodic.for_each_shift(position, r + farthest, [&](const Vec3& shift) {
      if (reaches_into(box, position + shift, r)) grid.add(position + shift, r);
    });
  }
  return grid;
}

}  // namespace

/// What the pours of one step share.
struct Pouring::Batch {
  const Communicator& comm;
  const PourMoment& now;
  const Particles& particles;
  const std::vector<Wall>& walls;
  double largest;  ///< m, radius of all that is poured
  NewParticles entering = {};
  SphereGrid fresh = {};  ///< those that are entering, and their images

  std::optional<Vec3> place(const Flow& flow, std::int64_t k, std::uint32_t attempt) const {
    const auto number = static_cast<std::uint32_t>((now.step - flow.start) / flow.every);
    return random_place(flow.pour, flow.pour.radius[static_cast<std::size_t>(k)], now.seed, flow.pour.first_id + k,
                        RandomStream::pour_position, 3 * (number * tries + attempt));
  }

  /// For each of `count` particles from `first` on: a bit for each of its places that is outside the region or taken.
  std::vector<std::uint64_t> taken(const Flow& flow, std::int64_t first, std::int64_t count,
                                   const SphereGrid& others) const {
    std::vector<std::uint64_t> bits(static_cast<std::size_t>(count), 0);
    for (std::int64_t k = 0; k < count; ++k) {
      const double radius = flow.pour.radius[static_cast<std::size_t>(first + k)];
      for (std::uint32_t attempt = 0; attempt < tries; ++attempt) {
        const auto at = place(flow, first + k, attempt);
        if (!at || others.overlaps(*at, radius)) bits[static_cast<std::size_t>(k)] |= std::uint64_t{1} << attempt;
      }
    }
    comm.or_elements(bits);
    return bits;
  }

  /// The first free place that neither a new particle nor a wall takes.
  std::optional<Vec3> choose(const Flow& flow, std::int64_t k, std::uint64_t taken_bits) const {
    const double radius = flow.pour.radius[static_cast<std::size_t>(k)];
    for (std::uint32_t attempt = 0; attempt < tries; ++attempt) {
      if ((taken_bits >> attempt & 1) != 0) continue;
      const auto at = place(flow, k, attempt);
      if (!fresh.overlaps(*at, radius) && clear_of_walls(*at, radius, walls)) return at;
    }
    return {};
  }

  /// The second half of this step's kick still follows: without it the particle has the velocity of the deck.
  void add(const Flow& flow, std::int64_t k, const Vec3& at, double timestep) {
    const double radius = flow.pour.radius[static_cast<std::size_t>(k)];
    entering.id.push_back(flow.pour.first_id + k);
    entering.position.push_back(at);
    entering.velocity.push_back(flow.pour.deck.velocity - (0.5 * timestep) * now.gravity);
    entering.spin.push_back({});
    entering.radius.push_back(radius);
    entering.material.push_back(flow.pour.material);
    particles.periodic.for_each_shift(at, radius + largest, [&](const Vec3& shift) { fresh.add(at + shift, radius); });
  }
};

Pouring::Pouring(std::vector<Pour> pours, double timestep) : timestep_(timestep) {
  for (Pour& pour : pours) {
    const std::int64_t start = steps_for(std::ceil(pour.deck.start_time / timestep), 1.0);  // not before its time
    const std::int64_t every = std::max<std::int64_t>(1, steps_for(pour.interval, timestep));
    const double largest = *std::max_element(pour.radius.begin(), pour.radius.end());
    flows_.push_back({std::move(pour), largest, start, every, start + every});
    next_step_ = std::min(next_step_, flows_.back().next);
  }
}

std::int64_t Pouring::entered() const {
  std::int64_t all = 0;
  for (const Flow& flow : flows_) all += flow.entered;
  return all;
}

bool Pouring::is_under_way(std::int64_t step) const {
  return std::any_of(flows_.begin(), flows_.end(),
                     [&](const Flow& flow) { return step >= flow.start && flow.entered < flow.pour.size(); });
}

NewParticles Pouring::enter(const Communicator& comm, const PourMoment& now, const Particles& particles,
                            const std::vector<Wall>& walls) {
  double largest = 0.0;
  for (const Flow& flow : flows_) largest = std::max(largest, flow.largest);
  Batch batch{comm, now, particles, walls, largest};
  next_step_ = never;
  for (Flow& flow : flows_) {
    if (flow.next == now.step) {
      enter(flow, batch);
      flow.next = flow.entered < flow.pour.size() ? now.step + flow.every : never;
    }
    next_step_ = std::min(next_step_, flow.next);
  }
  return std::move(batch.entering);
}

void Pouring::enter(Flow& flow, Batch& batch) const {
  const double time = static_cast<double>(batch.now.step) * timestep_;
  const auto& due_time = flow.pour.due_time;
  const std::int64_t due = std::upper_bound(due_time.begin(), due_time.end(), time) - due_time.begin();
  if (flow.entered == due) return;
  const SphereGrid others = spheres_in(entrance(flow.pour, flow.largest), batch.particles);
  while (flow.entered < due) {
    const std::int64_t first = flow.entered;
    const std::vector<std::uint64_t> taken = batch.taken(flow, first, std::min(due - first, most_at_once), others);
    for (const std::uint64_t bits : taken) {
      const auto at = batch.choose(flow, flow.entered, bits);
      if (!at) return wait(flow, due, time);
      batch.add(flow, flow.entered, *at, timestep_);
      ++flow.entered;
    }
  }
}

/// The particles that are due but found no place come again with the next batch, unless that has been so for too long.
void Pouring::wait(const Flow& flow, std::int64_t due, double time) const {
  const double waited = time - flow.pour.due_time[static_cast<std::size_t>(flow.entered)];
  if (waited <= patience * static_cast<double>(flow.every) * timestep_) return;
  const double since_start = time - static_cast<double>(flow.start) * timestep_;
  throw PhysicsError(fmt::format(
      "step {}: {}: {} particles find no room, the first of them for {:.3g} s: {} of the {} that are due have entered; "
      "take a particle_rate of at most {:.3g} 1/s, a greater region or a higher velocity",
      static_cast<std::int64_t>(std::rint(time / timestep_)), flow.pour.block, due - flow.entered, waited, flow.entered,
      due, static_cast<double>(flow.entered) / since_start));
}

}  // namespace repose
