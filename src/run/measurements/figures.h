#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace repose {

/// What measurements give to summary.json, by key; null where a run has no such figure. For rank 0, but for numbers
/// that all ranks know.
using Figures = nlohmann::ordered_json;

/// A number among the figures; empty where it is missing or null.
inline std::optional<double> number_in(const Figures& figures, const std::string& key) {
  const auto found = figures.find(key);
  if (found == figures.end() || !found->is_number()) return {};
  return found->get<double>();
}

}  // namespace repose
