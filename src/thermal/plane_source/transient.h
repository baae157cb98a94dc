#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thermal/tool_input.h"

namespace repose::thermal {

/// What a sensor has recorded: its mean rise of temperature over time. The heating begins at time 0; what was recorded
/// before shows the drift.
struct Transient {
  std::vector<double> time;       ///< s, > 0, ascending
  std::vector<double> rise;       ///< K over the temperature at time 0
  std::vector<double> power;      ///< W at those times; empty when the file does not tell
  std::vector<double> idle_time;  ///< s, <= 0
  std::vector<double> idle_rise;  ///< K
};

/// How a resistance becomes a temperature (thesis 5.2).
struct Thermometer {
  double resistance = 0.0;   ///< ohm at time 0; 0: unknown
  double coefficient = 0.0;  ///< relative change of resistance with temperature, 1/K
};

/// A transient from CSV with the header `time,temperature` or `time,resistance`, either with a third column `power`:
/// s, K or ohm, W. Blank lines and lines that begin with # are skipped. DeckError as `file:line: what` when a line is
/// wrong or the times do not ascend.
Transient parse_transient(const DataFile& file, const Thermometer& thermometer);

/// The same as CSV text with the header `time,temperature,power`; `power` in W goes into the rows after time 0.
std::string transient_csv(const Transient& transient, double power);

}  // namespace repose::thermal
