#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

/// What all JSON results have in common.
namespace repose {

/// The file's text. Texts in it come from decks and file systems: bytes that are no UTF-8 must not cost the results.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

/// null for what is not there or is no finite number, which JSON does not know.
nlohmann::ordered_json json_number(std::optional<double> value);

}  // namespace repose
