#include "import/insertion_portion.h"

#include <algorithm>

#include "import/grain_list.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

double mass_of(const ParticleTemplate& made) { return sphere_volume(made.radius) * made.density; }

}  // namespace

std::vector<Portion> portions(const ImportedScene& scene, const ScriptDistribution& distribution,
                              const MaterialsUsed& materials) {
  std::vector<Portion> result;
  double number = 0.0;
  double mass = 0.0;
  for (std::size_t k = 0; k < distribution.templates.size(); ++k) {
    const ParticleTemplate& made = scene.templates.at(distribution.templates[k]);
    const std::string& material = materials.of_grains(made.type, made.density);
    auto portion = std::find_if(result.begin(), result.end(), [&](const Portion& p) { return p.material == material; });
    if (portion == result.end())
      portion = result.insert(result.end(), Portion{.material = material, .density = made.density});
    const double share = distribution.shares[k];
    const double number_share = distribution.is_by_mass ? share / mass_of(made) : share;
    portion->classes[2.0 * made.radius] += share;
    portion->number_share += number_share;
    portion->mass_share += number_share * mass_of(made);
    number += number_share;
    mass += number_share * mass_of(made);
  }
  for (Portion& portion : result) {
    portion.mean_mass = portion.mass_share / portion.number_share;
    portion.number_share /= number;
    portion.mass_share /= mass;
  }
  return result;
}

double largest_diameter(const std::vector<Portion>& portions) {
  double largest = 0.0;
  for (const Portion& portion : portions) largest = std::max(largest, portion.classes.rbegin()->first);
  return largest;
}

Amount amount_of_list(const ImportedScene& scene, const ScriptRegion& region) {
  Amount there;
  for (const Grain& grain : scene.grains) {
    if (!is_inside(region, grain.position)) continue;
    const double volume = sphere_volume(grain.radius);
    there = {there.count + 1.0, there.mass + grain.density * volume, there.volume + volume};
  }
  return there;
}

double lacking(const ScriptInsertion& pack, const std::vector<Portion>& portions, const Portion& portion, double volume,
               const Amount& there) {
  if (pack.region_count) return std::max(0.0, *pack.region_count - there.count) * portion.number_share;
  const double density_of_all = [&] {
    double inverse = 0.0;
    for (const Portion& p : portions) inverse += p.mass_share / p.density;
    return 1.0 / inverse;
  }();
  const double mass = pack.region_mass ? *pack.region_mass - there.mass
                                       : (*pack.volume_fraction * volume - there.volume) * density_of_all;
  return std::max(0.0, mass) * portion.mass_share / portion.mean_mass;
}

Amount lacking(const ScriptInsertion& pack, const std::vector<Portion>& portions, double volume, const Amount& there) {
  Amount all;
  for (const Portion& portion : portions) {
    const double count = lacking(pack, portions, portion, volume, there);
    all.count += count;
    all.mass += count * portion.mean_mass;
    all.volume += count * portion.mean_mass / portion.density;
  }
  return all;
}

}  // namespace repose
