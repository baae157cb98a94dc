#include "output/checkpoint_reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/file_seal.h"
#include "files/hdf5_reader.h"
#include "output/vector_rows.h"

namespace repose {
namespace {

ContactHistory history_at(std::span<const double> values, std::size_t row) {
  return {vector_at(values, row, 6, 0), vector_at(values, row, 6, 3)};
}

bool is_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

class Reader {
 public:
  Reader(const Hdf5Reader& file, int rank, int ranks) : file_(file), rank_(rank), ranks_(ranks) {}

  CheckpointHeader header() const {
    if (file_.read_integer("repose_checkpoint") != checkpoint_format) {
      throw FileError(fmt::format("{}: a checkpoint of another format; this version reads format {}", file_.name(),
                                  checkpoint_format));
    }
    CheckpointHeader h;
    h.step = file_.read_integer("step");
    h.time_s = file_.read_real("time_s");
    h.state_hash = file_.read_text("state_hash");
    h.deck = file_.read_text("deck");
    h.build.version = file_.read_text("build_version");
    h.build.commit = file_.read_text("build_commit");
    const auto state = file_.read_rows<std::uint8_t>("/state", 1, 0, file_.rows("/state"));
    h.state.assign(state.begin(), state.end());
    return h;
  }

  /// This rank's share of the particles.
  void read(Particles& p) {
    const std::int64_t rows = file_.rows("/particles/id");
    begin_ = rows * rank_ / ranks_;
    end_ = rows * (rank_ + 1) / ranks_;
    p.id = mine<std::int64_t>("/particles/id", 1);
    p.material = mine<std::int32_t>("/particles/material", 1);
    const auto position = finite("/particles/position", 3);
    const auto velocity = finite("/particles/velocity", 3);
    const auto spin = finite("/particles/spin", 3);
    const auto radius = finite("/particles/radius", 1);
    const auto force = mine<std::int64_t>("/particles/force_sum", 3);
    const auto torque = mine<std::int64_t>("/particles/torque_sum", 3);
    for (std::size_t i = 0; i < p.id.size(); ++i) {
      if (!(radius[i] > 0.0)) throw FileError(fmt::format("{}: particle {} has no radius", file_.name(), p.id[i]));
      p.record.push_back({vector_at(position, i), radius[i], vector_at(velocity, i), 0.0, vector_at(spin, i), 0.0});
      ForceSum& sum = p.sum.emplace_back();
      std::copy_n(&force[3 * i], 3, sum.force);
      std::copy_n(&torque[3 * i], 3, sum.torque);
    }
    if (file_.has("/particles/heat")) p.heat = mine<std::int64_t>("/particles/heat", 1);
    p.owned = p.id.size();
  }

  /// The contacts of these particles. Every rank needs to know how many those of the ranks before it have.
  template <class T, class Make>
  void read(Csr<T>& contacts, const std::string& counted, const std::string& group, const Make& make) {
    const auto counts = file_.read_rows<std::int64_t>(counted, 1, 0, end_);
    const bool sane = std::all_of(counts.begin(), counts.end(), [](std::int64_t n) { return n >= 0 && n < 1 << 20; });
    if (!sane) throw FileError(fmt::format("{}: {} holds impossible counts", file_.name(), counted));
    const auto first = std::accumulate(counts.begin(), counts.begin() + begin_, std::int64_t{0});
    const auto last = std::accumulate(counts.begin() + begin_, counts.end(), first);
    contacts.items = make(group, first, last);
    contacts.offset = {0};
    for (std::int64_t i = begin_; i < end_; ++i) {
      contacts.offset.push_back(contacts.offset.back() + static_cast<std::size_t>(counts[static_cast<std::size_t>(i)]));
    }
  }

  std::vector<PairMemory> pairs(const std::string& group, std::int64_t begin, std::int64_t end) const {
    const auto partner = file_.read_rows<std::int64_t>(group + "/partner", 1, begin, end);
    const auto history = finite(group + "/history", 6, begin, end);
    std::vector<PairMemory> items;
    for (std::size_t k = 0; k < partner.size(); ++k) items.push_back({partner[k], history_at(history, k)});
    return items;
  }

  std::vector<WallMemory> walls(const std::string& group, std::int64_t begin, std::int64_t end) const {
    const auto wall = file_.read_rows<std::int32_t>(group + "/wall", 1, begin, end);
    const auto feature = file_.read_rows<std::int32_t>(group + "/feature", 1, begin, end);
    const auto history = finite(group + "/history", 6, begin, end);
    std::vector<WallMemory> items;
    for (std::size_t k = 0; k < wall.size(); ++k) items.push_back({wall[k], feature[k], history_at(history, k)});
    return items;
  }

 private:
  template <class T>
  std::vector<T> mine(const std::string& dataset, int columns) const {
    return file_.read_rows<T>(dataset, columns, begin_, end_);
  }
  std::vector<double> finite(const std::string& dataset, int columns) const {
    return finite(dataset, columns, begin_, end_);
  }
  std::vector<double> finite(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end) const {
    std::vector<double> values = file_.read_rows<double>(dataset, columns, begin, end);
    if (!is_finite(values)) throw FileError(fmt::format("{}: {} is not finite everywhere", file_.name(), dataset));
    return values;
  }

  const Hdf5Reader& file_;
  int rank_;
  int ranks_;
  std::int64_t begin_ = 0;  ///< of this rank's particles
  std::int64_t end_ = 0;
};

/// The share of one of so many ranks.
Checkpoint read(const Hdf5Reader& file, int rank, int ranks) {
  Checkpoint checkpoint;
  Reader reader(file, rank, ranks);
  checkpoint.header = reader.header();
  reader.read(checkpoint.particles);
  reader.read(checkpoint.memory.pairs, "/particles/pair_contacts", "/pair_contacts",
              [&](auto&&... at) { return reader.pairs(at...); });
  reader.read(checkpoint.memory.walls, "/particles/wall_contacts", "/wall_contacts",
              [&](auto&&... at) { return reader.walls(at...); });
  return checkpoint;
}

}  // namespace

Checkpoint read_checkpoint(const Communicator& comm, const std::string& path) {
  check_seal(comm, path);
  Checkpoint checkpoint;
  agree_after(comm, [&] { checkpoint = read(Hdf5Reader(path), comm.rank(), comm.size()); });
  return checkpoint;
}

Checkpoint parse_checkpoint(const std::string& bytes, const std::string& file) {
  return read(Hdf5Reader::of_bytes(bytes, file, "checkpoint"), 0, 1);
}

}  // namespace repose
