#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "comm/communicator.h"
#include "files/csv_file.h"
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
  /// Creates or empties `path`, or goes on with it (CsvFile). Throws FileError.
  explicit Trace(std::string path, Existing existing = Existing::replace);

  /// Appends one line per row. Throws FileError.
  void append(std::int64_t step, std::span<const TraceRow> rows);
  void sync() { file_.sync(); }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("file", self.file_);
  }

 private:
  CsvFile file_;
};

}  // namespace repose
