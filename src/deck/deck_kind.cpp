#include "deck/deck_kind.h"

#include <fmt/core.h>

#include "base/error.h"
#include "deck/parse_toml.h"

namespace repose {

DeckKind kind_of_deck(const std::string& text, const std::string& path) {
  const toml::table root = parse_toml(text, path);
  if (root.contains("case")) return DeckKind::validation;
  if (!root.contains("parameter")) return DeckKind::run;
  return root.contains("figures") ? DeckKind::sensitivity : DeckKind::calibration;
}

void require_run_deck(const std::string& text, const std::string& path) {
  const auto refuse = [&](const char* command) {
    throw DeckError(fmt::format("{}: no deck of a run, but a file for repose {}", path, command));
  };
  switch (kind_of_deck(text, path)) {
    case DeckKind::calibration:
      return refuse("calibrate");
    case DeckKind::sensitivity:
      return refuse("sensitivity");
    case DeckKind::validation:
      return refuse("validate");
    case DeckKind::run:
      return;
  }
}

}  // namespace repose
