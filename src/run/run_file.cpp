#include "run/run_file.h"

#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/shared_file.h"
#include "output/summary.h"
#include "run/run.h"

namespace repose {

std::optional<Summary> run_file(const Communicator& comm, const RunRequest& request, const StopAsked& stop_asked) {
  const Deck deck = read_deck(read_shared_file(comm, request.deck), request.deck, request.overrides);
  const OutputOptions options = {.directory = request.output,
                                 .resolved_deck = resolved_deck(deck),
                                 .build = build_info(to_string(request.level)),
                                 .log = request.log,
                                 .restart = request.restart};
  return run_deck(comm, deck, reader_beside(comm, request.deck), request.level, options, stop_asked);
}

}  // namespace repose
