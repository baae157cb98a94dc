#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "comm/communicator.h"
#include "output/csv_file.h"
#include "output/particle_table.h"

namespace repose {

/// One particle at one step, SI units.
struct TraceRow {
  std::int64_t id = 0;
  Vec3 position;
  Vec3 velocity;
  Vec3 angular_velocity;
};

/// Collective. All particles in the order of ids on rank 0, nothing elsewhere; for small cases.
std::vector<TraceRow> gather_trace_rows(const Communicator& comm, const ParticleTable& particles);

/// The motion of every particle as a CSV, each number in the shortest form that reads back exactly. For rank 0.
class Trace {
 public:
  /// Creates or empties `path`. Throws FileError.
  explicit Trace(std::string path);

  /// Appends one line per row. Throws FileError.
  void append(std::int64_t step, std::span<const TraceRow> rows);

 private:
  CsvFile file_;
};

}  // namespace repose
