#include "run/incline.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "run/phases.h"

namespace repose {
namespace {

constexpr double slower = 0.5;
constexpr double degree = pi / 180.0;

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

std::optional<double> onset_of(const Communicator& comm, const Deck& deck, const ReadFile& read_file,
                               VectorLevel level) {
  Simulation simulation(comm, deck, read_file, level);
  TiltOnset onset(deck.tilt_onset);
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    sample_tilt_onset(simulation, onset);
    while (!phase.ended_by(simulation, deck.run.check_every, onset.onset().has_value())) {
      const std::int64_t to_check = deck.run.check_every - simulation.steps() % deck.run.check_every;
      simulation.advance(std::min(phase.steps_left(simulation), to_check));
      simulation.check_guards();
      sample_tilt_onset(simulation, onset);
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

}  // namespace

void sample_tilt_onset(const Simulation& simulation, TiltOnset& onset) {
  if (simulation.scene().is_tilting()) {
    onset.sample(simulation.comm(), simulation.particles(), std::fabs(simulation.scene().tilt()));
  }
}

void summarise_tilt_onset(const Simulation& simulation, const ReadFile& read_file, const TiltOnset& watch,
                          Summary& summary) {
  if (!watch.onset()) return;
  const double onset = *watch.onset();
  const Deck& deck = simulation.deck();
  const auto add = [&](double rate, double angle) {
    summary.tilt_onsets.push_back({std::fabs(rate) / degree, angle / degree});
  };
  add(deck.tilt.angular_velocity, onset);
  double at_rest = onset;
  if (deck.tilt_onset.extrapolate) {
    const auto again = onset_of(simulation.comm(), at_rate(deck, slower), read_file, simulation.vector_level());
    if (!again) return;
    add(slower * deck.tilt.angular_velocity, *again);
    at_rest = extrapolated_onset(onset, *again, slower);
  }
  summary.tilt_onset_deg = at_rest / degree;
  summary.tilt_onset_excess_deg = (at_rest - std::atan(friction_of(simulation, watch))) / degree;
}

}  // namespace repose
