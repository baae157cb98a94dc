#include "scene/insertion/sphere_grid.h"

#include <algorithm>

namespace repose {

std::size_t SphereGrid::CellHash::operator()(const Cell& cell) const {
  std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(cell.y)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(cell.z)) * 0x94D049BB133111EBu;
  return h ^ (h >> 31);
}

SphereGrid::Cell SphereGrid::Level::cell_of(const Vec3& position) const {
  const auto index = [this](double x) {
    return static_cast<std::int64_t>(std::clamp(std::floor(x / cell_size), -1e15, 1e15));
  };
  return {index(position.x), index(position.y), index(position.z)};
}

void SphereGrid::add(const Vec3& position, double radius, std::size_t index) {
  int exponent = 0;
  std::frexp(radius, &exponent);
  auto level = std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.exponent == exponent; });
  if (level == levels_.end()) level = levels_.insert(level, Level{exponent, std::ldexp(2.0, exponent), {}});
  level->cells[level->cell_of(position)].push_back({position, radius, index});
}

}  // namespace repose
