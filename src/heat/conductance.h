#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "deck/deck.h"
#include "heat/gap_conductance.h"
#include "heat/gas_table.h"
#include "heat/heat_table.h"

namespace repose {

/// A grain, or what it faces, as heat sees it.
struct WarmBody {
  double radius;         ///< m; unused of a wall
  double temperature;    ///< K
  std::size_t material;  ///< of the deck
};

/// What pairs of grains conduct, and grains and walls, by the models that a deck chooses: contacts, the gas around
/// them and in near gaps, radiation (docs/theory.md, "Heat").
class Conductance {
 public:
  explicit Conductance(const Deck& deck);

  /// W/K of two grains whose centres are `distance` m apart; 0 where the gap is too wide. The same bits with the two
  /// exchanged are not promised: the caller keeps their order.
  double of_pair(const WarmBody& first, const WarmBody& second, double distance) const;
  /// W/K of a grain and a wall at `distance` m from its centre: half of the resistance of the grain and its mirror
  /// image.
  double of_wall(const WarmBody& grain, const WarmBody& wall, double distance) const;

  const HeatTable& table(std::size_t material) const { return tables_[material]; }
  /// Widest gap that heat crosses, each particle's share over its radius; 0: contacts alone conduct.
  double reach_share() const { return crosses_gaps(deck_) ? 0.5 * deck_.max_gap : 0.0; }

 private:
  double contact_circle(double radius_1, double radius_2, double distance, double stiffness_root) const;
  double through_contact(const GrainPair& pair) const;
  GapFill fill_between(const WarmBody& a, const WarmBody& b) const;

  HeatDeck deck_;
  std::vector<HeatTable> tables_;
  std::vector<double> emissivity_;
  std::vector<double> stiffness_root_;  ///< by pair of materials: cube root of the ratio
  std::optional<GasTable> gas_;
};

}  // namespace repose
