#include "run/run.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/results_directory.h"
#include "run/checkpoints.h"
#include "run/finished_run.h"
#include "run/guard_report.h"
#include "run/restart.h"

namespace repose {

namespace {

void warn_of_mesh_defects(const Simulation& simulation, const RunLog& log) {
  if (!simulation.comm().is_root()) return;
  for (const Wall& wall : simulation.walls()) {
    const auto* mesh = std::get_if<Mesh>(&wall.shape);
    if (mesh == nullptr || !mesh->surface.defects.any()) continue;
    log.warn(fmt::format("wall \"{}\": {}", wall.name, describe(*mesh)));
  }
}

/// What the ranks agree to do beside the next steps; the greatest counts.
enum class Task { none, checkpoint, stop };

/// The checkpoint to begin from, none at the beginning. DeckError when the directory holds something else than the
/// caller thinks.
std::optional<FoundCheckpoint> checkpoint_to_begin_from(const Communicator& comm, const OutputOptions& options) {
  if (options.restart) {
    std::optional<FoundCheckpoint> found = newest_checkpoint(comm, options.directory, options.log);
    if (found) {
      const std::size_t phase = position_of(*found).phase;
      refuse_other_deck(options.directory, found->checkpoint.header.deck, options.resolved_deck, phase);
    }
    return found;
  }
  agree_after_root(comm, [&] {
    const std::vector<std::string> checkpoints = checkpoints_in(options.directory);
    if (checkpoints.empty()) return;
    throw DeckError(
        fmt::format("{}: a run that is not finished; --restart goes on with it, removing checkpoint_*.hdf "
                    "gives it up",
                    checkpoints.front()));
  });
  return {};
}

/// One run on its way through the phases.
class Run {
 public:
  Run(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level,
      const OutputOptions& options, const StopAsked& stop_asked, std::optional<FoundCheckpoint> from)
      : options_(options),
        stop_asked_(stop_asked),
        files_(read_file),
        simulation_(comm, deck, files_.reader(), level),
        recorder_(simulation_, options, from ? Existing::go_on : Existing::replace),
        checkpoints_(deck.output, options.directory) {
    warn_of_mesh_defects(simulation_, options.log);
    if (from) begin_from(std::move(*from));
  }

  Summary finish() {
    const std::vector<PhaseDeck>& phases = simulation_.deck().phases;
    for (; position_.phase < phases.size(); ++position_.phase) {
      Phase phase = begin(phases[position_.phase]);
      const std::string ended_by = go_through(phase);
      simulation_.check_guards();
      recorder_.phase_ended(simulation_, phase, ended_by);
      is_resumed_ = false;
    }
    const Summary summary = recorder_.finish(simulation_, files_.reader(), checkpoints_.cost());
    agree_after_root(simulation_.comm(), [&] { remove_checkpoints(options_.directory); });
    return summary;
  }

 private:
  void begin_from(FoundCheckpoint found) {
    const std::string path = found.path;
    warn_of_other_build(found);
    position_ = restore(std::move(found), simulation_, recorder_, files_);
    is_resumed_ = true;
    if (simulation_.comm().is_root()) {
      options_.log.say(
          fmt::format("goes on from {}: step {}, {:.6g} s", path, simulation_.steps(), simulation_.time()));
    }
  }

  void warn_of_other_build(const FoundCheckpoint& found) const {
    const BuildInfo& build = found.checkpoint.header.build;
    if (build.commit == options_.build.commit || !simulation_.comm().is_root()) return;
    options_.log.warn(fmt::format("{}: written by version {}, commit {}; the bits of the results may differ",
                                  found.path, build.version, build.commit));
  }

  Phase begin(const PhaseDeck& deck) {
    if (is_resumed_) return Phase(deck, simulation_, position_.phase_begin);
    Phase phase(deck, simulation_);
    position_.phase_begin = phase.first_step();
    recorder_.phase_begins(simulation_, phase);
    return phase;
  }

  /// The condition that ended the phase.
  std::string go_through(const Phase& phase) {
    while (true) {
      const std::int64_t check_every = simulation_.deck().run.check_every;
      if (auto condition = phase.ended_by(simulation_, check_every, recorder_.has_seen(phase.deck().until)))
        return *condition;
      simulation_.advance(std::min({phase.steps_left(simulation_), recorder_.steps_to_next(simulation_),
                                    checkpoints_.steps_to_next(simulation_.steps())}));
      if (const auto warning = simulation_.take_warning(); warning && simulation_.comm().is_root()) {
        options_.log.warn(*warning);
      }
      recorder_.steps_done(simulation_, phase);
      look_after_checkpoints();
    }
  }

  void look_after_checkpoints() {
    const Communicator& comm = simulation_.comm();
    const std::optional<std::string> reason = reason_to_stop();
    Task task = reason ? Task::stop : Task::none;
    if (!reason && comm.is_root() && checkpoints_.is_due_by_time()) task = Task::checkpoint;
    task = static_cast<Task>(comm.max(static_cast<int>(task)));
    if (task == Task::none && !checkpoints_.is_due_at(simulation_.steps())) return;
    simulation_.check_guards();
    save(checkpoints_, options_, simulation_, recorder_, position_, files_);
    if (task == Task::stop) stop(reason);
  }

  /// Stopping takes a checkpoint, and as long again for what is not foreseen.
  std::optional<std::string> reason_to_stop() const {
    constexpr double least = 1.0;  // s
    if (!stop_asked_) return {};
    return stop_asked_(least + 2.0 * checkpoints_.cost().longest);
  }

  [[noreturn]] void stop(const std::optional<std::string>& reason_here) const {
    const Communicator& comm = simulation_.comm();
    std::string reason = reason_here.value_or("");
    comm.broadcast(reason, comm.min(reason_here ? comm.rank() : comm.size()));
    throw Stopped(fmt::format("stopped by {} at step {}, {:.6g} s; the same command{} goes on from there", reason,
                              simulation_.steps(), simulation_.time(), options_.restart ? "" : " with --restart"));
  }

  OutputOptions options_;
  StopAsked stop_asked_;
  WatchedFiles files_;
  Simulation simulation_;
  Recorder recorder_;
  Checkpoints checkpoints_;
  RunPosition position_;
  bool is_resumed_ = false;  ///< within the phase in which the checkpoint was written
};

}  // namespace

std::optional<Summary> run_deck(const Communicator& comm, const Deck& deck, const ReadFile& read_file,
                                VectorLevel level, const OutputOptions& options, const StopAsked& stop_asked) {
  const ResultsDirectory directory(comm, options.directory, ResultsOf::run);
  if (options.restart && is_finished(comm, options.directory, options.resolved_deck)) {
    agree_after_root(comm, [&] { remove_checkpoints(options.directory); });  // of a run that was ended just then
    return {};
  }
  std::optional<FoundCheckpoint> from = checkpoint_to_begin_from(comm, options);
  try {
    return Run(comm, deck, read_file, level, options, stop_asked, std::move(from)).finish();
  } catch (const GuardError& error) {
    throw PhysicsError(with_neighbourhood(comm, deck, options, error.alarm()));
  }
}

}  // namespace repose
