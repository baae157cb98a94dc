#include "photo/measured.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace repose::photo {

Measured measured(const std::vector<double>& values, double systematic, double single) {
  Measured result{.scatter = single, .systematic = systematic};
  const auto n = static_cast<double>(values.size());
  for (const double v : values) result.mean += v / n;
  if (values.size() > 1) {
    double sum = 0.0;
    for (const double v : values) sum += (v - result.mean) * (v - result.mean);
    result.scatter = std::sqrt(sum / (n - 1.0));
  }
  result.error = std::sqrt(result.scatter * result.scatter / n + systematic * systematic);
  result.deviation = std::sqrt(n) * result.error;
  return result;
}

nlohmann::ordered_json json_of(const Measured& value, const std::string& unit) {
  return {{"mean" + unit, value.mean},
          {"scatter" + unit, value.scatter},
          {"systematic" + unit, value.systematic},
          {"error" + unit, value.error}};
}

}  // namespace repose::photo
