#include "scene/particles/materials.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "scene/particles/damping.h"
#include "scene/particles/hooke_spring.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// N: of the spring alone, at an overlap of `overlap` m; no more than that of JKR's law, which pulls beside it.
double spring_force(const PairParameters& pair, double radius, double mass, double overlap) {
  if (pair.options.normal_law == NormalLaw::hooke) return hooke_normal_stiffness(pair, radius, mass) * overlap;
  return 4.0 / 3.0 * pair.youngs_modulus_eff * std::sqrt(radius * overlap) * overlap;
}

/// N: what adhesion and cohesion can pull with at an overlap of `overlap` m.
double greatest_pull(const PairParameters& pair, double radius, double overlap) {
  const double area = 4.0 * pi * radius * overlap;  // the larger of sjkr.h's
  return (1.5 * pi * pair.coefficients.work_of_adhesion + pair.capillary.force_per_radius) * radius +
         pair.coefficients.cohesion_energy_density * area;
}

CapillaryBridge make_bridge(const PairCoefficients& pair) {
  if (!(pair.surface_tension > 0.0) || !(pair.bridge_volume > 0.0)) return {};
  const double angle = pair.contact_angle * degree;
  const double distance = (1.0 + 0.5 * angle) * odd_root<3>(pair.bridge_volume);
  return {4.0 * pi * pair.surface_tension * sin_cos_reproducible(angle).cosine, distance, 1.0 / distance};
}

/// c_t / c_n.
double tangential_damping_ratio(const Deck& deck, const PairDeck& pair, const PairParameters& p) {
  switch (deck.contact.tangential_damping) {
    case TangentialDamping::none:
      return 0.0;
    case TangentialDamping::normal:
      return 1.0;
    default:
      return std::sqrt(deck.contact.normal_law == NormalLaw::hooke ? pair.hooke_tangential_ratio
                                                                   : 4.0 * p.shear_modulus_eff / p.youngs_modulus_eff);
  }
}

/// What the options make of the pair.
void set_options(const Deck& deck, const PairDeck& deck_pair, PairParameters& p) {
  p.options = deck.contact;
  p.coefficients = deck_pair;
  if (deck.contact.cohesion == Cohesion::capillary) p.capillary = make_bridge(deck_pair);
  p.jkr_adhesion = std::sqrt(2.0 * pi * deck_pair.work_of_adhesion / p.youngs_modulus_eff);
  p.synchronised = deck.time.integrator == Integrator::synchronised_verlet;
  if (deck.contact.tangential_damping == TangentialDamping::none) p.coefficients.hooke_tangential_damping_rate = 0.0;
  if (deck.contact.attraction || !deck.contact.restitution_correction || has_hooke_damping_rate(deck_pair)) return;
  const double attractive = p.damping_ratio;
  p.damping_ratio = damping_ratio_without_attraction(deck_pair.restitution);
  // The tangential dashpot is not cut: it stays as it is.
  if (p.damping_ratio != 0.0) p.tangential_damping_ratio *= attractive / p.damping_ratio;
}

}  // namespace

MaterialTable::MaterialTable(const Deck& deck) {
  for (const MaterialDeck& m : deck.materials) {
    materials_.push_back({m.name, m.youngs_modulus, m.poisson_ratio, m.density});
  }
  solids_ = materials_.size();
  for (std::size_t m = 0; m < solids_; ++m) materials_.push_back(Material(materials_[m]));
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
      if (!has_hooke_damping_rate(deck_pair)) p.damping_ratio = damping_ratio(deck_pair.restitution);
      p.tangential_damping_ratio = tangential_damping_ratio(deck, deck_pair, p);
      p.sliding_friction = deck_pair.sliding_friction;
      p.rolling_friction = deck_pair.rolling_friction;
      set_options(deck, deck_pair, p);
      set_pairs(i, j, p);
    }
  }
}

/// The pair of two materials, and of their twins.
void MaterialTable::set_pairs(std::size_t first, std::size_t second, const PairParameters& parameters) {
  constexpr double beyond_measure = 1e100;  // m M / (m + M) is then m
  for (const bool first_is_held : {false, true}) {
    for (const bool second_is_held : {false, true}) {
      const std::size_t i = first + (first_is_held ? solids_ : 0);
      const std::size_t j = second + (second_is_held ? solids_ : 0);
      PairParameters& pair = pairs_[i * size() + j];
      pair = parameters;
      pair.density_first = first_is_held ? beyond_measure : materials_[i].density;
      pair.density_second = second_is_held ? beyond_measure : materials_[j].density;
    }
  }
}

int MaterialTable::index_of(const std::string& name) const {
  const auto found =
      std::find_if(materials_.begin(), materials_.end(), [&](const Material& m) { return m.name == name; });
  return static_cast<int>(found - materials_.begin());
}

double MaterialTable::greatest_force(std::size_t material, double radius, double overlap) const {
  double greatest = 0.0;
  for (std::size_t other = 0; other < size(); ++other) {
    const PairParameters& p = pair(material, other);
    const double mass = sphere_mass(radius, materials_[material].density);
    greatest = std::max(greatest, std::max(1.0, -p.damping_ratio) * spring_force(p, radius, mass, overlap) +
                                      greatest_pull(p, radius, overlap));
  }
  return greatest;
}

bool follows_thesis(const PairParameters& pair) { return pair.options == ContactDeck{} && !pair.synchronised; }

}  // namespace repose
