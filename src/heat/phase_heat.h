#pragma once

#include <utility>
#include <vector>

#include "deck/deck.h"

namespace repose {

/// The boxes of [[phase.heat]] of a phase.
class PhaseHeat {
 public:
  PhaseHeat() = default;
  explicit PhaseHeat(std::vector<PhaseHeatDeck> boxes) : boxes_(std::move(boxes)) {}

  bool is_empty() const { return boxes_.empty(); }

  /// K that a particle at `place` (m, within the domain) is given when the phase begins; NaN: it keeps its own.
  double temperature(const Vec3& place) const { return last(place, &PhaseHeatDeck::temperature, unset); }
  /// W into a particle that is at `place`.
  double power(const Vec3& place) const { return last(place, &PhaseHeatDeck::power, 0.0); }

 private:
  double last(const Vec3& place, double PhaseHeatDeck::*value, double otherwise) const;

  std::vector<PhaseHeatDeck> boxes_;
};

}  // namespace repose
