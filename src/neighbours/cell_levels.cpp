#include "neighbours/cell_levels.h"

namespace repose {
namespace {

/// Indices of the particles by level.
std::vector<std::vector<std::int32_t>> levels_of(std::span<const double> reach) {
  constexpr int highest = 40;
  const double smallest = *std::min_element(reach.begin(), reach.end());
  std::vector<std::vector<std::int32_t>> levels;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const auto level = static_cast<std::size_t>(std::clamp(std::ilogb(reach[i] / smallest), 0, highest));
    if (level >= levels.size()) levels.resize(level + 1);
    levels[level].push_back(static_cast<std::int32_t>(i));
  }
  return levels;
}

}  // namespace

std::vector<CellMember> sort_by_cell(const Cells& cells, std::span<const ParticleRecord> particles,
                                     std::span<const std::int32_t> chosen) {
  std::vector<CellMember> members;
  members.reserve(chosen.size());
  for (const std::int32_t i : chosen) members.push_back({cells.of(particles[static_cast<std::size_t>(i)].position), i});
  std::sort(members.begin(), members.end(), [](const CellMember& a, const CellMember& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.particle < b.particle;
  });
  return members;
}

std::vector<CellLevel> sort_into_levels(std::span<const ParticleRecord> particles, std::span<const double> reach) {
  std::vector<CellLevel> levels;
  if (reach.empty()) return levels;
  Vec3 origin = particles[0].position;
  for (const ParticleRecord& p : particles) {
    origin = {std::min(origin.x, p.position.x), std::min(origin.y, p.position.y), std::min(origin.z, p.position.z)};
  }
  for (const std::vector<std::int32_t>& chosen : levels_of(reach)) {
    if (chosen.empty()) continue;
    double longest = 0.0;
    for (const std::int32_t i : chosen) longest = std::max(longest, reach[static_cast<std::size_t>(i)]);
    const Cells cells = {origin, 1.0 / with_rounding(2.0 * longest)};
    levels.push_back({cells, longest, sort_by_cell(cells, particles, chosen)});
  }
  return levels;
}

}  // namespace repose
