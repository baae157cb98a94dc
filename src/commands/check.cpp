#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "campaign/calibrate.h"
#include "campaign/sensitivity.h"
#include "campaign/validate.h"
#include "commands/command.h"
#include "deck/deck_kind.h"
#include "deck/read_deck.h"
#include "files/shared_file.h"
#include "integration/time_step.h"
#include "output/progress.h"
#include "run/run_plan.h"
#include "simulation/phases.h"
#include "simulation/setup.h"

namespace repose {
namespace {

// Rough figures for the estimates.
constexpr double bytes_per_particle = 1000.0;
constexpr double bytes_per_rank = 60e6;  // the program and its libraries

std::string limits_text(const Deck& deck, const TimeStep& dt) {
  if (deck.contact.normal_law == NormalLaw::hooke) {
    const std::string damping =
        dt.damping_limit < TimeStep::infinite ? fmt::format(", {:.4g} s damping rate", dt.damping_limit) : "";
    return fmt::format("limits      {:.4g} s Hooke ({:.0f} %){}\n", dt.hooke_limit, 100.0 * deck.time.hooke_fraction,
                       damping);
  }
  return fmt::format("limits      {:.4g} s Rayleigh ({:.0f} %), {:.4g} s Hertz ({:.0f} %, at {:.3g} m/s)\n",
                     dt.rayleigh_limit, 100.0 * deck.time.rayleigh_fraction, dt.hertz_limit,
                     100.0 * deck.time.hertz_fraction, dt.speed);
}

/// Steps as expensive as one with contacts: without mechanics those of heat alone cost something.
double costly_steps(const Deck& deck, const TimeStep& dt) {
  double steps = 0.0;
  for (const PhaseDeck& phase : deck.phases) {
    const auto longest = static_cast<double>(longest_steps(phase, dt.step));
    steps += phase.mechanics ? longest : longest / static_cast<double>(deck.heat.every);
  }
  return steps;
}

/// What a pour brings in, in a run that is over after `end` s.
std::string pour_text(const Pour& pour, double end) {
  const double start = pour.deck.start_time;
  const double first = start + pour.interval;
  const double last = start + std::max(1.0, std::ceil((pour.due_time.back() - start) / pour.interval)) * pour.interval;
  std::string text = fmt::format("pour        {} particles from {:.4g} to {:.4g} s, every {:.3g} s from {:.4g} s on",
                                 pour.size(), start, pour.due_time.back(), pour.interval, first);
  if (last > end)
    text += fmt::format("; {} before the run ends, after {:.4g} s", first > end ? "none" : "not all", end);
  return text + "\n";
}

/// What a run of this deck would be: particles, time step and what sets it, steps, expected memory and time on `ranks`
/// ranks. Sets the scene up but runs nothing. DeckError as a run would.
std::string check_report(const Deck& deck, const ReadFile& read_file, int ranks) {
  const RunPlan plan(deck, read_file);
  const auto& [materials, walls, insertion, dt] = plan;
  const auto count = static_cast<double>(insertion.planned);
  const double steps = most_steps(deck, dt);

  std::string report =
      fmt::format("particles   {} ({:.6g} kg)\n", insertion.planned, planned_mass(insertion, materials));
  for (const Pour& pour : insertion.pours) report += pour_text(pour, steps * dt.step);
  for (const SizeReport& sizes : insertion.sizes) report += size_report_text(sizes);
  for (const Wall& wall : walls) {
    if (const auto* mesh = std::get_if<Mesh>(&wall.shape)) {
      report += fmt::format("mesh        {}: {}\n", wall.name, describe(*mesh));
    }
  }
  report += fmt::format("time step   {:.6g} s, {}\n", dt.step,
                        dt.criterion == "given" ? "given in the deck" : "set by the " + dt.criterion + " criterion");
  report += limits_text(deck, dt);
  for (const PhaseDeck& phase : deck.phases) {
    const auto longest = static_cast<double>(longest_steps(phase, dt.step));
    const bool open_end = may_never_hold(phase.until);
    report += fmt::format("phase       {}: {}{:.0f} steps ({:.4g} s)\n", phase.name, open_end ? "at most " : "",
                          longest, longest * dt.step);
  }
  report += fmt::format("steps       {:.0f}\n", steps);
  report += fmt::format("memory      about {:.0f} MB\n", 1e-6 * (count * bytes_per_particle + ranks * bytes_per_rank));
  report += fmt::format("wall time   about {} on {} rank{}, if every phase takes its longest\n",
                        duration_text(count * costly_steps(deck, dt) / (usual_core_speed * ranks)), ranks,
                        ranks == 1 ? "" : "s");
  return report;
}

class Check : public Command {
 public:
  void declare(Options& options) override { declare_deck(options, deck_, overrides_); }

  void carry_out(Process& process) override { process.say(report(process.ranks())); }

 private:
  std::string report(const Communicator& comm) const {
    const std::string text = read_shared_file(comm, deck_);
    RunRequest request{};
    request.deck = deck_;
    request.overrides = overrides_;
    switch (kind_of_deck(text, deck_)) {
      case DeckKind::calibration:
        return check_calibration(comm, request);
      case DeckKind::sensitivity:
        return check_sensitivity(comm, request);
      case DeckKind::validation:
        return check_validation(comm, request);
      case DeckKind::run:
        break;
    }
    return check_report(read_deck(text, deck_, overrides_), reader_beside(comm, deck_), comm.size());
  }

  std::string deck_;
  std::vector<std::string> overrides_;
};

}  // namespace

std::unique_ptr<Command> check_command() { return std::make_unique<Check>(); }

}  // namespace repose
