#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace repose {

/// What a rank spends its time on.
enum class Stage { pair_contacts, wall_contacts, integration, lists, ghosts, agreement, heat, output };
inline constexpr std::array<const char*, 8> stage_names = {"pair_contacts", "wall_contacts", "integration", "lists",
                                                           "ghosts",        "agreement",     "heat",        "output"};

/// Adds up the time of each stage on one rank: every moment belongs to the stage that was entered last. One read of the
/// wall clock per change, tens of nanoseconds. Where ranks share a core, wall time says nothing of a rank's own work,
/// so every 32nd step is watched by the clock of the processor, too, which takes a microsecond to read.
class StageClock {
 public:
  using Seconds = std::array<double, stage_names.size()>;

  void begin_step() {
    if (watches_) read_processor();
    watches_ = steps_ % watch_every == 0;
    ++steps_;
    if (!watches_) return;
    ++watched_;
    processor_since_ = processor_seconds();
  }
  void enter(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    seconds_ = seconds(now);
    since_ = now;
    if (watches_) read_processor();
    stage_ = stage;
  }
  /// Wall time in s per stage up to `now`.
  Seconds seconds(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now()) const {
    Seconds seconds = seconds_;
    seconds[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    return seconds;
  }
  /// Processor time in s per stage of all steps, from those that were watched.
  Seconds estimated_cpu_seconds() const {
    Seconds seconds = processor_;
    for (double& s : seconds) s *= watched_ > 0 ? static_cast<double>(steps_) / static_cast<double>(watched_) : 0.0;
    return seconds;
  }

 private:
  static constexpr std::int64_t watch_every = 32;  // steps

  static double processor_seconds() {
    std::timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  void read_processor() {
    const double now = processor_seconds();
    processor_[static_cast<std::size_t>(stage_)] += now - processor_since_;
    processor_since_ = now;
  }

  Seconds seconds_{};
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  Stage stage_ = Stage::output;
  Seconds processor_{};  ///< of the watched steps
  double processor_since_ = 0.0;
  bool watches_ = false;
  std::int64_t steps_ = 0;
  std::int64_t watched_ = 0;
};

}  // namespace repose
