#include "deck/deck_kind.h"

#include <fmt/core.h>

#include "base/error.h"
#include "deck/parse_toml.h"

namespace repose {
namespace {

DeckKind kind_of(const toml::table& root) {
  if (root.contains("case")) return DeckKind::validation;
  if (!root.contains("parameter")) return DeckKind::run;
  return root.contains("figures") ? DeckKind::sensitivity : DeckKind::calibration;
}

struct ToolKey {
  const char* key;  ///< at the top level of no deck of a run
  const char* command;
};
constexpr ToolKey tool_keys[] = {{"particle_conductivity", "thermal bed"},
                                 {"state", "thermal mixture"},
                                 {"box", "thermal network"},
                                 {"criteria", "thermal tps"},
                                 {"sensor", "thermal tps"},
                                 {"figure", "compare"},
                                 {"scale", "photo"}};

}  // namespace

DeckKind kind_of_deck(const std::string& text, const std::string& path) { return kind_of(parse_toml(text, path)); }

void require_run_deck(const std::string& text, const std::string& path) {
  const toml::table root = parse_toml(text, path);
  const auto refuse = [&](const char* command) {
    throw DeckError(fmt::format("{}: no deck of a run, but a file for repose {}", path, command));
  };
  switch (kind_of(root)) {
    case DeckKind::calibration:
      return refuse("calibrate");
    case DeckKind::sensitivity:
      return refuse("sensitivity");
    case DeckKind::validation:
      return refuse("validate");
    case DeckKind::run:
      break;
  }
  for (const ToolKey& tool : tool_keys) {
    if (root.contains(tool.key)) refuse(tool.command);
  }
  if (root.at_path("material[0].room")) refuse("thermal sensor");
}

void require_study(const std::string& text, const std::string& path, const std::string& command) {
  const toml::table root = parse_toml(text, path);
  const auto refuse = [&](const std::string& what) {
    throw DeckError(
        fmt::format("{0}: no file for repose {1}, but {2}; `repose keys {1}` lists its keys", path, command, what));
  };
  const DeckKind kind = kind_of(root);
  if (kind == DeckKind::run && (root.contains("phase") || root.contains("particles"))) refuse("a deck of a run");
  if (kind == DeckKind::validation && command != "validate") refuse("one for repose validate");
  if (root.contains("observable") && command != "calibrate") refuse("one for repose calibrate");
  if (kind == DeckKind::sensitivity && command != "sensitivity" && !root.contains("observable"))
    refuse("one for repose sensitivity");
}

}  // namespace repose
