#include "output/trace.h"

#include <utility>

#include <fmt/core.h>

#include "output/vector_rows.h"

namespace repose {

std::vector<TraceRow> gather_trace_rows(const Communicator& comm, const ParticleTable& particles) {
  const auto id = comm.gather(particles.id);
  const auto position = comm.gather(particles.position);
  const auto velocity = comm.gather(particles.velocity);
  const auto angular_velocity = comm.gather(particles.angular_velocity);
  std::vector<TraceRow> rows;
  rows.reserve(id.size());
  for (std::size_t i = 0; i < id.size(); ++i) {
    rows.push_back({id[i], vector_at(position, i), vector_at(velocity, i), vector_at(angular_velocity, i)});
  }
  return rows;
}

Trace::Trace(std::string path, Existing existing)
    : file_(std::move(path), "step,id,x,y,z,vx,vy,vz,wx,wy,wz", existing) {}

void Trace::append(std::int64_t step, std::span<const TraceRow> rows) {
  std::string lines;
  for (const TraceRow& row : rows) {
    lines += fmt::format("{},{}", step, row.id);
    for (const Vec3& v : {row.position, row.velocity, row.angular_velocity}) {
      lines += ',' + shortest_text(v.x) + ',' + shortest_text(v.y) + ',' + shortest_text(v.z);
    }
    lines += '\n';
  }
  file_.append(lines);
}

}  // namespace repose
