#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "../unit/output_samples.h"
#include "base/error.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "output/summary.h"
#include "run/run.h"

namespace repose::test {

/// Runs of decks given as texts, each to a folder of its own that goes with the test.
class DeckRuns : public ::testing::Test {
 protected:
  std::string folder(const std::string& name) const { return folder_ / name; }

  /// The summary, or none when it was stopped after so many looks at whether it should be (0: never).
  std::optional<Summary> run(const Communicator& comm, const std::string& text, const std::string& name, int looks = 0,
                             bool restart = false) const {
    const Deck deck = read_deck(text, "scene.toml", {});
    OutputOptions options;
    options.directory = folder(name);
    options.resolved_deck = resolved_deck(deck);
    options.log.progress = nullptr;
    options.restart = restart;
    int looked = 0;
    const auto stop_asked = [&](double) -> std::optional<std::string> {
      if (++looked == looks) return "the test";
      return {};
    };
    try {
      return run_deck(comm, deck, {}, best_vector_level(), options, stop_asked);
    } catch (const Stopped&) {
      return {};
    }
  }

  Communicator world_{MPI_COMM_WORLD};
  ScratchFolder folder_{world_, "repose_deck_runs"};
};

}  // namespace repose::test
