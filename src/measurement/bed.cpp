#include "measurement/bed.h"

#include <algorithm>
#include <numeric>

#include "measurement/clusters.h"

namespace repose {

std::vector<Sphere> largest_cluster(std::span<const Sphere> grains) {
  constexpr double gap = 0.05;  // of the smaller diameter: a flowing bed is looser than one at rest
  const std::vector<std::size_t> cluster = touching_clusters(grains, gap);
  std::vector<std::size_t> size(grains.size(), 0);
  for (const std::size_t c : cluster) ++size[c];
  const auto largest = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<Sphere> bed;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (cluster[i] == largest) bed.push_back(grains[i]);
  }
  return bed;
}

double mean_diameter(std::span<const Sphere> grains) {
  std::vector<double> diameters;
  for (const Sphere& grain : grains) diameters.push_back(2.0 * grain.radius);
  std::sort(diameters.begin(), diameters.end());
  return std::accumulate(diameters.begin(), diameters.end(), 0.0) / static_cast<double>(diameters.size());
}

void StraightLine::add(double x, double y) {
  n_ += 1.0;
  x_ += x;
  y_ += y;
  xx_ += x * x;
  xy_ += x * y;
}

}  // namespace repose
