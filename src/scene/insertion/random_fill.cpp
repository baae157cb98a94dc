#include "scene/insertion/random_fill.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>

#include <fmt/core.h>

#include "base/error.h"
#include "scene/insertion/region.h"
#include "scene/insertion/sphere_grid.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

constexpr std::uint32_t most_tries = 3000;  // of one sphere

std::optional<Vec3> free_place(const ParticlesDeck& fill, double radius, std::int64_t id, std::uint64_t seed,
                               const std::vector<Wall>& walls, const SphereGrid& others) {
  for (std::uint32_t attempt = 0; attempt < most_tries; ++attempt) {
    const auto place = random_place(fill, radius, seed, id, RandomStream::fill_position, 3 * attempt);
    if (place && !others.overlaps(*place, radius) && clear_of_walls(*place, radius, walls)) return place;
  }
  return {};
}

struct FreePlaces {
  std::vector<Vec3> position;
  std::size_t placed = 0;  ///< the largest of them, until one found no place
};

FreePlaces place(const ParticlesDeck& fill, std::span<const double> radii, std::int64_t first_id, std::uint64_t seed,
                 const std::vector<Wall>& walls) {
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  FreePlaces result{std::vector<Vec3>(radii.size()), 0};
  SphereGrid grid;
  for (const std::size_t i : order) {
    const auto found = free_place(fill, radii[i], first_id + static_cast<std::int64_t>(i), seed, walls, grid);
    if (!found) break;
    result.position[i] = *found;
    grid.add(*found, radii[i], i);
    ++result.placed;
  }
  return result;
}

/// What would make the block fit: a greater height, tried before it is named.
std::string remedy(const ParticlesDeck& fill, const std::function<bool(const ParticlesDeck&)>& fits) {
  ParticlesDeck trial = fill;
  const double height = bounds(fill).max.z - bounds(fill).min.z;
  for (double factor = 1.2; factor < 5.0; factor *= 1.2) {
    trial.height = factor * height;
    trial.max.z = trial.min.z + factor * height;
    if (fits(trial)) return fmt::format("a region of {:.6g} m height would hold them", trial.height);
  }
  return "take a wider region or fewer particles";
}

}  // namespace

std::vector<Vec3> random_fill(const ParticlesDeck& fill, std::span<const double> radii, std::int64_t first_id,
                              std::uint64_t seed, const std::vector<Wall>& walls, const std::string& block) {
  const FreePlaces places = place(fill, radii, first_id, seed, walls);
  if (places.placed == radii.size()) return places.position;
  const double volume =
      std::accumulate(radii.begin(), radii.end(), 0.0, [](double sum, double r) { return sum + sphere_volume(r); });
  const auto fits = [&](const ParticlesDeck& trial) {
    return place(trial, radii, first_id, seed, walls).placed == radii.size();
  };
  throw DeckError(fmt::format(
      "{}: only the {} largest of {} particles fit into the region, of whose volume they would take {:.0f} %; {}",
      block, places.placed, radii.size(), 100.0 * volume / region_size(fill), remedy(fill, fits)));
}

}  // namespace repose
