#pragma once

#include <span>
#include <vector>

#include "comm/communicator.h"
#include "heat/heat_unit.h"

namespace repose {

/// Where the heat of a run has come from and gone to, in units: on one rank, to be summed over all.
struct HeatLedger {
  HeatSum brought;             ///< with the particles that entered
  HeatSum sources;             ///< made in the grains, or set ([[phase.heat]])
  HeatSum kept;                ///< given to isothermal particles to keep their temperature
  HeatSum left;                ///< with the particles that left
  std::vector<HeatSum> walls;  ///< given by each wall

  static HeatLedger none(std::size_t walls) {
    HeatLedger ledger;
    ledger.walls.resize(walls);
    return ledger;
  }

  /// What the particles inside must have.
  HeatSum inside() const {
    HeatSum sum = brought + sources + kept - left;
    for (const HeatSum& wall : walls) sum = sum + wall;
    return sum;
  }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("brought", self.brought);
    v("sources", self.sources);
    v("kept", self.kept);
    v("left", self.left);
    v.each("walls", self.walls);
  }
};

/// Collective. The sums over all ranks, in their order.
std::vector<HeatSum> sum_of(const Communicator& comm, std::span<const HeatSum> here);

/// Collective. That of all ranks.
HeatLedger sum_of(const Communicator& comm, const HeatLedger& here);

}  // namespace repose
