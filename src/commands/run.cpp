#include <fmt/core.h>

#include "commands/command.h"
#include "commands/study_request.h"
#include "output/summary.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

std::string closing_lines(const Summary& s, const std::string& directory) {
  std::string text =
      fmt::format("{} steps to {:.6g} s in {:.1f} s wall time, {:.3g} million particle-steps/s on {} ranks\n", s.steps,
                  s.time_s, s.wall_seconds, 1e-6 * s.particle_steps_per_second, s.ranks);
  for (const MeasurementKind& kind : measurement_kinds()) {
    if (kind.lines != nullptr) text += kind.lines(s.figures);
  }
  return text + fmt::format("state {}\nresults in {}\n", s.state_hash, directory);
}

class Run : public Command {
 public:
  void declare(Options& options) override {
    request_.declare(options, "DECK", "deck (TOML)");
    options.flag("--restart", restart_,
                 "go on from the newest checkpoint in DIR, on any number of ranks; without one begin");
  }

  void carry_out(Process& process) override {
    RunRequest request = request_.run_request(process.ranks());
    request.restart = restart_;
    const auto summary = run_file(process.ranks(), request, process.stop_asked(request_.time_limit));
    process.say(summary ? closing_lines(*summary, request.output)
                        : fmt::format("the run is complete already: results in {}\n", request.output));
  }

 private:
  StudyRequest request_;
  bool restart_ = false;
};

}  // namespace

std::unique_ptr<Command> run_command() { return std::make_unique<Run>(); }

}  // namespace repose
