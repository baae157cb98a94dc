#include "output/collect_particles.h"

#include <algorithm>

#include "comm/buffer.h"
#include "output/vector_rows.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

struct Row {
  std::int64_t id;
  ParticleRecord record;
  double temperature;  ///< K, 0 without heat
  std::int32_t material;
};

}  // namespace

void append_row(ParticleTable& table, std::int64_t id, const ParticleRecord& record, std::int32_t material,
                const MaterialTable& materials) {
  table.id.push_back(id);
  append_vector(table.position, record.position);
  append_vector(table.velocity, record.velocity);
  append_vector(table.angular_velocity, record.spin);
  table.radius.push_back(record.radius);
  table.mass.push_back(sphere_mass(record.radius, materials[static_cast<std::size_t>(material)].density));
  table.material.push_back(materials.solid(material));
}

ParticleTable collect_particles(const Communicator& comm, const MaterialTable& materials, const Particles& particles,
                                std::int64_t inserted, const HeatState* heat) {
  std::vector<std::vector<char>> send(static_cast<std::size_t>(comm.size()));
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) continue;
    const std::int64_t rank = particles.id[i] * comm.size() / std::max<std::int64_t>(inserted, 1);
    Row row{particles.id[i], particles.record[i], heat != nullptr ? heat->temperature(particles, i) : 0.0,
            particles.material[i]};
    row.record.position = particles.position(i);
    PackBuffer(send[static_cast<std::size_t>(rank)]).put(row);
  }
  std::vector<Row> rows;
  for (const std::vector<char>& bytes : comm.exchange(send)) {
    for (UnpackBuffer buffer(bytes); !buffer.at_end();) rows.push_back(buffer.get<Row>());
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.id < b.id; });

  ParticleTable table;
  const auto count = static_cast<std::int64_t>(rows.size());
  table.offset = comm.exclusive_sum(count);
  table.total = comm.sum(count);
  table.has_temperature = heat != nullptr;
  for (const Row& row : rows) {
    append_row(table, row.id, row.record, row.material, materials);
    if (heat != nullptr) table.temperature.push_back(row.temperature);
  }
  return table;
}

}  // namespace repose
