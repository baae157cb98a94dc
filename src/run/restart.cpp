#include "run/restart.h"

#include <cstdio>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "deck/deck_difference.h"
#include "deck/read_deck.h"
#include "measurement/state_hash.h"
#include "output/state_json.h"

namespace repose {
namespace {

std::string hash_of(const Simulation& simulation) {
  return state_hash(simulation.comm(), simulation.particles(), simulation.pairs(), simulation.wall_contacts());
}

nlohmann::json state_of(const FoundCheckpoint& found) {
  try {
    return nlohmann::json::parse(found.checkpoint.header.state);
  } catch (const nlohmann::json::exception&) {
    throw FileError(fmt::format("{}: /state is no JSON", found.path));
  }
}

/// Whether particles grow in a phase of a resolved deck: how long they may is in the units of mass and heat.
bool has_growth(const std::string& deck, std::size_t phase) {
  const std::vector<PhaseDeck> phases = read_written_deck(deck, "the resolved deck", {}).phases;
  return phase < phases.size() && phases[phase].growth.enabled;
}

/// In the deck `now` of a run that has got to `phase`.
bool may_differ(const std::string& key, const std::string& now, std::size_t phase) {
  if (key.starts_with("output.")) return key != "output.trace";
  std::size_t of = 0;
  int end = 0;
  return std::sscanf(key.c_str(), "phase[%zu].max_time%n", &of, &end) == 1 && end == static_cast<int>(key.size()) &&
         of >= phase && !has_growth(now, of);
}

void check_files(const FoundCheckpoint& found, const nlohmann::json& state, const WatchedFiles& files) {
  for (const auto& [file, checksum] : files.checksums()) {
    if (state.value("files", nlohmann::json::object()).value(file, std::int64_t{-1}) != checksum) {
      throw FileError(fmt::format("{}: is not as it was when the run that {} belongs to began", file, found.path));
    }
  }
}

}  // namespace

ReadFile WatchedFiles::reader() {
  return [this](const std::string& file) {
    std::string bytes = read_file_(file);
    checksums_[file] =
        static_cast<std::int64_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
    return bytes;
  };
}

void refuse_other_deck(const std::string& directory, const std::string& before, const std::string& now,
                       std::size_t phase) {
  std::vector<std::string> list;
  for (const DeckDifference& d : deck_differences(before, now)) {
    if (may_differ(d.key, now, phase)) continue;
    list.push_back(fmt::format("{}: {} there, {} here", d.key, value_or_nothing(d.before), value_or_nothing(d.now)));
  }
  if (list.empty()) return;
  throw DeckError(fmt::format("{}: belongs to another deck: {}; give that deck, or another --output directory",
                              directory, fmt::join(list, "; ")));
}

void save(Checkpoints& checkpoints, const OutputOptions& options, const Simulation& simulation, Recorder& recorder,
          const RunPosition& position, const WatchedFiles& files) {
  const Communicator& comm = simulation.comm();
  recorder.sync_files(comm);
  StateWriter state;
  state("position", position);
  state("simulation", simulation);
  state("left", sum_of(comm, simulation.left_here()));
  if (simulation.heat() != nullptr) state("heat", sum_of(comm, simulation.heat()->ledger_here()));
  state("recorder", recorder);
  nlohmann::json all = state.json();
  all["files"] = files.checksums();
  checkpoints.write(comm,
                    {.step = simulation.steps(),
                     .time_s = simulation.time(),
                     .deck = options.resolved_deck,
                     .build = options.build,
                     .state_hash = hash_of(simulation),
                     .state = all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)},
                    simulation.particles(), simulation.contact_memory());
}

RunPosition position_of(const FoundCheckpoint& found) {
  const nlohmann::json state = state_of(found);
  RunPosition position;
  StateReader(state, found.path + ": state")("position", position);
  return position;
}

RunPosition restore(FoundCheckpoint found, Simulation& simulation, Recorder& recorder, const WatchedFiles& files) {
  const Communicator& comm = simulation.comm();
  RunPosition position;
  ExitCount left;
  HeatLedger heat = HeatLedger::none(simulation.walls().size());
  agree_after(comm, [&] {
    const nlohmann::json state = state_of(found);
    check_files(found, state, files);
    StateReader reader(state, found.path + ": state");
    reader("position", position);
    reader("simulation", simulation);
    reader("left", left);
    if (simulation.heat() != nullptr) reader("heat", heat);
    reader("recorder", recorder);
  });
  simulation.restore(std::move(found.checkpoint.particles), std::move(found.checkpoint.memory), left, heat);
  if (hash_of(simulation) != found.checkpoint.header.state_hash) {
    throw FileError(fmt::format("{}: does not give the state it was written from", found.path));
  }
  recorder.resume(simulation);
  return position;
}

}  // namespace repose
