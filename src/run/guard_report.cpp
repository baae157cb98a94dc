#include "run/guard_report.h"

#include <fmt/core.h>

#include "files/step_file.h"
#include "output/snapshot.h"
#include "run/snapshot_files.h"

namespace repose {

std::string with_neighbourhood(const Communicator& comm, const Deck& deck, const OutputOptions& options,
                               const Alarm& alarm) {
  if (alarm.neighbourhood.total == 0) return alarm.message;
  const std::string path = fmt::format(
      "{}/{}", options.directory, file_of_step(neighbourhood_files.prefix, alarm.step, neighbourhood_files.ending));
  SnapshotHeader header;
  header.step = alarm.step;
  header.time_s = alarm.time;
  header.deck = options.resolved_deck;
  header.build = options.build;
  header.state_hash = "part";  // there is none of a part of the particles
  header.inside = alarm.neighbourhood.total;
  for (const MaterialDeck& m : deck.materials) header.materials.push_back(m.name);
  try {
    write_snapshot(comm, path, alarm.neighbourhood, header);
  } catch (const Error& error) {
    return fmt::format("{}; the neighbourhood could not be written: {}", alarm.message, error.what());
  }
  return fmt::format("{}; neighbourhood in {}", alarm.message, path);
}

}  // namespace repose
