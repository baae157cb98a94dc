#include "simulation/guards.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "integration/velocity_verlet.h"
#include "output/collect_particles.h"

namespace repose {
namespace {

bool is_finite(const Vec3& v) { return std::isfinite(squared_norm(v)); }
bool is_finite(const ParticleRecord& p) { return is_finite(p.position) && is_finite(p.velocity) && is_finite(p.spin); }

double speed_of(const ParticleRecord& p) { return std::hypot(p.velocity.x, p.velocity.y, p.velocity.z); }

ParticleTable neighbourhood(const GuardView& view, const Vec3& place, double range) {
  const Particles& particles = view.particles;
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < particles.total(); ++i) {
    const ParticleRecord& p = particles.record[i];
    const double reach = range + p.radius;
    if (is_finite(p) && !is_parked(p) && squared_norm(p.position - place) < reach * reach) near.push_back(i);
  }
  std::stable_sort(near.begin(), near.end(),
                   [&](std::size_t a, std::size_t b) { return particles.id[a] < particles.id[b]; });
  ParticleTable table;
  for (const std::size_t i : near) {
    append_row(table, particles.id[i], particles.record[i], particles.material[i], view.materials);
  }
  return table;
}

Alarm not_finite(const GuardView& view, std::size_t i) {
  const ParticleRecord& p = view.particles.record[i];
  const char* what = !is_finite(p.position) ? "position" : !is_finite(p.velocity) ? "velocity" : "spin";
  const bool is_there = is_finite(p.position);
  const Vec3 place = is_there || view.marks.empty() ? p.position : view.marks[i].position;
  return alarm_at(
      view, i, place,
      fmt::format("particle {} {} {} has a {} that is not finite, or too large to be squared; look for forces, "
                  "motions or gravity beyond measure, or shorten time.step",
                  view.particles.id[i], is_there ? "at" : "last listed at", place_text(place), what));
}

Alarm too_far(const GuardView& view, std::size_t i) {
  const ParticleRecord& p = view.particles.record[i];
  const Vec3 from = p.position - view.dt * p.velocity;
  const double share = speed_of(p) * view.dt / p.radius;
  const std::string who = fmt::format("particle {} from {}", view.particles.id[i], place_text(from));
  return alarm_at(view, i, from, too_far_text(who, speed_of(p), share, view.dt, "look for what has driven it"));
}

Alarm too_fast(const GuardView& view, const TimeStep& time_step, std::size_t i) {
  const Vec3 position = view.particles.position(i);
  const std::string who = fmt::format("particle {} at {}", view.particles.id[i], place_text(position));
  return alarm_at(view, i, view.particles.record[i].position,
                  too_fast_text(who, speed_of(view.particles.record[i]), time_step));
}

/// Beyond half of the range. A sum that has wrapped lies there, too, unless it were beyond three halves.
bool is_nearly_full(const ForceSum& sum) {
  const auto beyond = [](std::int64_t s) { return s >= std::int64_t{1} << 62 || s < -(std::int64_t{1} << 62); };
  return std::any_of(sum.force, sum.force + 3, beyond) || std::any_of(sum.torque, sum.torque + 3, beyond);
}

}  // namespace

std::string too_far_text(const std::string& who, double speed, double share, double dt, const std::string& remedy) {
  return fmt::format(
      "{} moves at {:.3g} m/s, {:.3g} of its radius in one step: beyond {} it could pass through a wall or "
      "another particle unseen; shorten time.step to {:.1e} s, or {}",
      who, speed, share, longest_way, 0.5 * longest_way / share * dt, remedy);
}

std::string too_fast_text(const std::string& who, double speed, const TimeStep& time_step) {
  return fmt::format(
      "{} moves at {:.3g} m/s, for which the time step {:.3g} s is {:.2f} times its criterion (expected "
      "{:.3g} m/s; an error at {:g}); set time.expected_speed to {:.3g} or shorten time.step",
      who, speed, time_step.step, time_step_excess(time_step, speed), time_step.speed, greatest_excess, speed);
}

std::string place_text(const Vec3& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", x.x, x.y, x.z); }

Alarm alarm_at(const GuardView& view, std::size_t index, const Vec3& place, const std::string& what) {
  constexpr double radii = 6.0;
  return {.step = view.step,
          .time = static_cast<double>(view.step) * view.dt,
          .message = fmt::format("step {}: {}", view.step, what),
          .neighbourhood = neighbourhood(view, place, radii * view.particles.record[index].radius)};
}

std::optional<Alarm> agree_on(const Communicator& comm, const std::optional<Alarm>& alarm) {
  const int none = comm.size();
  const int first = comm.min(alarm ? comm.rank() : none);
  if (first == none) return {};
  Alarm agreed = first == comm.rank() ? *alarm : Alarm{};
  comm.broadcast(agreed.step, first);
  comm.broadcast(agreed.time, first);
  comm.broadcast(agreed.message, first);
  ParticleTable& table = agreed.neighbourhood;
  const auto rows = std::ssize(table.id);
  table.total = comm.sum(std::int64_t{rows});
  table.offset = comm.exclusive_sum(rows);
  return agreed;
}

void throw_if_any(const Communicator& comm, const std::optional<Alarm>& alarm) {
  if (std::optional<Alarm> agreed = agree_on(comm, alarm)) throw GuardError(std::move(*agreed));
}

std::optional<Alarm> find_unfit(const GuardView& view) {
  const Particles& particles = view.particles;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    if (!is_finite(p)) return not_finite(view, i);
    if (!(squared_norm(view.dt * p.velocity) < squared_norm(Vec3{longest_way * p.radius}))) return too_far(view, i);
  }
  return {};
}

std::optional<Alarm> find_too_fast(const GuardView& view, const TimeStep& time_step) {
  const double greatest = greatest_speed(time_step, greatest_excess);
  for (std::size_t i = 0; i < view.particles.owned; ++i) {
    const ParticleRecord& p = view.particles.record[i];
    if (!is_parked(p) && speed_of(p) > greatest) return too_fast(view, time_step, i);
  }
  return {};
}

std::vector<std::int32_t> crowded_particles(std::span<const IndexPair> near, std::size_t owned) {
  std::vector<std::size_t> count(owned, 0);
  std::vector<std::int32_t> crowded;
  const auto add = [&](std::int32_t i) {
    if (static_cast<std::size_t>(i) < owned && ++count[static_cast<std::size_t>(i)] == crowd) crowded.push_back(i);
  };
  for (const auto& [i, j] : near) {
    add(i);
    add(j);
  }
  return crowded;
}

std::optional<Alarm> find_full_sum(const GuardView& view, std::span<const std::int32_t> crowded) {
  const Particles& particles = view.particles;
  for (const std::int32_t k : crowded) {
    const auto i = static_cast<std::size_t>(k);
    if (!is_nearly_full(particles.sum[i])) continue;
    return alarm_at(view, i, particles.record[i].position,
                    fmt::format("the forces on particle {} at {} add up to more than half of what their fixed-point "
                                "sum holds; look for what presses so many particles against it",
                                particles.id[i], place_text(particles.position(i))));
  }
  return {};
}

std::optional<std::size_t> fastest_particle(const Particles& particles) {
  std::optional<std::size_t> fastest;
  double greatest = -1.0;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const double speed = norm(particles.record[i].velocity);
    if (!(speed > greatest)) continue;
    greatest = speed;
    fastest = i;
  }
  return fastest;
}

std::optional<std::string> warning_of_time_step(const Communicator& comm, const GuardView& view,
                                                const TimeStep& time_step, std::optional<std::size_t> fastest_here) {
  const double speed_here = fastest_here ? norm(view.particles.record[*fastest_here].velocity) : -1.0;
  const double fastest = comm.max(speed_here);
  if (fastest < 0.0 || !(time_step_excess(time_step, fastest) > 1.0 + 1e-9)) return {};
  std::optional<Alarm> alarm;
  if (speed_here == fastest) alarm = too_fast(view, time_step, *fastest_here);
  return agree_on(comm, alarm)->message;
}

}  // namespace repose
