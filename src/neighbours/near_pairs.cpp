#include "neighbours/near_pairs.h"

#include <algorithm>

// A level (cell_levels.h) has cells as wide as two of its reaches, so that a particle finds all partners of its own
// level in the 3 x 3 x 3 cells about its own place. Those of a higher level it finds in cells as wide as a reach of
// each together: a large ball in fine grains does not search for them, they find the ball.
//
// No table holds the cells: members and searchers of a level are sorted by cell, x before y before z. For each of the
// 3 x 3 columns of cells along z the partners of successive searchers then lie in successive places, so that one pass
// with a cursor per column finds them.

namespace repose {
namespace {

struct Sorted {
  std::uint64_t cell;
  std::int32_t index;
  double reach;
  Vec3 position;
};

constexpr std::uint64_t x_step = Cells::x_step;
constexpr std::uint64_t y_step = Cells::y_step;

std::vector<Sorted> with_reaches(std::span<const CellMember> members, std::span<const ParticleRecord> particles,
                                 std::span<const double> reach) {
  std::vector<Sorted> sorted;
  sorted.reserve(members.size());
  for (const auto& [cell, i] : members) {
    const auto k = static_cast<std::size_t>(i);
    sorted.push_back({cell, i, reach[k], particles[k].position});
  }
  return sorted;
}

bool near(const Sorted& a, const Sorted& b) {
  const double limit = a.reach + b.reach;
  return squared_norm(a.position - b.position) < limit * limit;
}

/// Calls visit for the near pairs of each searcher with the members in three cells along z of each column; the columns
/// are given by their distance from the searcher's own.
template <class Visit>
void sweep(std::span<const Sorted> searchers, std::span<const Sorted> members, std::span<const std::uint64_t> columns,
           const Visit& visit) {
  std::array<std::size_t, 9> cursor = {};
  for (const Sorted& a : searchers) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::uint64_t low = a.cell + columns[c] - 1;
      std::size_t& at = cursor[c];
      while (at < members.size() && members[at].cell < low) ++at;
      for (std::size_t k = at; k < members.size() && members[k].cell <= low + 2; ++k) {
        if (near(a, members[k])) visit(a, members[k]);
      }
    }
  }
}

/// The near pairs among the members of a level: each with those behind it in its own column, and with the four columns
/// that come later in the order.
template <class Visit>
void sweep_own(std::span<const Sorted> members, const Visit& visit) {
  constexpr std::array<std::uint64_t, 4> later = {y_step, x_step - y_step, x_step, x_step + y_step};
  for (std::size_t a = 0; a < members.size(); ++a) {
    for (std::size_t b = a + 1; b < members.size() && members[b].cell <= members[a].cell + 1; ++b) {
      if (near(members[a], members[b])) visit(members[a], members[b]);
    }
  }
  sweep(members, members, later, visit);
}

constexpr std::array<std::uint64_t, 9> all_columns = {std::uint64_t{0} - x_step - y_step,
                                                      std::uint64_t{0} - x_step,
                                                      std::uint64_t{0} - x_step + y_step,
                                                      std::uint64_t{0} - y_step,
                                                      std::uint64_t{0},
                                                      y_step,
                                                      x_step - y_step,
                                                      x_step,
                                                      x_step + y_step};

std::vector<std::int32_t> particles_of(const CellLevel& level) {
  std::vector<std::int32_t> chosen;
  chosen.reserve(level.members.size());
  for (const CellMember& m : level.members) chosen.push_back(m.particle);
  return chosen;
}

/// Particles of a level that lie within `range` of the members' box, so that they may have a partner there.
std::vector<std::int32_t> searchers_of(const CellLevel& level, std::span<const Sorted> members, double range,
                                       std::span<const ParticleRecord> particles) {
  Vec3 low = members.front().position;
  Vec3 high = low;
  for (const Sorted& m : members) {
    low = {std::min(low.x, m.position.x), std::min(low.y, m.position.y), std::min(low.z, m.position.z)};
    high = {std::max(high.x, m.position.x), std::max(high.y, m.position.y), std::max(high.z, m.position.z)};
  }
  const Vec3 margin = {range, range, range};
  low -= margin;
  high += margin;
  std::vector<std::int32_t> searchers;
  for (const CellMember& m : level.members) {
    const Vec3& p = particles[static_cast<std::size_t>(m.particle)].position;
    if (p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z) {
      searchers.push_back(m.particle);
    }
  }
  return searchers;
}

/// Calls visit for the near pairs between two levels.
template <class Visit>
void sweep_between(const CellLevel& lower, const CellLevel& higher, std::span<const ParticleRecord> particles,
                   std::span<const double> reach, const Visit& visit) {
  const double range = with_rounding(lower.longest + higher.longest);
  const Cells cells = {higher.cells.origin, 1.0 / range};
  const auto sorted = [&](std::span<const std::int32_t> chosen) {
    return with_reaches(sort_by_cell(cells, particles, chosen), particles, reach);
  };
  const std::vector<Sorted> members = sorted(particles_of(higher));
  sweep(sorted(searchers_of(lower, members, range, particles)), members, all_columns, visit);
}

/// In the order of the second, higher index.
std::vector<IndexPair> sort_by_second(const std::vector<IndexPair>& pairs, std::size_t particles) {
  std::vector<std::size_t> next(particles + 1, 0);
  for (const IndexPair& pair : pairs) ++next[static_cast<std::size_t>(pair[1]) + 1];
  for (std::size_t i = 0; i < particles; ++i) next[i + 1] += next[i];
  std::vector<IndexPair> sorted(pairs.size());
  for (const IndexPair& pair : pairs) sorted[next[static_cast<std::size_t>(pair[1])]++] = pair;
  return sorted;
}

}  // namespace

std::vector<IndexPair> near_pairs(std::span<const CellLevel> levels, std::span<const ParticleRecord> particles,
                                  std::span<const double> reach, std::size_t owned) {
  std::vector<IndexPair> pairs;
  const auto visit = [&](const Sorted& a, const Sorted& b) {
    const IndexPair pair = {std::min(a.index, b.index), std::max(a.index, b.index)};
    if (static_cast<std::size_t>(pair[0]) < owned) pairs.push_back(pair);
  };
  for (std::size_t k = 0; k < levels.size(); ++k) {
    sweep_own(with_reaches(levels[k].members, particles, reach), visit);
    for (const CellLevel& lower : levels.first(k)) sweep_between(lower, levels[k], particles, reach, visit);
  }
  return sort_by_second(pairs, particles.size());
}

std::vector<IndexPair> near_pairs(std::span<const ParticleRecord> particles, std::span<const double> reach,
                                  std::size_t owned) {
  return near_pairs(sort_into_levels(particles, reach), particles, reach, owned);
}

std::vector<bool> ghosts_in(std::span<const IndexPair> pairs, std::size_t owned, std::size_t total) {
  std::vector<bool> found(total - owned, false);
  for (const auto& [i, j] : pairs) {
    if (static_cast<std::size_t>(j) >= owned) found[static_cast<std::size_t>(j) - owned] = true;
  }
  return found;
}

void drop_ghosts(const std::vector<bool>& needed, std::size_t owned, std::span<IndexPair> pairs) {
  std::vector<std::int32_t> place(needed.size());
  auto next = static_cast<std::int32_t>(owned);
  for (std::size_t k = 0; k < needed.size(); ++k) place[k] = needed[k] ? next++ : -1;
  for (auto& [i, j] : pairs) {
    if (static_cast<std::size_t>(j) >= owned) j = place[static_cast<std::size_t>(j) - owned];
  }
}

}  // namespace repose
