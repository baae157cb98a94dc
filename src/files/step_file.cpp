#include "files/step_file.h"

#include <charconv>

#include <fmt/core.h>

namespace repose {

std::string file_of_step(std::string_view prefix, std::int64_t step, std::string_view ending) {
  return fmt::format("{}{:010d}{}", prefix, step, ending);
}

std::optional<std::int64_t> step_of_file(std::string_view name, std::string_view prefix, std::string_view ending) {
  if (!name.starts_with(prefix)) return {};
  std::int64_t step = 0;
  std::from_chars(name.data() + prefix.size(), name.data() + name.size(), step);
  if (name != file_of_step(prefix, step, ending)) return {};
  return step;
}

}  // namespace repose
