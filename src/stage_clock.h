#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace repose {

/// What a rank spends its time on.
enum class Stage { pair_contacts, wall_contacts, integration, lists, ghosts, agreement, output };
inline constexpr std::array<const char*, 7> stage_names = {"pair_contacts", "wall_contacts", "integration", "lists",
                                                           "ghosts",        "agreement",     "output"};

/// Adds up the wall time of each stage on one rank: every moment belongs to the stage that was entered last. One read
/// of the clock per change, tens of nanoseconds.
class StageClock {
 public:
  void enter(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    seconds_ = seconds(now);
    since_ = now;
    stage_ = stage;
  }
  /// Seconds per stage up to `now`.
  std::array<double, stage_names.size()> seconds(
      std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now()) const {
    auto seconds = seconds_;
    seconds[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    return seconds;
  }

 private:
  std::array<double, stage_names.size()> seconds_{};
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  Stage stage_ = Stage::output;
};

}  // namespace repose
