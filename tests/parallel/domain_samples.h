#pragma once

#include "comm/communicator.h"
#include "domain/decomposition.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/particles.h"
#include "support/draw.h"

namespace repose::test {

/// Everything about a particle as a function of its id, so that every rank knows what any other must hold.
struct Sample {
  ParticleRecord record = {};
  std::int32_t material = 0;
};

/// Dense in one corner of the unit cube, thin elsewhere; one in twenty is fast.
inline Sample sample(std::int64_t id) {
  Draw draw(static_cast<std::uint64_t>(id) + 1000);
  const auto clustered = [&] {
    const double u = draw(0.0, 1.0);
    return u * u * u;
  };
  Sample s;
  s.record.position.x = clustered();
  s.record.position.y = clustered();
  s.record.position.z = clustered();
  s.record.radius = draw(0.002, 0.02);
  s.record.velocity = draw.vector(draw(0.0, 1.0) < 0.05 ? 100.0 : 1.0);
  s.record.force_scale = draw(1.0, 2.0);
  s.record.spin = draw.vector(10.0);
  s.record.torque_scale = draw(1.0, 2.0);
  s.material = static_cast<std::int32_t>(draw.below(3));
  return s;
}

inline ContactHistory history_between(std::int64_t a, std::int64_t b) {
  const auto x = static_cast<double>(a + 1);
  const auto y = static_cast<double>(b + 1);
  return {{x, y, x * y}, {-x, 1.0 / y, x - y}};
}

/// Appends one particle with as many memories as its id says.
inline void add_sample(std::int64_t id, Particles& particles, ContactMemory& memory) {
  const Sample s = sample(id);
  particles.record.push_back(s.record);
  particles.id.push_back(id);
  particles.material.push_back(s.material);
  ++particles.owned;
  std::vector<PairMemory> pairs;
  for (std::int64_t k = 1; k <= id % 4; ++k) pairs.push_back({id + k, history_between(id, id + k)});
  std::vector<WallMemory> walls;
  for (std::int32_t k = 0; k < (id + 1) % 3; ++k) {
    walls.push_back({k, static_cast<std::int32_t>(id % 100) + k, history_between(-id, k)});
  }
  memory.pairs.append_row(pairs);
  memory.walls.append_row(walls);
}

/// Ids 0 to count - 1, dealt out among the ranks in turn.
inline Particles dealt_out(const Communicator& comm, std::int64_t count, ContactMemory& memory) {
  Particles particles;
  for (std::int64_t id = comm.rank(); id < count; id += comm.size()) add_sample(id, particles, memory);
  return particles;
}

inline Decomposition bisect(const Communicator& comm, const Particles& particles) {
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < particles.owned; ++i) positions.push_back(particles.record[i].position);
  return Decomposition::bisect(comm, positions, std::vector<std::int64_t>(positions.size(), 1));
}

inline bool same(const ParticleRecord& a, const ParticleRecord& b) {
  return a.position == b.position && a.radius == b.radius && a.velocity == b.velocity &&
         a.force_scale == b.force_scale && a.spin == b.spin && a.torque_scale == b.torque_scale;
}

inline bool same(const ContactHistory& a, const ContactHistory& b) {
  return a.spring == b.spring && a.rolling == b.rolling;
}

}  // namespace repose::test
