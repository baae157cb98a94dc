#include "run.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "guard_report.h"
#include "output/agreement.h"
#include "output/directory.h"

namespace repose {

namespace {

void warn_of_mesh_defects(const Simulation& simulation) {
  if (!simulation.comm().is_root()) return;
  for (const Wall& wall : simulation.walls()) {
    const auto* mesh = std::get_if<Mesh>(&wall.shape);
    if (mesh == nullptr || !mesh->surface.defects.any()) continue;
    fmt::print(stderr, "repose: warning: wall \"{}\": {}\n", wall.name, describe(*mesh));
  }
}

Summary run_phases(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level,
                   const OutputOptions& options) {
  Simulation simulation(comm, deck, read_file, level);
  warn_of_mesh_defects(simulation);
  Recorder recorder(simulation, options);
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, simulation);
    recorder.phase_begins(simulation, phase);
    std::optional<std::string> ended_by = phase.ended_by(simulation, deck.run.check_every, recorder.onset_seen());
    while (!ended_by) {
      simulation.advance(std::min(phase.steps_left(simulation), recorder.steps_to_next(simulation)));
      if (const auto warning = simulation.take_warning(); warning && comm.is_root()) {
        fmt::print(stderr, "repose: warning: {}\n", *warning);
      }
      recorder.steps_done(simulation, phase);
      ended_by = phase.ended_by(simulation, deck.run.check_every, recorder.onset_seen());
    }
    simulation.check_guards();
    recorder.phase_ended(simulation, phase, *ended_by);
  }
  return recorder.finish(simulation, read_file);
}

}  // namespace

Summary run_deck(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level,
                 const OutputOptions& options) {
  agree_after_root(comm, [&] { create_output_directory(options.directory); });
  try {
    return run_phases(comm, deck, read_file, level, options);
  } catch (const GuardError& error) {
    throw PhysicsError(with_neighbourhood(comm, deck, options, error.alarm()));
  }
}

}  // namespace repose
