#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/big_vector.h"
#include "base/bytes.h"
#include "base/vec3.h"
#include "scene/particles/periodicity.h"

namespace repose {

/// What a contact needs to know of a particle: twelve doubles in three aligned quads, fetched together by the pair
/// loop.
struct alignas(32) ParticleRecord {
  Vec3 position;
  double radius;
  Vec3 velocity;
  double force_scale;  ///< power of two: newtons to units of the fixed-point sum
  Vec3 spin;
  double torque_scale;  ///< power of two: newton metres to units of the fixed-point sum
};
static_assert(sizeof(ParticleRecord) == 96);

/// Force and torque on a particle as fixed-point integers: their sum does not depend on the order of the contacts, so
/// it is the same on any number of ranks. The fourth element is padding.
struct alignas(64) ForceSum {
  std::int64_t force[4];
  std::int64_t torque[4];
};

/// Bits of one contribution to a ForceSum; each must be smaller than half of that in magnitude (checked, never
/// wrapped).
inline constexpr int fixed_point_bits = 52;

/// The particles of one rank: first those it owns, in the order of layers (domain/layer_order.h), then its ghosts
/// (copies of particles that other ranks own). All arrays have the same length but for those of owned particles alone.
struct Particles {
  BigVector<ParticleRecord> record;
  BigVector<ForceSum> sum;
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> material;
  std::vector<double> force_to_acceleration;   ///< owned: fixed-point force to m/s2
  std::vector<double> torque_to_acceleration;  ///< owned: fixed-point torque to rad/s2
  std::vector<std::int64_t> heat;              ///< owned: in the run's HeatUnit; empty without [heat]
  bool has_heat = false;                       ///< the same on all ranks
  std::size_t owned = 0;
  Periodicity periodic;

  /// In the domain. The record's position of a particle that has crossed a periodic boundary is brought back there at
  /// the next list rebuild only; whatever asks where a particle is, not how far two are apart, must ask here.
  Vec3 position(std::size_t i) const { return periodic.wrapped(record[i].position); }

  std::size_t total() const { return id.size(); }  ///< owned and ghosts
  std::size_t ghosts() const { return total() - owned; }
  std::size_t bytes() const {
    return bytes_of(record) + bytes_of(sum) + bytes_of(id) + bytes_of(material) + bytes_of(force_to_acceleration) +
           bytes_of(torque_to_acceleration) + bytes_of(heat);
  }
};

/// Brings all owned particles back into the domain in the periodic directions.
inline void wrap_positions(Particles& particles) {
  if (!particles.periodic.any()) return;
  for (std::size_t i = 0; i < particles.owned; ++i) particles.record[i].position = particles.position(i);
}

/// A particle that has left the domain is parked far away until the next list rebuild drops it: out of every contact
/// from that very step on, on every rank that holds a copy. Parked particles are far from one another too.
inline constexpr double parking_distance = 1e20;
inline bool is_parked(const ParticleRecord& record) { return record.position.x >= parking_distance; }
inline void park(ParticleRecord& record, std::int64_t id) {
  record.position = {parking_distance * static_cast<double>(id + 1), 0.0, 0.0};
  record.velocity = {};
  record.spin = {};
}

}  // namespace repose
