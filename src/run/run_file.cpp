#include "run/run_file.h"

#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/shared_file.h"
#include "output/summary.h"
#include "run/recorder.h"
#include "run/run.h"

namespace repose {
namespace {

/// DeckError when a file that the deck names is among the results that the run would remove or write anew.
void refuse_result(const std::string& path, const std::string& output) {
  const std::filesystem::path file(path);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code absent;
  if (!is_result(file.filename().string()) || !std::filesystem::equivalent(folder, output, absent)) return;
  throw DeckError(fmt::format("{}: the run would overwrite it; move it, or name another --output directory", path));
}

}  // namespace

std::optional<Summary> run_file(const Communicator& comm, const RunRequest& request, const StopAsked& stop_asked) {
  const Deck deck = read_deck(read_shared_file(comm, request.deck), request.deck, request.overrides);
  const OutputOptions options = {.directory = request.output,
                                 .resolved_deck = resolved_deck(deck),
                                 .build = build_info(to_string(request.level)),
                                 .log = request.log,
                                 .restart = request.restart};
  const ReadFile beside = reader_beside(comm, request.deck);
  const ReadFile read_file = [&](const std::string& file) {
    agree_after_root(comm, [&] { refuse_result(path_beside(request.deck, file), request.output); });
    return beside(file);
  };
  return run_deck(comm, deck, read_file, request.level, options, stop_asked);
}

}  // namespace repose
