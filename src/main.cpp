#include <csignal>
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "base/error.h"
#include "campaign/calibrate.h"
#include "campaign/sensitivity.h"
#include "campaign/validate.h"
#include "comm/communicator.h"
#include "commands/check.h"
#include "commands/command_line.h"
#include "commands/info.h"
#include "commands/measure.h"
#include "commands/thermal.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/shared_file.h"
#include "run/pile_measurement.h"
#include "run/run_file.h"
#include "run/stop_request.h"

namespace {

using namespace repose;

void say(const Communicator& comm, const std::string& text) {
  if (comm.is_root()) fmt::print("{}", text);
}

std::string closing_lines(const Summary& s, const std::string& directory) {
  const auto number = [](const std::optional<double>& value, double factor) {
    return value ? fmt::format("{:.4g}", factor * *value) : std::string("-");
  };
  std::string text =
      fmt::format("{} steps to {:.6g} s in {:.1f} s wall time, {:.3g} million particle-steps/s on {} ranks\n", s.steps,
                  s.time_s, s.wall_seconds, 1e-6 * s.particle_steps_per_second, s.ranks);
  if (s.discharged_mass_kg) {
    text += fmt::format("discharged {} g, retained {} g{}, in {} s at {} g/s\n", number(s.discharged_mass_kg, 1e3),
                        number(s.retained_mass_kg, 1e3), s.plugged.value_or(false) ? " (plugged)" : "",
                        number(s.discharge_time_s, 1.0), number(s.discharge_rate_kg_s, 1e3));
  }
  text += pile_lines(s.pile);
  return text + fmt::format("state {}\nresults in {}\n", s.state_hash, directory);
}

RunRequest request_of(const CommandLine& command) {
  return {.deck = command.deck,
          .overrides = command.overrides,
          .output = command.output,
          .level = vector_level_from(command.vector_level),
          .log = {.progress = command.quiet ? nullptr : stdout},
          .restart = command.restart};
}

void run(const Communicator& comm, const CommandLine& command, const StopAsked& stop_asked) {
  if (const std::optional<Summary> summary = run_file(comm, request_of(command), stop_asked)) {
    say(comm, closing_lines(*summary, command.output));
  } else {
    say(comm, fmt::format("the run is complete already: results in {}\n", command.output));
  }
}

void check(const Communicator& comm, const CommandLine& command) {
  const Deck deck = read_deck(read_shared_file(comm, command.deck), command.deck, command.overrides);
  say(comm, check_report(deck, reader_beside(comm, command.deck), comm.size()));
}

void measure(const Communicator& comm, const CommandLine& command) {
  const Deck deck = read_deck(read_shared_file(comm, command.deck), command.deck, command.overrides);
  say(comm, measure_file(comm, deck, command.file, command.output));
}

void validate(const Communicator& comm, const CommandLine& command, const StopAsked& stop_asked) {
  say(comm, validate_file(comm, request_of(command), command.cases, stop_asked));
}

void thermal(const Communicator& comm, const CommandLine& command) {
  say(comm, run_thermal_tool(comm, {.tool = command.tool,
                                    .deck = command.deck,
                                    .overrides = command.overrides,
                                    .files = command.files,
                                    .output = command.output}));
}

void dispatch(const Communicator& comm, const CommandLine& command, StopRequest& stop) {
  stop.set_time_limit(command.time_limit);
  const StopAsked stop_asked = [&](double needed) { return stop.reason(needed); };
  switch (command.action) {
    case CommandLine::Action::run:
      return run(comm, command, stop_asked);
    case CommandLine::Action::check:
      return check(comm, command);
    case CommandLine::Action::validate:
      return validate(comm, command, stop_asked);
    case CommandLine::Action::calibrate:
      return say(comm, calibrate_file(comm, request_of(command), stop_asked));
    case CommandLine::Action::estimate:
      return say(comm, estimate_directory(comm, command.file, command.deck));
    case CommandLine::Action::sensitivity:
      return say(comm, sensitivity_file(comm, request_of(command), stop_asked));
    case CommandLine::Action::measure:
      return measure(comm, command);
    case CommandLine::Action::info:
      return say(comm, info_of_file(comm, command.file));
    case CommandLine::Action::export_file:
      return say(comm, export_snapshot(comm, command.file, command.format, command.output));
    case CommandLine::Action::thermal:
      return thermal(comm, command);
    case CommandLine::Action::keys:
      return say(comm, key_reference());
    case CommandLine::Action::version:
      return say(comm, version_text(to_string(best_vector_level())));
    case CommandLine::Action::none:
      return say(comm, command.text);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files: an error of the write, with its message
  repose::StopRequest stop;       // before MPI starts: the time limit includes its start
  const repose::MpiGuard mpi(&argc, &argv);
  const repose::Communicator world(MPI_COMM_WORLD);
  try {
    dispatch(world, repose::parse_command_line(argc, argv), stop);
    return 0;
  } catch (const repose::Error& error) {  // agreed among the ranks: all of them get here
    if (world.is_root()) fmt::print(stderr, "repose: {}\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {  // on this rank alone, perhaps: the others may wait for it for ever
    fmt::print(stderr, "repose: rank {}: {}\n", world.rank(), error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
