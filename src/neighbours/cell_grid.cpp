#include "neighbours/cell_grid.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace repose {
namespace {

constexpr std::int64_t cells_per_axis = 1 << 21;  // three coordinates fit one 64-bit key

std::uint64_t scramble(std::uint64_t key) {  // the finaliser of SplitMix64 (Steele, Lea, Flood 2014)
  key ^= key >> 30;
  key *= 0xbf58476d1ce4e5b9ULL;
  key ^= key >> 27;
  return key * 0x94d049bb133111ebULL;
}

}  // namespace

std::int64_t CellGrid::coordinate(double offset) const {
  const double cell = std::floor(offset * inverse_size_);
  return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(cells_per_axis - 1)));
}

std::uint64_t CellGrid::key(const Cell& c) {
  return (static_cast<std::uint64_t>(c.x) << 42) | (static_cast<std::uint64_t>(c.y) << 21) |
         static_cast<std::uint64_t>(c.z);
}

CellGrid::CellGrid(std::span<const ParticleRecord> particles, double cell_size) : inverse_size_(1.0 / cell_size) {
  if (particles.empty()) return;
  origin_ = particles[0].position;
  for (const ParticleRecord& p : particles) {
    origin_ = {std::min(origin_.x, p.position.x), std::min(origin_.y, p.position.y), std::min(origin_.z, p.position.z)};
  }
  std::vector<std::pair<std::uint64_t, std::int32_t>> order(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    order[i] = {key(cell_of(particles[i].position)), static_cast<std::int32_t>(i)};
  }
  std::sort(order.begin(), order.end());

  sorted_.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted_[k] = order[k].second;
    if (k > 0 && order[k].first == order[k - 1].first) continue;
    keys_.push_back(order[k].first);
    begin_.push_back(static_cast<std::int32_t>(k));
  }
  begin_.push_back(static_cast<std::int32_t>(order.size()));

  table_.assign(std::bit_ceil(2 * keys_.size()), -1);
  mask_ = table_.size() - 1;
  for (std::size_t run = 0; run < keys_.size(); ++run) {
    std::uint64_t slot = scramble(keys_[run]) & mask_;
    while (table_[slot] >= 0) slot = (slot + 1) & mask_;
    table_[slot] = static_cast<std::int32_t>(run);
  }
}

std::int32_t CellGrid::find(const Cell& cell) const {
  if (table_.empty()) return -1;
  const std::uint64_t wanted = key(cell);
  for (std::uint64_t slot = scramble(wanted) & mask_;; slot = (slot + 1) & mask_) {
    const std::int32_t run = table_[slot];
    if (run < 0 || keys_[static_cast<std::size_t>(run)] == wanted) return run;
  }
}

}  // namespace repose
