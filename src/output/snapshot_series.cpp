#include "output/snapshot_series.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/atomic_file.h"

namespace repose {

SnapshotSeries::SnapshotSeries(std::string path) : path_(std::move(path)) {}

void SnapshotSeries::add(const std::string& name, double time_s) {
  const auto listed = std::ranges::find(files_, name, &File::name);
  if (listed != files_.end()) {
    listed->time_s = time_s;
  } else {
    files_.push_back({name, time_s});
  }
  rewrite();
}

void SnapshotSeries::rewrite() const {
  if (files_.empty()) {
    std::error_code error;
    std::filesystem::remove(path_, error);
    if (error) throw FileError(fmt::format("{}: cannot be removed: {}", path_, error.message()));
    return;
  }
  nlohmann::ordered_json list = {{"file-series-version", "1.0"}, {"files", nlohmann::ordered_json::array()}};
  for (const File& file : files_) list["files"].push_back({{"name", file.name}, {"time", file.time_s}});
  write_text_file(path_, list.dump(1) + "\n");
}

}  // namespace repose
