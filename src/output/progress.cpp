#include "output/progress.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace repose {

std::string duration_text(double seconds) {
  constexpr double longest = 1e9;  // about thirty years: says that nothing is known
  if (!(seconds >= 0.0) || seconds > longest) return "unknown";
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  const std::int64_t minutes = (whole + 59) / 60;
  if (whole < 120) return fmt::format("{} s", whole);
  if (minutes < 120) return fmt::format("{} min", minutes);
  if (minutes < 48 * 60) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  return fmt::format("{} d {:02} h", minutes / (24 * 60), minutes / 60 % 24);
}

std::string short_count(double count) {
  constexpr std::array<std::pair<double, const char*>, 3> prefixes{{{1e9, "G"}, {1e6, "M"}, {1e3, "k"}}};
  for (const auto& [size, prefix] : prefixes) {
    if (count >= 0.99995 * size) return fmt::format("{:.1f} {}", count / size, prefix);
  }
  return fmt::format("{:.0f}", count);
}

std::string progress_line(const ProgressState& state) {
  // Rounded down: 100 % means done.
  const double percent = std::floor(100.0 * state.share_done);
  return fmt::format(
      "step {:>9}  {:>9.4f} s  {:>3.0f} %  phase {:<10}  {:>8} particles  {:>8} contacts  Ek {:>8.2e} J  {:>7} "
      "particle-steps/s  imbalance {:.2f}  {} left",
      state.step, state.time_s, percent, state.phase, state.particles, state.contacts, state.kinetic_energy_j,
      short_count(state.particle_steps_per_second), state.imbalance,
      state.seconds_left ? "at most " + duration_text(*state.seconds_left) : "unknown");
}

}  // namespace repose
