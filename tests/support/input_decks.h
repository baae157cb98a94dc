#pragma once

#include <filesystem>
#include <string>

namespace repose::test {

/// Whether a file of input/ is the deck of a run; the others are read by commands of their own.
inline bool is_deck_of_a_run(const std::filesystem::path& path) {
  if (path.extension() != ".toml") return false;
  const std::string name = path.filename().string();
  for (const char* other : {"calibrate_", "photo_", "sensitivity_", "thermal_", "validation"}) {
    if (name.starts_with(other)) return false;
  }
  return true;
}

}  // namespace repose::test
