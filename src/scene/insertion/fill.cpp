#include "scene/insertion/fill.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/philox.h"
#include "scene/insertion/region.h"
#include "scene/particles/sphere_mass.h"

namespace repose {

namespace {

double spacing_of(const ParticlesDeck& fill) { return std::isnan(fill.spacing) ? 1.1 * fill.diameter : fill.spacing; }

// A simple cubic lattice that is centred across the region and begins at its bottom.
struct Lattice {
  double spacing;
  double jitter;  // greatest shift of a site along each axis
  Vec3 first;
  std::int64_t nx, ny, nz;
};

std::int64_t sites_along(double length, double margin, double spacing) {
  const double free = length - 2.0 * margin;
  if (free < -fit_rounding * spacing) return 0;
  constexpr double most = 1e15;  // far beyond any number that is placed
  return static_cast<std::int64_t>(std::fmin(std::floor(free / spacing + fit_rounding), most)) + 1;
}

Lattice make_lattice(const ParticlesDeck& fill) {
  const auto [min, max] = bounds(fill);
  const double spacing = spacing_of(fill);
  const double jitter = fill.jitter * 0.5 * (spacing - fill.diameter);
  const double margin = 0.5 * fill.diameter + jitter;
  const Vec3 size = max - min;
  Lattice lattice{spacing,
                  jitter,
                  {},
                  sites_along(size.x, margin, spacing),
                  sites_along(size.y, margin, spacing),
                  sites_along(size.z, margin, spacing)};
  const auto half_width = [&](std::int64_t n) { return 0.5 * static_cast<double>(n - 1) * spacing; };
  lattice.first = {0.5 * (min.x + max.x) - half_width(lattice.nx), 0.5 * (min.y + max.y) - half_width(lattice.ny),
                   min.z + margin};
  return lattice;
}

// Whether the sphere at a site stays inside the frustum wherever the jitter moves it; the box's lattice does by
// construction, and so do its floor and top.
bool inside(const ParticlesDeck& fill, const Lattice& lattice, const Vec3& site) {
  if (fill.region == RegionShape::box) return true;
  return inside_side(fill, site, 0.5 * fill.diameter, lattice.jitter, fit_rounding * lattice.spacing);
}

Vec3 jittered(const Vec3& site, double jitter, std::uint64_t seed, std::int64_t id) {
  const auto shift = [&](std::uint32_t axis) {
    return jitter * (2.0 * uniform(seed, static_cast<std::uint64_t>(id), RandomStream::insertion_jitter, axis) - 1.0);
  };
  return site + Vec3{shift(0), shift(1), shift(2)};
}

// At most `count` positions; fewer when the region is full.
std::vector<Vec3> place(const ParticlesDeck& fill, std::int64_t count, std::int64_t first_id, std::uint64_t seed,
                        const std::vector<Wall>& walls) {
  const Lattice lattice = make_lattice(fill);
  std::vector<Vec3> positions;
  std::int64_t placed = 0;
  for (std::int64_t layer = 0; layer < lattice.nz; ++layer) {
    for (std::int64_t row = 0; row < lattice.ny; ++row) {
      for (std::int64_t column = 0; column < lattice.nx; ++column) {
        if (placed == count) return positions;
        const Vec3 steps{static_cast<double>(column), static_cast<double>(row), static_cast<double>(layer)};
        const Vec3 site = lattice.first + lattice.spacing * steps;
        if (!inside(fill, lattice, site)) continue;
        const Vec3 position = jittered(site, lattice.jitter, seed, first_id + placed);
        if (!clear_of_walls(position, 0.5 * fill.diameter, walls)) continue;
        positions.push_back(position);
        ++placed;
      }
    }
  }
  return positions;
}

// What would make the block fit: a smaller spacing, a greater height, or both. Each is tried before it is named.
std::string remedy(const ParticlesDeck& fill, std::int64_t count, std::int64_t fitting,
                   const std::function<std::int64_t(const ParticlesDeck&)>& capacity) {
  std::vector<std::string> advice;
  ParticlesDeck trial = fill;
  const double gap = spacing_of(fill) / fill.diameter - 1.0;
  for (int step = 1; step <= 20 && advice.empty(); ++step) {
    trial.spacing = fill.diameter * (1.0 + gap * (20 - step) / 20);
    if (gap > 0.0 && capacity(trial) == count) advice.push_back(fmt::format("a spacing of {:.6g} m", trial.spacing));
  }
  trial = fill;
  const double height = bounds(fill).max.z - bounds(fill).min.z;
  const double share = static_cast<double>(count) / static_cast<double>(std::max<std::int64_t>(fitting, 1));
  for (double factor = share; fitting > 0 && factor < 4.0 * share; factor *= 1.02) {
    trial.height = factor * height;
    trial.max.z = trial.min.z + factor * height;
    if (capacity(trial) < count) continue;
    advice.push_back(fmt::format("a region of {:.6g} m height", trial.height));
    break;
  }
  if (advice.empty()) return "take a wider region or fewer particles";
  return fmt::format("{} would hold them", fmt::join(advice, " or "));
}

}  // namespace

DeckError too_many(const char* what, double count, const std::string& block) {
  return DeckError(
      fmt::format("{}: {:.3g} {} are too many; fewer than {:.0e} are taken", block, count, what, most_particles));
}

std::int64_t fill_count(const ParticlesDeck& fill, double density, const std::string& block) {
  const double wanted =
      fill.count > 0 ? static_cast<double>(fill.count) : fill.mass / sphere_mass(0.5 * fill.diameter, density);
  if (!(wanted >= 0.5)) throw DeckError(fmt::format("{}: count or mass must give at least one particle", block));
  if (!(wanted < most_particles)) throw too_many("particles", wanted, block);
  if (fill.count > 0) return fill.count;
  return static_cast<std::int64_t>(std::floor(wanted + 0.5));
}

std::vector<Vec3> fill_region(const ParticlesDeck& fill, std::int64_t count, std::int64_t first_id, std::uint64_t seed,
                              const std::vector<Wall>& walls, const std::string& block) {
  if (spacing_of(fill) < fill.diameter) {
    throw DeckError(
        fmt::format("{}: spacing = {} m is less than the diameter {} m", block, fill.spacing, fill.diameter));
  }
  std::vector<Vec3> positions = place(fill, count, first_id, seed, walls);
  const auto fitting = static_cast<std::int64_t>(positions.size());
  if (fitting == count) return positions;
  const auto capacity = [&](const ParticlesDeck& trial) {
    return static_cast<std::int64_t>(place(trial, count, first_id, seed, walls).size());
  };
  throw DeckError(fmt::format("{}: only {} of {} particles fit into the region at a spacing of {:.6g} m; {}", block,
                              fitting, count, spacing_of(fill), remedy(fill, count, fitting, capacity)));
}

}  // namespace repose
