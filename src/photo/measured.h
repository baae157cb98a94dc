#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace repose::photo {

/// The mean of several photographs, and how well it is known.
struct Measured {
  double mean = 0.0;
  double scatter = 0.0;     ///< standard deviation between the photographs, or what stands for it where there is one
  double systematic = 0.0;  ///< what all photographs share: threshold and scale
  double error = 0.0;       ///< of the mean
  /// Standard deviation of one photograph, such that over the root of their number it is `error`.
  double deviation = 0.0;
};

/// `values` of the photographs (at least one); `single` stands for their scatter where there is one only.
Measured measured(const std::vector<double>& values, double systematic, double single);

/// Its figures but for the deviation; their keys end with `unit`, such as "_deg".
nlohmann::ordered_json json_of(const Measured& value, const std::string& unit = "");

}  // namespace repose::photo
