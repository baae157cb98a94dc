#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/particles/particles.h"

namespace repose {

/// A distance and more than what rounding could add to it.
inline double with_rounding(double distance) { return distance * (1.0 + 1e-9); }

/// Cubic cells, numbered so that x comes before y before z. Those at the ends hold all that lies beyond; the outermost
/// stay empty, so that every other has neighbours.
struct Cells {
  static constexpr int axis_bits = 21;  ///< three coordinates fit one 64-bit number
  static constexpr std::uint64_t x_step = std::uint64_t{1} << (2 * axis_bits);
  static constexpr std::uint64_t y_step = std::uint64_t{1} << axis_bits;

  Vec3 origin;
  double inverse_width;  ///< 1/m

  std::uint64_t along(double offset) const {
    constexpr double last = static_cast<double>(y_step - 2);
    return static_cast<std::uint64_t>(std::clamp(std::floor(offset * inverse_width) + 1.0, 1.0, last));
  }
  std::uint64_t of(const Vec3& p) const {
    return along(p.x - origin.x) * x_step + along(p.y - origin.y) * y_step + along(p.z - origin.z);
  }
};

struct CellMember {
  std::uint64_t cell;
  std::int32_t particle;
};

/// Particles with reaches alike, in the order of the cells in which they are.
struct CellLevel {
  Cells cells;     ///< as wide as two of the longest reach
  double longest;  ///< m
  std::vector<CellMember> members;
};

/// The members in the order of the cells they have, then of the particles.
std::vector<CellMember> sort_by_cell(const Cells& cells, std::span<const ParticleRecord> particles,
                                     std::span<const std::int32_t> chosen);

/// The particles told apart by their reach (m, one entry each) into levels, each at most twice that of the level below.
/// Levels without particles are left out; the highest holds all that reach farther still.
std::vector<CellLevel> sort_into_levels(std::span<const ParticleRecord> particles, std::span<const double> reach);

/// Calls visit(particle) for the members of a level that may be within `reach` (m) and their own of a position, and for
/// others.
template <class Visit>
void for_each_candidate(const CellLevel& level, const Vec3& position, double reach, Visit&& visit) {
  const double range = with_rounding(reach + level.longest);
  const Vec3 offset = position - level.cells.origin;
  const auto first = [&](double x) { return level.cells.along(x - range); };
  const auto last = [&](double x) { return level.cells.along(x + range); };
  const std::uint64_t columns = (last(offset.x) - first(offset.x) + 1) * (last(offset.y) - first(offset.y) + 1);
  if (columns >= level.members.size()) {
    for (const CellMember& m : level.members) visit(m.particle);
    return;
  }
  for (std::uint64_t x = first(offset.x); x <= last(offset.x); ++x) {
    for (std::uint64_t y = first(offset.y); y <= last(offset.y); ++y) {
      const std::uint64_t column = x * Cells::x_step + y * Cells::y_step;
      const std::uint64_t end = column + last(offset.z);
      auto m = std::lower_bound(level.members.begin(), level.members.end(), column + first(offset.z),
                                [](const CellMember& member, std::uint64_t cell) { return member.cell < cell; });
      for (; m != level.members.end() && m->cell <= end; ++m) visit(m->particle);
    }
  }
}

}  // namespace repose
