#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

struct Material {
  std::string name;
  double youngs_modulus;  ///< Pa
  double poisson_ratio;
  double density;  ///< kg/m3
};

/// What the contact law of the thesis needs to know of two materials that meet.
struct ContactParameters {
  double youngs_modulus_eff = 0.0;        ///< E_eff, Pa (thesis eq. 2.11)
  double shear_modulus_eff = 0.0;         ///< G_eff, Pa (thesis eq. 2.12)
  double damping_ratio = 0.0;             ///< beta, not positive (thesis eq. 2.10, or scene/damping.h)
  double tangential_damping_ratio = 0.0;  ///< c_t / c_n = sqrt(S_t / S_n) (thesis eqs. 2.8, 2.9)
  double sliding_friction = 0.0;          ///< mu
  double rolling_friction = 0.0;          ///< mu_r
  double density_first = 0.0;             ///< kg/m3, of the particle with the lower id; of a held one beyond measure
  double density_second = 0.0;            ///< kg/m3, unused at walls
};

/// A liquid bridge (contact/capillary.h).
struct CapillaryBridge {
  double force_per_radius = 0.0;            ///< N/m, 4 pi gamma cos(theta)
  double breaking_distance = 0.0;           ///< m
  double one_over_breaking_distance = 0.0;  ///< 1/m; 0 without a bridge
};

/// The same with what the options need.
struct PairParameters : ContactParameters {
  ContactDeck options;            ///< of the deck, the same for all pairs
  bool synchronised = false;      ///< velocities belong to the normal of half a step ago
  PairCoefficients coefficients;  ///< of the deck; those of the thesis's law stand above as well
  CapillaryBridge capillary;
  double jkr_adhesion = 0.0;  ///< c = sqrt(2 pi W / E_eff), m^(1/2) (contact/jkr.h)
};

/// Whether the contact law is that of the thesis, with none of the options.
bool follows_thesis(const PairParameters& pair);

/// Whether surfaces that have touched may hold together when they are apart.
inline bool adheres(const PairParameters& pair) {
  return pair.options.normal_law == NormalLaw::jkr || pair.options.cohesion == Cohesion::capillary;
}

/// The materials of a deck and the symmetric table of their pairs, by index. Behind the materials come their twins for
/// particles that are held (fixed, or on a prescribed path): the same solid, in contacts of infinite mass.
class MaterialTable {
 public:
  /// `deck` has been checked: every pair that can meet is there.
  explicit MaterialTable(const Deck& deck);

  std::size_t size() const { return materials_.size(); }  ///< with the twins
  /// The index of the twin of a material, among so many of the deck.
  static int held_twin(int material, std::size_t solids) { return material + static_cast<int>(solids); }
  bool is_held(std::int32_t material) const { return material >= static_cast<std::int32_t>(solids_); }
  /// The deck's material that a material or its twin is.
  std::int32_t solid(std::int32_t material) const { return material % static_cast<std::int32_t>(solids_); }
  const Material& operator[](std::size_t index) const { return materials_[index]; }
  int index_of(const std::string& name) const;
  const PairParameters& pair(std::size_t first, std::size_t second) const { return pairs_[first * size() + second]; }
  /// Greatest normal force in N that a particle of this material and `radius` m can meet at an overlap of `overlap` m,
  /// without dashpots, times the damping ratio where that exceeds 1, and what adhesion may add.
  double greatest_force(std::size_t material, double radius, double overlap) const;

 private:
  void set_pairs(std::size_t first, std::size_t second, const PairParameters& parameters);

  std::size_t solids_ = 0;  ///< materials of the deck
  std::vector<Material> materials_;
  std::vector<PairParameters> pairs_;  ///< size() x size(); zero where the deck has none (walls among themselves)
};

}  // namespace repose
