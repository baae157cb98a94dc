#include "measurement/pile.h"

#include <algorithm>
#include <iterator>

#include "measurement/clusters.h"

namespace repose {
namespace {

constexpr double least_layers = 3.0;  // of the mean diameter
constexpr std::size_t least_grains = 20;

struct Cluster {
  std::size_t grains = 0;
  double volume = 0.0;
  double diameters = 0.0;  // their sum
  double top = 0.0;        // above the plate
  bool on_plate = false;
};

bool is_pile(const Cluster& c) {
  return c.on_plate && c.grains >= least_grains && c.top >= least_layers * c.diameters / static_cast<double>(c.grains);
}

std::vector<Cluster> summarise(std::span<const Sphere> grains, const std::vector<std::size_t>& cluster_of,
                               double plate_height, double gap) {
  std::vector<Cluster> clusters(cluster_of.empty() ? 0 : 1 + *std::max_element(cluster_of.begin(), cluster_of.end()));
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere& grain = grains[i];
    const double height = grain.centre.z - plate_height;
    Cluster& c = clusters[cluster_of[i]];
    ++c.grains;
    c.volume += volume(grain);
    c.diameters += 2.0 * grain.radius;
    c.top = std::max(c.top, height + grain.radius);
    c.on_plate = c.on_plate || height <= (1.0 + 2.0 * gap) * grain.radius;
  }
  return clusters;
}

}  // namespace

std::vector<Sphere> find_pile(std::span<const Sphere> grains, double plate_height, double max_height, double gap) {
  std::vector<Sphere> below;
  std::copy_if(grains.begin(), grains.end(), std::back_inserter(below),
               [&](const Sphere& grain) { return grain.centre.z >= plate_height && grain.centre.z <= max_height; });
  const std::vector<std::size_t> cluster_of = touching_clusters(below, gap);
  const std::vector<Cluster> clusters = summarise(below, cluster_of, plate_height, gap);

  std::size_t best = clusters.size();
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (is_pile(clusters[c]) && (best == clusters.size() || clusters[c].volume > clusters[best].volume)) best = c;
  }
  std::vector<Sphere> pile;
  for (std::size_t i = 0; i < below.size(); ++i) {
    if (cluster_of[i] == best) pile.push_back(below[i]);
  }
  return pile;
}

}  // namespace repose
