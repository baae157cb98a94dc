#include "output/snapshot_series.h"

#include <algorithm>

#include <nlohmann/json.hpp>

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
  nlohmann::ordered_json list = {{"file-series-version", "1.0"}, {"files", nlohmann::ordered_json::array()}};
  for (const File& file : files_) list["files"].push_back({{"name", file.name}, {"time", file.time_s}});
  write_text_file(path_, list.dump(1) + "\n");
}

}  // namespace repose
