#include "integration/velocity_verlet.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/quad.h"
#include "deck/deck.h"
#include "scene/particles/materials.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

// A record is three quads: position and radius, velocity and force scale, spin and torque scale. What is added to the
// fourth element is always zero.
static_assert(sizeof(ParticleRecord) == 3 * sizeof(Quad));

/// v += a dt/2 for velocity and spin, once or twice; returns the velocity.
template <int kicks, int lanes>
[[gnu::always_inline]] inline Quad kick(const Quad& gravity, double half, double force_to_acceleration,
                                        double torque_to_acceleration, const QuadIntInMemory* sum,
                                        QuadInMemory* record) {
  if constexpr (lanes == 8) {
    const Octet scale = join(broadcast<Quad>(force_to_acceleration), broadcast<Quad>(torque_to_acceleration));
    const Octet sums = to_double(*reinterpret_cast<const OctetIntInMemory*>(sum));
    const Octet both = half * (scale * sums + join(gravity, Quad{}));
    Octet velocity_and_spin;
    std::memcpy(&velocity_and_spin, record + 1, sizeof velocity_and_spin);  // aligned to a quad only
    for (int k = 0; k < kicks; ++k) velocity_and_spin += both;
    std::memcpy(record + 1, &velocity_and_spin, sizeof velocity_and_spin);
    return low_half(velocity_and_spin);
  } else {
    const Quad velocity_kick = half * (force_to_acceleration * to_double(sum[0]) + gravity);
    const Quad spin_kick = half * (torque_to_acceleration * to_double(sum[1]));
    for (int k = 0; k < kicks; ++k) {
      record[1] += velocity_kick;
      record[2] += spin_kick;
    }
    return record[1];
  }
}

/// Whether a condition holds anywhere. The fourth elements, which are no coordinates, meet none of those below.
[[gnu::always_inline]] inline bool is_anywhere(const QuadInt& condition) {
  return any_bits(reinterpret_cast<QuadBits>(condition)) != 0;
}

[[gnu::always_inline]] inline std::size_t count_outside(const Quad& low, const Quad& high, const Particles& particles,
                                                        std::size_t size) {
  const auto* record = reinterpret_cast<const QuadInMemory*>(particles.record.data());
  std::size_t outside = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Quad position = record[3 * i];
    if (is_anywhere((position < low) | (position >= high))) ++outside;
  }
  return outside;
}

/// In periodic directions the ways are rounded to the grid of the positions.
template <int kicks, int lanes, bool periodic>
[[gnu::always_inline]] inline StepNotes kick_and_drift(const Vec3& gravity_in, double dt, const DomainDeck& domain,
                                                       std::span<const Mark> marks, std::span<std::int32_t> moved,
                                                       Particles& particles) {
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  const Quad gravity = {gravity_in.x, gravity_in.y, gravity_in.z, 0.0};
  const Quad drift = {dt, dt, dt, 0.0};
  const Vec3& grid = particles.periodic.rounding();
  const Quad rounding = {grid.x, grid.y, grid.z, 0.0};
  const Quad low = {domain.min.x, domain.min.y, domain.min.z, -no_bound};
  const Quad high = {domain.max.x, domain.max.y, domain.max.z, no_bound};
  auto* record = reinterpret_cast<QuadInMemory*>(particles.record.data());
  auto* sum = reinterpret_cast<QuadIntInMemory*>(particles.sum.data());
  const auto* mark = reinterpret_cast<const QuadInMemory*>(marks.data());
  const double* force_to_acceleration = particles.force_to_acceleration.data();
  const double* torque_to_acceleration = particles.torque_to_acceleration.data();
  StepNotes notes;
  Quad longest = {};
  QuadInt nowhere = {};
  QuadInt beyond = {};
  for (std::size_t i = 0; i < marks.size(); ++i, record += 3, sum += 2) {
    const Quad velocity =
        kick<kicks, lanes>(gravity, 0.5 * dt, force_to_acceleration[i], torque_to_acceleration[i], sum, record);
    sum[0] = QuadInt{};
    sum[1] = QuadInt{};
    Quad step = drift * velocity;
    if constexpr (periodic) step = (step + rounding) - rounding;
    const Quad position = record[0] + step;
    record[0] = position;
    beyond |= (position < low) | (position >= high);
    const Quad way = position - mark[i];
    const Quad squares = way * way;
    moved[notes.moved] = static_cast<std::int32_t>(i);  // overwritten by the next one, unless it counts
    notes.moved += squares[0] + squares[1] + squares[2] >= mark[i][3] ? 1U : 0U;
    const Quad lengths = magnitude(step);
    longest = longest > lengths ? longest : lengths;
    nowhere |= position != position;
  }
  notes.nowhere = is_anywhere(nowhere);
  if (is_anywhere(beyond)) notes.outside = count_outside(low, high, particles, marks.size());
  notes.longest_step = std::max({longest[0], longest[1], longest[2]});
  std::fill(particles.sum.begin() + static_cast<std::ptrdiff_t>(marks.size()), particles.sum.end(), ForceSum{});
  return notes;
}

template <int lanes>
[[gnu::always_inline]] inline void second_half(const Vec3& gravity_in, double dt, Particles& particles) {
  const Quad gravity = {gravity_in.x, gravity_in.y, gravity_in.z, 0.0};
  auto* records = reinterpret_cast<QuadInMemory*>(particles.record.data());
  const auto* sums = reinterpret_cast<const QuadIntInMemory*>(particles.sum.data());
  for (std::size_t i = 0; i < particles.owned; ++i) {
    kick<1, lanes>(gravity, 0.5 * dt, particles.force_to_acceleration[i], particles.torque_to_acceleration[i],
                   sums + 2 * i, records + 3 * i);
  }
}

/// Greatest power of two p with p * value < 2^(fixed_point_bits - 1).
double scale_for(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);  // value < 2^exponent
  return std::ldexp(1.0, fixed_point_bits - 1 - exponent);
}

template <int kicks>
StepNotes kick_and_drift_at(VectorLevel level, const Vec3& gravity, double dt, const DomainDeck& domain,
                            std::span<const Mark> marks, std::span<std::int32_t> moved, Particles& particles) {
  if (particles.periodic.any()) {
    return at_level(level, [&](auto lanes) REPOSE_INLINE {
      return kick_and_drift<kicks, lanes, true>(gravity, dt, domain, marks, moved, particles);
    });
  }
  return at_level(level, [&](auto lanes) REPOSE_INLINE {
    return kick_and_drift<kicks, lanes, false>(gravity, dt, domain, marks, moved, particles);
  });
}

}  // namespace

StepNotes step_first_half(VectorLevel level, const Vec3& gravity, double dt, const DomainDeck& domain,
                          std::span<const Mark> marks, std::span<std::int32_t> moved, Particles& particles) {
  return kick_and_drift_at<1>(level, gravity, dt, domain, marks, moved, particles);
}

StepNotes step_second_and_first_half(VectorLevel level, const Vec3& gravity, double dt, const DomainDeck& domain,
                                     std::span<const Mark> marks, std::span<std::int32_t> moved, Particles& particles) {
  return kick_and_drift_at<2>(level, gravity, dt, domain, marks, moved, particles);
}

void step_second_half(VectorLevel level, const Vec3& gravity, double dt, Particles& particles) {
  at_level(level, [&](auto lanes) REPOSE_INLINE { second_half<lanes>(gravity, dt, particles); });
}

void set_fixed_point_scales(const MaterialTable& materials, double max_overlap, Particles& particles) {
  constexpr double room = 4.0;  // for the dashpots, over the spring force at the greatest overlap
  particles.force_to_acceleration.resize(particles.owned);
  particles.torque_to_acceleration.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    const auto material = static_cast<std::size_t>(particles.material[i]);
    const double mass = sphere_mass(p.radius, materials[material].density);
    const double overlap = max_overlap * p.radius;
    const double force = room * materials.greatest_force(material, p.radius, overlap);
    p.force_scale = scale_for(force);
    p.torque_scale = scale_for(force * p.radius);
    particles.force_to_acceleration[i] = 1.0 / (p.force_scale * mass);
    particles.torque_to_acceleration[i] = 1.0 / (p.torque_scale * sphere_inertia(mass, p.radius));
  }
}

}  // namespace repose
