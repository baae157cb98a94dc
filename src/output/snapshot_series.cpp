#include "output/snapshot_series.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "output/atomic_file.h"

namespace repose {

SnapshotSeries::SnapshotSeries(std::string path) : path_(std::move(path)) {}

void SnapshotSeries::add(const std::string& name, double time_s) {
  const auto listed = std::ranges::find(files_, name, &std::pair<std::string, double>::first);
  if (listed != files_.end()) {
    listed->second = time_s;
  } else {
    files_.emplace_back(name, time_s);
  }
  nlohmann::ordered_json list = {{"file-series-version", "1.0"}, {"files", nlohmann::ordered_json::array()}};
  for (const auto& [file, time] : files_) list["files"].push_back({{"name", file}, {"time", time}});
  write_text_file(path_, list.dump(1) + "\n");
}

}  // namespace repose
