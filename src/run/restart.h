#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "files/read_file.h"
#include "run/checkpoints.h"
#include "run/recorder.h"
#include "simulation/simulation.h"

namespace repose {

/// Where a run is between its first phase and its last.
struct RunPosition {
  std::size_t phase = 0;
  std::int64_t phase_begin = 0;  ///< step

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("phase", self.phase);
    v("phase_begin", self.phase_begin);
  }
};

/// Reads the files that a deck names and remembers their checksums.
class WatchedFiles {
 public:
  explicit WatchedFiles(const ReadFile& read_file) : read_file_(read_file) {}
  /// Refers to this object.
  ReadFile reader();
  const std::map<std::string, std::int64_t>& checksums() const { return checksums_; }

 private:
  const ReadFile& read_file_;
  std::map<std::string, std::int64_t> checksums_;
};

/// DeckError, with the list of keys, when a run that has got to `phase` cannot go on with the deck `now` after `before`
/// (both resolved): only [output], but for output.trace, and max_time of phases that are not over and in which nothing
/// grows may differ. `directory` is named in the message.
void refuse_other_deck(const std::string& directory, const std::string& before, const std::string& now,
                       std::size_t phase);

/// Collective. Everything that a run needs to go on from here, in a new checkpoint.
void save(Checkpoints& checkpoints, const OutputOptions& options, const Simulation& simulation, Recorder& recorder,
          const RunPosition& position, const WatchedFiles& files);

/// Collective. Where the run was that a checkpoint is of. FileError when it does not say so.
RunPosition position_of(const FoundCheckpoint& found);

/// Collective. Puts a simulation and its recorder, just made from the same deck, into the state of the checkpoint.
/// Returns where the run was. FileError on all ranks when that cannot be, or when a file that the deck names has
/// changed.
RunPosition restore(FoundCheckpoint found, Simulation& simulation, Recorder& recorder, const WatchedFiles& files);

}  // namespace repose
