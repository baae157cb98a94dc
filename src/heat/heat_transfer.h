#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact/wall_contacts.h"
#include "domain/ghost_exchange.h"
#include "heat/heat_ledger.h"
#include "heat/heat_state.h"
#include "heat/phase_heat.h"
#include "neighbours/pair_lists.h"

namespace repose {

/// What a thermal step of a rank works on.
struct HeatScene {
  const Communicator& comm;
  const GhostExchange& ghosts;
  const PairLists& pairs;
  const WallContacts& wall_contacts;
  std::span<const Wall> walls;
  double time;  ///< s, of the run
  double step;  ///< s, the thermal one
};

/// A thermal step went wrong at an owned particle.
struct HeatFault {
  std::size_t particle;
  std::string what;
};

/// The heat of the particles of a rank over time: each thermal step is explicit. What flows between two particles is
/// computed alike on every rank that owns one of them, from the temperatures at the beginning of the step, rounded to
/// the unit once and added to the one and taken from the other.
class HeatTransfer {
 public:
  /// Of a deck with [heat] whose particles can come to have so many times their mass.
  HeatTransfer(const Deck& deck, const MaterialTable& materials, const Insertion& insertion, double growth);

  const HeatState& state() const { return state_; }
  std::int64_t every() const { return every_; }  ///< mechanical steps in a thermal one

  /// Gives the last particle the heat with which it enters; `temperature` in K is that of a file, or NaN.
  void enter(double temperature, Particles& particles);
  /// A particle grows by more of the same, as warm as it is.
  void multiply(double mass_factor, std::size_t i, Particles& particles);
  /// The boxes of [[phase.heat]] that there are from now on.
  void set_boxes(std::vector<PhaseHeatDeck> boxes) { boxes_ = PhaseHeat(std::move(boxes)); }
  /// Gives the particles in the boxes their temperatures.
  void warm(Particles& particles);
  /// Takes the heat of parked particles out.
  void take_leavers(Particles& particles);
  /// Collective. The next thermal step; what went wrong first on this rank.
  std::optional<HeatFault> advance(const HeatScene& scene, Particles& particles);

  const HeatLedger& ledger_here() const { return ledger_; }  ///< of this rank
  void set_ledger(const HeatLedger& ledger) { ledger_ = ledger; }
  /// K, of the walls with [wall.heat] at the last thermal step; NaN where none has been determined.
  std::span<const double> wall_temperatures() const { return wall_temperature_; }

  /// The same on all ranks; the heat of the particles and the ledger are not in it.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("wall_temperatures", self.wall_temperature_);
    v("conducting_temperatures", self.conducting_temperature_);
  }

 private:
  struct WallFlow {
    std::int32_t particle;
    std::int32_t wall;
    double conductance;  ///< W/K
  };
  WarmBody body(const Particles& particles, std::size_t i) const;
  void set_temperatures(const HeatScene& scene, const Particles& particles);
  void exchange_pairs(const HeatScene& scene, const Particles& particles);
  std::vector<WallFlow> wall_flows(const HeatScene& scene, const Particles& particles);
  void set_given_wall_temperatures(double time);
  void set_other_wall_temperatures(const HeatScene& scene, std::span<const WallFlow> flows);
  void exchange_walls(const HeatScene& scene, std::span<const WallFlow> flows);
  void add_sources(const HeatScene& scene, const Particles& particles);
  void settle(const HeatScene& scene, Particles& particles);
  std::int64_t flow(double joules, std::size_t particle);
  void note_conductance(std::size_t particle, double conductance, double step);
  void note_fault(std::size_t particle, const std::string& what);

  HeatState state_;
  std::int64_t every_;
  std::vector<WallHeatDeck> walls_;
  PhaseHeat boxes_;
  HeatLedger ledger_;
  std::vector<double> wall_temperature_;
  std::vector<double> conducting_temperature_;  ///< K, at which each wall conducts; NaN: at that of the grain
  // While a thermal step is made:
  std::vector<double> temperature_;     ///< of all particles, K
  std::vector<std::int64_t> gain_;      ///< of the owned ones, units
  std::vector<double> capacity_;        ///< of the owned ones, J/K
  std::vector<std::int64_t> levelled_;  ///< the same: share by which the step levels it with its surroundings, 2^-48
  std::optional<HeatFault> fault_;
};

}  // namespace repose
