#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

/// The boxes of a deck's [[phase.heat]], phase by phase.
class PhaseHeat {
 public:
  explicit PhaseHeat(const Deck& deck) : phases_(deck.phases) {}

  /// A phase without boxes of that name, or none of that name: nothing from now on.
  void begin_phase(const std::string& name);
  bool is_empty() const { return now_.empty(); }

  /// K that a particle at `place` (m, within the domain) is given when the phase begins; NaN: it keeps its own.
  double temperature(const Vec3& place) const { return last(place, &PhaseHeatDeck::temperature, unset); }
  /// W into a particle that is at `place`.
  double power(const Vec3& place) const { return last(place, &PhaseHeatDeck::power, 0.0); }

 private:
  double last(const Vec3& place, double PhaseHeatDeck::*value, double otherwise) const;

  std::vector<PhaseDeck> phases_;
  std::vector<PhaseHeatDeck> now_;
};

}  // namespace repose
