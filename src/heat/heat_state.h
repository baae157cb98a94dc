#pragma once

#include <cstdint>
#include <vector>

#include "deck/deck.h"
#include "heat/conductance.h"
#include "heat/heat_unit.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// The greatest temperature a particle may have, K: beyond, a run ends.
inline constexpr double greatest_temperature = 10000.0;

/// What is fixed of the heat of a run: properties, the unit, and what the deck says of each block of particles.
class HeatState {
 public:
  /// Of a deck with [heat] whose particles can come to have so many times their mass.
  HeatState(const Deck& deck, const MaterialTable& materials, const Insertion& insertion, double growth);

  const HeatUnit& unit() const { return unit_; }
  const Conductance& conductance() const { return conductance_; }

  /// Heat in units with which the particle `id` enters: at the temperature of its block, else of the file it comes from
  /// (`in_file`, NaN without one), else of the deck.
  std::int64_t entering(std::int64_t id, double radius, std::int32_t material, double in_file) const;
  /// Heat in units of a particle at `temperature` K.
  std::int64_t heat_at(double temperature, double radius, std::int32_t material) const;
  /// K of an owned particle.
  double temperature(const Particles& particles, std::size_t i) const;
  /// J/K of an owned particle at `temperature` K.
  double capacity(const Particles& particles, std::size_t i, double temperature) const;
  bool is_isothermal(std::int64_t id) const { return has_special_blocks_ && block_of(id).isothermal; }
  /// Power of the sources in an owned particle, W.
  double heating(const Particles& particles, std::size_t i) const;

  std::size_t solid(std::int32_t material) const { return static_cast<std::size_t>(materials_.solid(material)); }

 private:
  struct Block {
    std::int64_t end;    ///< behind the last number
    double temperature;  ///< K; NaN when the block gives none
    bool isothermal;
    double heating;  ///< W/kg
  };
  const Block& block_of(std::int64_t id) const;
  double mass(double radius, std::int32_t material) const;

  const MaterialTable& materials_;
  Conductance conductance_;
  double temperature_of_rest_;  ///< K
  std::vector<Block> blocks_;
  bool has_special_blocks_ = false;
  HeatUnit unit_;
};

}  // namespace repose
