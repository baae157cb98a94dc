#include "run/checkpoints.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "files/step_file.h"

namespace repose {
namespace {

constexpr const char* prefix = "checkpoint_";
constexpr std::size_t kept = 2;

/// Collective.
std::vector<std::string> shared_list(const Communicator& comm, const std::string& directory) {
  std::string list;
  agree_after_root(comm, [&] {
    for (const std::string& path : checkpoints_in(directory)) list += path + '\n';
  });
  comm.broadcast(list);
  std::vector<std::string> paths;
  for (std::size_t at = 0; at < list.size(); at = list.find('\n', at) + 1) {
    paths.push_back(list.substr(at, list.find('\n', at) - at));
  }
  return paths;
}

}  // namespace

Checkpoints::Checkpoints(const OutputDeck& deck, std::string directory)
    : directory_(std::move(directory)),
      every_(deck.checkpoint_steps),
      minutes_(deck.checkpoint_minutes),
      last_(WallClock::now()) {}

std::int64_t Checkpoints::steps_to_next(std::int64_t step) const {
  return every_ > 0 ? every_ - step % every_ : std::numeric_limits<std::int64_t>::max();
}

bool Checkpoints::is_due_by_time() const { return minutes_ > 0.0 && seconds_since(last_) >= 60.0 * minutes_; }

void Checkpoints::write(const Communicator& comm, const CheckpointHeader& header, const Particles& particles,
                        const ContactMemory& memory) {
  const WallClock::time_point start = WallClock::now();
  const std::string path = fmt::format("{}/{}", directory_, file_of_step(prefix, header.step));
  write_checkpoint(comm, path, header, particles, memory);
  agree_after_root(comm, [&] {
    std::vector<std::string> all = checkpoints_in(directory_);
    // What is of a later step is damaged, or the run would have gone on from there: it must not count.
    std::erase_if(all, [&](const std::string& other) {
      const bool is_later = step_of_file(std::filesystem::path(other).filename().string(), prefix) > header.step;
      return is_later && std::filesystem::remove(other);
    });
    for (std::size_t k = kept; k < all.size(); ++k) std::filesystem::remove(all[k]);
  });
  last_ = WallClock::now();
  const double seconds = seconds_since(start);
  cost_ = {cost_.written + 1, cost_.seconds + seconds, std::max(cost_.longest, seconds)};
}

std::vector<std::string> checkpoints_in(const std::string& directory) {
  std::vector<std::pair<std::int64_t, std::string>> found;
  if (!std::filesystem::is_directory(directory)) return {};
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (const auto step = step_of_file(entry.path().filename().string(), prefix)) {
      found.emplace_back(*step, entry.path().string());
    }
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> paths;
  for (const auto& [step, path] : found) paths.push_back(path);
  return paths;
}

void remove_checkpoints(const std::string& directory) {
  for (const std::string& path : checkpoints_in(directory)) std::filesystem::remove(path);
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name == partial_path(name.substr(0, name.rfind('.')))) {
      std::filesystem::remove(entry.path());
    }
  }
}

std::optional<FoundCheckpoint> newest_checkpoint(const Communicator& comm, const std::string& directory,
                                                 const RunLog& log) {
  const std::vector<std::string> paths = shared_list(comm, directory);
  for (const std::string& path : paths) {
    try {
      return FoundCheckpoint{path, read_checkpoint(comm, path)};
    } catch (const FileError& error) {
      if (comm.is_root()) log.warn(fmt::format("{}; skipped", error.what()));
    }
  }
  if (paths.empty()) return {};
  throw FileError(fmt::format("{}: no checkpoint is whole; remove checkpoint_*.hdf to begin anew", directory));
}

}  // namespace repose
