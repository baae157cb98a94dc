#pragma once

#include <string>
#include <vector>

namespace repose {

/// The list of snapshots with their times that ParaView opens as one animation (ParaView's file-series-version 1.0,
/// run.hdf.series). For rank 0.
class SnapshotSeries {
 public:
  /// `path` lies in the folder of the snapshots; nothing is written yet.
  explicit SnapshotSeries(std::string path);

  /// Adds the snapshot with this file name (no folder) and rewrites the list, whole or not at all. A snapshot that is
  /// listed already gets the new time. Throws FileError.
  void add(const std::string& name, double time_s);

  /// Rewrites the list as it is; removes it when it is empty. For a run that goes on behind snapshots that it had made
  /// and will make again. Throws FileError.
  void rewrite() const;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("files", self.files_);
  }

 private:
  struct File {
    std::string name;
    double time_s = 0.0;

    template <class Self, class Visitor>
    static void describe_state(Self& self, Visitor& v) {
      v("name", self.name);
      v("time_s", self.time_s);
    }
  };
  std::string path_;
  std::vector<File> files_;
};

}  // namespace repose
