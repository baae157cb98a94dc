#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "comm/communicator.h"
#include "output/snapshot.h"

namespace repose {

/// How the rows of a sample lie on the ranks.
enum class Blocks { even, all_on_last, none_on_first };

/// `total` particles with figures that follow from the row alone (tests/regression/read_snapshot.py knows them too).
inline ParticleTable sample_table(const Communicator& comm, std::int64_t total, Blocks blocks = Blocks::even) {
  const auto boundary = [&](std::int64_t rank) -> std::int64_t {
    if (blocks == Blocks::all_on_last) return rank < comm.size() ? 0 : total;
    if (blocks == Blocks::none_on_first && comm.size() > 1)
      return rank == 0 ? 0 : total * (rank - 1) / (comm.size() - 1);
    return total * rank / comm.size();
  };
  ParticleTable table;
  table.total = total;
  table.offset = boundary(comm.rank());
  for (std::int64_t i = table.offset; i < boundary(comm.rank() + 1); ++i) {
    const auto row = static_cast<double>(i);
    table.id.push_back(2 * i + 1);
    table.position.insert(table.position.end(), {row / 3.0, -row / 7.0, 1e-3 * row});
    table.velocity.insert(table.velocity.end(), {0.1 * row, 0.2 * row, -1.0 / (row + 1.0)});
    table.angular_velocity.insert(table.angular_velocity.end(), {1e5 * row, -row, 0.5});
    table.radius.push_back(1e-4 + 1e-9 * row);
    table.mass.push_back(1e-8 * (row + 1.0));
    table.material.push_back(static_cast<std::int32_t>(i % 2));
  }
  return table;
}

inline SnapshotHeader sample_header(std::int64_t inside) {
  SnapshotHeader header;
  header.step = 120000;
  header.time_s = 0.6;
  header.deck = "# " + std::string(100000, 'x') + "\ntitle = \"Grieß\"\n";  // longer than an HDF5 object header may be
  header.build = build_info("avx2");
  header.state_hash = "0123456789abcdef";
  header.inserted = inside + 5;
  header.inside = inside;
  header.left = 5;
  header.materials = {"glass", "steel"};
  return header;
}

inline std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// A folder of this test on every rank, empty at the start, removed at the end. Collective.
class ScratchFolder {
 public:
  ScratchFolder(const Communicator& comm, const std::string& name) : comm_(comm) {
    path_ = (std::filesystem::temp_directory_path() / (name + "." + std::to_string(comm.size()))).string();
    std::int64_t process = ::getpid();
    comm.broadcast(process);
    path_ += "." + std::to_string(process);
    if (comm.is_root()) std::filesystem::create_directories(path_);
    comm.barrier();
  }
  ~ScratchFolder() {
    comm_.barrier();
    if (comm_.is_root()) std::filesystem::remove_all(path_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  const Communicator& comm_;
  std::string path_;
};

}  // namespace repose
