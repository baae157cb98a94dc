#include "scene/materials.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"

namespace repose {

double damping_ratio(double restitution) {
  if (restitution <= 0.0) return -1.0;
  const double log_e = log_reproducible(restitution);
  return log_e / std::sqrt(log_e * log_e + pi * pi);
}

MaterialTable::MaterialTable(const Deck& deck) {
  for (const MaterialDeck& m : deck.materials) {
    materials_.push_back({m.name, m.youngs_modulus, m.poisson_ratio, m.density});
  }
  pairs_.resize(size() * size());
  for (const PairDeck& deck_pair : deck.pairs) {
    const auto a = static_cast<std::size_t>(index_of(deck_pair.materials[0]));
    const auto b = static_cast<std::size_t>(index_of(deck_pair.materials[1]));
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
      const Material& mi = materials_[i];
      const Material& mj = materials_[j];
      PairParameters p;
      p.youngs_modulus_eff = 1.0 / ((1.0 - mi.poisson_ratio * mi.poisson_ratio) / mi.youngs_modulus +
                                    (1.0 - mj.poisson_ratio * mj.poisson_ratio) / mj.youngs_modulus);
      p.shear_modulus_eff = 1.0 / (2.0 * (2.0 - mi.poisson_ratio) * (1.0 + mi.poisson_ratio) / mi.youngs_modulus +
                                   2.0 * (2.0 - mj.poisson_ratio) * (1.0 + mj.poisson_ratio) / mj.youngs_modulus);
      p.damping_ratio = damping_ratio(deck_pair.restitution);
      p.tangential_damping_ratio = std::sqrt(4.0 * p.shear_modulus_eff / p.youngs_modulus_eff);
      p.sliding_friction = deck_pair.sliding_friction;
      p.rolling_friction = deck_pair.rolling_friction;
      p.density_first = mi.density;
      p.density_second = mj.density;
      pairs_[i * size() + j] = p;
    }
  }
}

int MaterialTable::index_of(const std::string& name) const {
  const auto found =
      std::find_if(materials_.begin(), materials_.end(), [&](const Material& m) { return m.name == name; });
  return static_cast<int>(found - materials_.begin());
}

double MaterialTable::stiffest_partner(std::size_t material) const {
  double stiffest = 0.0;
  for (std::size_t other = 0; other < size(); ++other) {
    stiffest = std::max(stiffest, pair(material, other).youngs_modulus_eff);
  }
  return stiffest;
}

}  // namespace repose
