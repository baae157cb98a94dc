#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "files/csv_file.h"

namespace repose {

/// Figures over time as a CSV that can be read while the run goes on. For rank 0.
class TimeSeries {
 public:
  using Value = std::variant<double, std::int64_t>;

  /// Creates or empties `path`, or goes on with it (CsvFile); the column names carry their units (time_s,
  /// discharged_mass_kg). Throws FileError.
  TimeSeries(std::string path, const std::vector<std::string>& columns, Existing existing = Existing::replace);

  /// Appends one row, a value per column in their order, doubles in the shortest form that reads back exactly. Throws
  /// FileError when it cannot be written, std::logic_error on a wrong number of values.
  void append(std::span<const Value> row);
  void sync() { file_.sync(); }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("file", self.file_);
  }

 private:
  std::size_t columns_;
  CsvFile file_;
};

}  // namespace repose
