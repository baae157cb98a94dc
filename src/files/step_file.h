#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace repose {

/// The name of a file that belongs to a step: "run_0000012000.hdf" for the prefix "run_".
std::string file_of_step(std::string_view prefix, std::int64_t step, std::string_view ending = ".hdf");

/// The step that such a name tells; empty for other names.
std::optional<std::int64_t> step_of_file(std::string_view name, std::string_view prefix,
                                         std::string_view ending = ".hdf");

}  // namespace repose
