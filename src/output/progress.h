#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace repose {

/// What a progress line tells.
struct ProgressState {
  std::int64_t step = 0;
  double time_s = 0.0;
  double share_done = 0.0;  ///< of the longest the run can take, 0 to 1
  std::string phase;
  std::int64_t particles = 0;
  std::int64_t contacts = 0;
  double kinetic_energy_j = 0.0;  ///< mean per particle
  double particle_steps_per_second = 0.0;
  double imbalance = 1.0;              ///< cost of the busiest rank over the mean
  std::optional<double> seconds_left;  ///< if every phase takes its longest
};

/// A time span as a person says it: "45 s", "3 min", "2 h 05 min", "4 d 06 h".
std::string duration_text(double seconds);

/// A count with a prefix of three to four digits: "850", "8.1 k", "12.3 M", "1.2 G".
std::string short_count(double count);

/// One line without its newline, columns aligned from line to line, no carriage return (under mpirun every rank sees a
/// terminal).
std::string progress_line(const ProgressState& state);

}  // namespace repose
