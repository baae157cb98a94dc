#include "measurement/tilt_onset.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "run/measurements/measurement.h"
#include "simulation/phases.h"

namespace repose {
namespace {

constexpr double slower = 0.5;

/// The same deck at another rate of tilt, with as much more time to tilt.
Deck at_rate(Deck deck, double factor) {
  deck.tilt.angular_velocity *= factor;
  const std::vector<std::string>& tilting = deck.tilt.phases;
  for (PhaseDeck& phase : deck.phases) {
    if (!tilting.empty() && std::find(tilting.begin(), tilting.end(), phase.name) == tilting.end()) continue;
    phase.max_time /= factor;
    phase.time /= factor;
    phase.steps = static_cast<std::int64_t>(static_cast<double>(phase.steps) / factor);
  }
  return deck;
}

void sample_while_tilting(const Simulation& simulation, TiltOnset& onset) {
  if (simulation.scene().is_tilting()) {
    onset.sample(simulation.comm(), simulation.particles(), std::fabs(simulation.scene().tilt()));
  }
}

std::optional<double> onset_of(const Communicator& comm, const Deck& deck, const ReadFile& read_file,
                               VectorLevel level) {
  Simulation simulation(comm, deck, read_file, level);
  TiltOnset onset(deck.tilt_onset);
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    sample_while_tilting(simulation, onset);
    while (!phase.ended_by(simulation, deck.run.check_every, onset.onset().has_value())) {
      const std::int64_t to_check = deck.run.check_every - simulation.steps() % deck.run.check_every;
      simulation.advance(std::min(phase.steps_left(simulation), to_check));
      simulation.check_guards();
      sample_while_tilting(simulation, onset);
    }
  }
  return onset.onset();
}

/// tan of the angle at which the particle should begin to move on the plain material.
double friction_of(const Simulation& simulation, const TiltOnset& onset) {
  const MaterialTable& materials = simulation.materials();
  const auto against = static_cast<std::size_t>(materials.index_of(simulation.deck().tilt_onset.against));
  const PairParameters& pair = materials.pair(onset.material(), against);
  return onset.cannot_turn() ? pair.sliding_friction : pair.rolling_friction;
}

/// The tilt at which a particle begins to move on an inclined plane: at the rate of this run and, if the deck asks for
/// it, at half the rate (by another run, which writes nothing) and extrapolated to a rate of zero; and its excess over
/// the angle whose tangent is the coefficient of friction that held the particle: of rolling friction, or of sliding
/// friction when its rotation is blocked.
class TiltOnsetWatch : public Watch {
 public:
  explicit TiltOnsetWatch(const TiltOnsetDeck& deck) : onset_(deck) {}

  void phase_begins(const Simulation& simulation, const std::string&) override {
    sample_while_tilting(simulation, onset_);
  }
  void look(const Simulation& simulation) override { sample_while_tilting(simulation, onset_); }
  bool has_seen(PhaseUntil condition) const override {
    return condition == PhaseUntil::tilt_onset && onset_.onset().has_value();
  }

  void finish(const Simulation& simulation, const ReadFile& read_file, Figures& figures) override {
    Figures& rates = figures["tilt_onsets"];
    rates = Figures::array();
    if (!onset_.onset()) return;
    const double onset = *onset_.onset();
    const Deck& deck = simulation.deck();
    const auto add = [&](double rate, double angle) {
      rates.push_back({{"rate_deg_s", std::fabs(rate) / degree}, {"onset_deg", angle / degree}});
    };
    add(deck.tilt.angular_velocity, onset);
    double at_rest = onset;
    if (deck.tilt_onset.extrapolate) {
      const auto again = onset_of(simulation.comm(), at_rate(deck, slower), read_file, simulation.vector_level());
      if (!again) return;
      add(slower * deck.tilt.angular_velocity, *again);
      at_rest = extrapolated_onset(onset, *again, slower);
    }
    figures["tilt_onset_deg"] = at_rest / degree;
    figures["tilt_onset_excess_deg"] = (at_rest - std::atan(friction_of(simulation, onset_))) / degree;
  }

  void visit_state(StateWriter& v) const override { v("onset", onset_); }
  void visit_state(StateReader& v) override { v("onset", onset_); }

 private:
  TiltOnset onset_;
};

}  // namespace

MeasurementKind tilt_onset_measurement() {
  return {.section = "measurement.tilt_onset",
          .is_enabled = [](const Deck& deck) { return deck.tilt_onset.enabled; },
          .figures = {{.key = "tilt_onset_deg"},
                      {.key = "tilt_onset_excess_deg"},
                      {.key = "tilt_onsets", .kind = Figure::Kind::other, .absent = Figures::array()}},
          .watch = [](const Simulation& simulation, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<TiltOnsetWatch>(simulation.deck().tilt_onset);
          }};
}

}  // namespace repose
