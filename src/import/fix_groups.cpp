#include "import/fix_groups.h"

#include <algorithm>

#include <fmt/core.h>

#include "import/translate.h"

namespace repose {
namespace {

bool freezes(const ScriptFix& fix) { return fix.style() == "freeze"; }
bool moves_grains(const ScriptFix& fix) { return fix.style().starts_with("nve"); }
bool acts_on_all_here(const ScriptFix& fix) {
  return fix.style() == "gravity" || fix.style() == "wall/gran" || fix.style().starts_with("heat/gran");
}

bool has(const ImportedScene& scene, const ScriptFix& fix, const Grain& grain) {
  return scene.groups.at(fix.group()).holds(grain);
}

template <class Kind>
std::vector<const ScriptFix*> fixes_that(const ImportedScene& scene, const Kind& kind) {
  std::vector<const ScriptFix*> fixes;
  for (const auto& [name, fix] : scene.fixes) {
    if (kind(fix)) fixes.push_back(&fix);
  }
  return fixes;
}

template <class Test>
void hold(ImportedScene& scene, const ScriptCommand& command, const Test& stands) {
  bool holds_some = false;
  bool stops_some = false;
  for (Grain& grain : scene.grains) {
    if (!stands(grain)) continue;
    grain.is_fixed = holds_some = true;
    stops_some = stops_some || !(grain.velocity == Vec3{} && grain.spin == Vec3{});
  }
  if (holds_some) scene.grain_origins.push_back(command);
  if (stops_some) note_missing(scene, command, "grains that stand still here have a velocity there");
}

void hold_grains(ImportedScene& scene) {
  for (const ScriptFix* fix : fixes_that(scene, freezes)) {
    hold(scene, fix->command, [&](const Grain& grain) { return has(scene, *fix, grain); });
  }
  const std::vector<const ScriptFix*> movers = fixes_that(scene, moves_grains);
  scene.integrates = !movers.empty();
  if (movers.empty()) return;
  hold(scene, movers.front()->command, [&](const Grain& grain) {
    return std::none_of(movers.begin(), movers.end(), [&](const ScriptFix* fix) { return has(scene, *fix, grain); });
  });
}

/// Whether a fix that begins after the first run moves grains that have stood still until then.
bool sets_free(const ImportedScene& scene, const ScriptFix& fix) {
  const std::vector<const ScriptFix*> frozen = fixes_that(scene, freezes);
  return std::any_of(scene.grains.begin(), scene.grains.end(), [&](const Grain& grain) {
    return grain.is_fixed && has(scene, fix, grain) &&
           std::none_of(frozen.begin(), frozen.end(), [&](const ScriptFix* f) { return has(scene, *f, grain); });
  });
}

/// What a fix does there and not here, by its group; empty: nothing. Grains of the list are looked at once.
std::string difference(const ImportedScene& scene, const ScriptFix& fix) {
  const bool is_new = !fix.is_checked;
  const auto enters = [&](const ScriptInsertion& insertion) { return insertion.groups.contains(fix.group()); };
  const auto& insertions = scene.insertions;
  if (freezes(fix) && std::any_of(insertions.begin(), insertions.end(), enters))
    return "it holds for the grains of lists alone, not for those that are inserted";
  if (moves_grains(fix) && is_new && scene.has_run() && sets_free(scene, fix))
    return "grains that stand still in the first run do so in all";
  const auto is_left_out = [&](const Grain& grain) { return !grain.is_fixed && !has(scene, fix, grain); };
  if (acts_on_all_here(fix) && ((is_new && std::any_of(scene.grains.begin(), scene.grains.end(), is_left_out)) ||
                                !std::all_of(insertions.begin(), insertions.end(), enters))) {
    return fmt::format("it acts on group {} there, here on all grains", fix.group());
  }
  return "";
}

/// Notes inserted grains that stand still there; here they move.
void note_unmoved(ImportedScene& scene) {
  const std::vector<const ScriptFix*> movers = fixes_that(scene, moves_grains);
  for (const ScriptInsertion& insertion : scene.insertions) {
    const bool is_moved = std::any_of(movers.begin(), movers.end(),
                                      [&](const ScriptFix* fix) { return insertion.groups.contains(fix->group()); });
    if (insertion.from < scene.runs.size() || movers.empty() || is_moved) continue;
    scene.missing.push_back(
        {insertion.place, "fix " + insertion.name, "no fix nve/sphere has its grains in its group; here they move"});
  }
}

}  // namespace

void settle_groups(ImportedScene& scene) {
  if (!scene.has_run()) hold_grains(scene);
  for (auto& [name, fix] : scene.fixes) {
    const std::string reason = fix.is_noted ? "" : difference(scene, fix);
    fix.is_checked = true;
    if (reason.empty()) continue;
    fix.is_noted = true;
    note_missing(scene, fix.command, reason);
  }
  note_unmoved(scene);
}

}  // namespace repose
