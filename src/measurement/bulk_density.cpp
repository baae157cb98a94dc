#include "measurement/bulk_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "measurement/bed.h"
#include "measurement/sphere_in_box.h"
#include "scene/particles/periodicity.h"

namespace repose {
namespace {

constexpr double column_width = 2.0;  // of the mean diameter
constexpr double least_depth = 2.0;   // of the mean diameter
constexpr double default_gap = 3.0;   // of the mean diameter

/// The same whatever the order.
double sum_of(std::vector<double> terms) {
  std::sort(terms.begin(), terms.end());
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

bool is_over(const Vec3& p, const BulkDensityDeck& box) {
  return p.x >= box.min.x && p.x < box.max.x && p.y >= box.min.y && p.y < box.max.y && p.z >= box.min.z;
}

/// Grains that lie over the box, by columns: the highest point of each.
struct Surface {
  double mean_diameter = 0.0;
  double lowest = 0.0;  ///< z; minus infinity when a column is empty
};

Surface surface_over(const BulkDensityDeck& box, std::span<const Sphere> grains) {
  std::vector<Sphere> over;
  std::copy_if(grains.begin(), grains.end(), std::back_inserter(over),
               [&](const Sphere& grain) { return is_over(grain.centre, box); });
  if (over.empty()) return {.mean_diameter = 0.0, .lowest = -std::numeric_limits<double>::infinity()};
  const double mean = mean_diameter(over);
  const auto columns = [&](double length) { return std::max(1.0, std::floor(length / (column_width * mean))); };
  const double nx = columns(box.max.x - box.min.x), ny = columns(box.max.y - box.min.y);
  std::vector<double> highest(static_cast<std::size_t>(nx * ny), -std::numeric_limits<double>::infinity());
  for (const Sphere& grain : over) {
    const double i = std::min(nx - 1.0, std::floor((grain.centre.x - box.min.x) / (box.max.x - box.min.x) * nx));
    const double j = std::min(ny - 1.0, std::floor((grain.centre.y - box.min.y) / (box.max.y - box.min.y) * ny));
    double& top = highest[static_cast<std::size_t>(j * nx + i)];
    top = std::max(top, grain.centre.z + grain.radius);
  }
  return {.mean_diameter = mean, .lowest = *std::min_element(highest.begin(), highest.end())};
}

}  // namespace

std::optional<BulkDensity> bulk_density(const BulkDensityDeck& deck, const DomainDeck& domain,
                                        std::span<const Sphere> grains, std::span<const double> mass) {
  const Surface surface = surface_over(deck, grains);
  const double gap = std::isnan(deck.surface_gap) ? default_gap * surface.mean_diameter : deck.surface_gap;
  Vec3 top = deck.max;
  top.z = std::min(deck.max.z, surface.lowest - gap);
  if (!(top.z - deck.min.z >= least_depth * surface.mean_diameter)) return {};
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (const Sphere& grain : grains) {
    position.push_back(grain.centre);
    radius.push_back(grain.radius);
  }
  const SpheresWithImages all = with_images(Periodicity(domain), position, radius);
  std::vector<double> volumes, masses;
  for (std::size_t i = 0; i < all.position.size(); ++i) {
    const Sphere grain{all.position[i], all.radius[i]};
    const double inside = volume_in_box(grain, deck.min, top);
    if (inside == 0.0) continue;
    volumes.push_back(inside);
    if (!mass.empty()) masses.push_back(mass[all.original[i]] * (inside / volume(grain)));
  }
  const double box = (top.x - deck.min.x) * (top.y - deck.min.y) * (top.z - deck.min.z);
  BulkDensity result = {.density = {}, .porosity = 1.0 - sum_of(volumes) / box, .top = top.z};
  if (!mass.empty()) result.density = sum_of(masses) / box;
  return result;
}

}  // namespace repose
