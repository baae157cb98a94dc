#include "import/import_script.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/read_deck.h"
#include "import/grain_list.h"
#include "import/insertion_sections.h"
#include "import/law_sections.h"
#include "import/run_sections.h"
#include "import/script.h"
#include "import/translate.h"
#include "import/wall_sections.h"
#include "run/run_plan.h"

namespace repose {
namespace {

/// All of a deck but the files beside it.
struct Draft {
  std::string deck = {};
  std::vector<Note> missing = {};
  std::map<std::string, std::string> mesh_files = {};  ///< file of the script -> beside the deck
};

const char* grain_file(bool is_fixed) { return is_fixed ? "grains_fixed.csv" : "grains.csv"; }

/// What a simulation cannot be without; `end` is the last line of the script.
void check_complete(const ImportedScene& scene, const Place& end) {
  if (!scene.box) refuse(end, "the script ends, and no create_box or read_data has said what is simulated");
  if (!scene.model) refuse(end, "the script ends, and no pair_style has said how grains touch");
  if (!scene.timestep) refuse(end, "the script ends, and no timestep was given");
  if (scene.runs.empty()) refuse(end, "the script ends, and no run has made a step");
  if (!scene.insertions.empty() || !scene.grains.empty()) return;
  for (const Note& note : scene.missing) {
    if (note.command.starts_with("create_atoms")) refuse(note.place, fmt::format("{}: {}", note.command, note.reason));
  }
  refuse(end, "the script ends, and no grains were inserted or read");
}

/// The grains of a dump in place of those that the script inserts before its first run or makes.
void take_dump(Translation& to) {
  ImportedScene& scene = to.scene;
  const std::string reason = "the grains of " + to.dump + " are there instead";
  for (const ScriptInsertion& insertion : scene.insertions) {
    scene.missing.push_back({insertion.place, "fix " + insertion.name, reason});
  }
  for (const ScriptCommand& command : scene.grain_origins) note_missing(scene, command, reason);
  scene.insertions.clear();
  scene.grains = parse_dump(to.read_file(to.dump), to.dump, scene.units).grains;
  scene.grain_origins = {ScriptCommand{{to.dump, 1}, {}}};
}

/// What a dump need not say: densities, and types that have no grains.
void complete_dump(ImportedScene& scene, const std::string& dump) {
  for (Grain& grain : scene.grains) {
    if (grain.density > 0.0) continue;
    for (const auto& [name, made] : scene.templates) {
      if (made.type == grain.type && !(grain.density > 0.0)) grain.density = made.density;
    }
    if (!(grain.density > 0.0)) {
      refuse(
          {dump, 1},
          fmt::format(
              "neither density nor mass is among its columns, and no fix particletemplate/sphere says that of type {}",
              grain.type));
    }
  }
  if (!scene.has_restarted) return;
  for (const auto& [name, property] : scene.properties) {
    if (property.kind == "peratomtype") scene.types = std::max(scene.types, static_cast<int>(property.values.size()));
  }
}

/// The grains of lists: a block of those that move, and one of those that are frozen.
void write_grain_blocks(DeckText& deck, const ImportedScene& scene) {
  for (const bool is_fixed : {false, true}) {
    const bool has_some = std::any_of(scene.grains.begin(), scene.grains.end(),
                                      [&](const Grain& grain) { return grain.is_fixed == is_fixed; });
    if (!has_some) continue;
    deck.section("[[particles]]", scene.grain_origins.front().place);
    deck.key("type", "csv");
    deck.key("file", grain_file(is_fixed));
    if (is_fixed) deck.key("fixed", true);
  }
}

/// FileError with the line of the script when it cannot be read.
std::string mesh_bytes(const ImportedScene& scene, const std::string& file, const ReadFile& read_file) {
  try {
    return read_file(file);
  } catch (const FileError& error) {
    for (const auto& [name, mesh] : scene.meshes) {
      if (mesh.file == file) throw FileError(fmt::format("{}: fix {}: {}", text(mesh.place), name, error.what()));
    }
    throw;
  }
}

/// Names and bytes of what lies beside the deck: lists of grains and meshes.
std::vector<std::pair<std::string, std::string>> files_of(const ImportedScene& scene, const Draft& draft,
                                                          const ReadFile& read_file) {
  const MaterialsUsed materials(scene);
  std::vector<std::pair<std::string, std::string>> files;
  for (const bool is_fixed : {false, true}) {
    std::vector<std::pair<Grain, std::string>> chosen;
    for (const Grain& grain : scene.grains) {
      if (grain.is_fixed == is_fixed) chosen.emplace_back(grain, materials.of_grains(grain.type, grain.density));
    }
    if (!chosen.empty()) files.emplace_back(grain_file(is_fixed), grain_csv(chosen));
  }
  for (const auto& [there, here] : draft.mesh_files) files.emplace_back(here, mesh_bytes(scene, there, read_file));
  return files;
}

void write_notes(DeckText& deck, const std::string& title, std::vector<Note> notes) {
  if (notes.empty()) return;
  std::stable_sort(notes.begin(), notes.end(), [](const Note& a, const Note& b) {
    return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
  });
  deck.blank();
  deck.comment(title);
  for (const Note& note : notes) {
    deck.comment("  " + text(note));
  }
}

/// Definitions that nothing of the script uses.
void note_unused(ImportedScene& scene, const ScriptModel& model) {
  const auto note = [&](const Place& place, const std::string& what, const std::string& reason) {
    scene.needless.push_back({place, what, reason});
  };
  const std::set<std::string> used = properties_of(scene, model);
  for (const auto& [name, property] : scene.properties) {
    if (!used.contains(name)) note(property.place, "fix property/global " + name, "the contact model does not use it");
  }
  for (const ScriptHeating& heating : scene.heatings) {
    if (heating.from >= scene.runs.size()) note(heating.place, "set property/atom", "no run comes after it");
  }
  for (const auto& entry : scene.meshes) {
    const std::string& name = entry.first;
    const bool is_face = std::any_of(scene.insertions.begin(), scene.insertions.end(),
                                     [&](const ScriptInsertion& insertion) { return insertion.face == name; });
    if (!scene.has_wall_of(name) && !is_face)
      note(entry.second.place, "fix " + name + " mesh/surface", "neither a wall nor an insertion face");
  }
}

/// Notes what has no counterpart, and what is not needed, in a scene of its own.
Draft draft_of(ImportedScene scene, const std::string& script, const TimeShares& shares) {
  const MaterialsUsed materials(scene);
  const Extent domain = domain_of(scene);
  DeckText deck;
  deck.comment(
      one_line(fmt::format("Imported from {} by repose import; file:line says where a part comes from.", script)));
  deck.blank();
  deck.key("gravity", scene.gravity, scene.gravity_place.line > 0 ? text(scene.gravity_place) : "no fix gravity");
  deck.section("[run]");
  deck.key("title", one_line(script));
  if (!scene.insertions.empty()) deck.key("seed", scene.insertions.front().seed, text(scene.insertions.front().place));
  write_domain(deck, scene, domain);
  write_materials(deck, scene, materials);
  write_contact(deck, scene, materials);
  write_heat(deck, scene, materials.model());
  WallNames walls = write_walls(deck, scene, materials, domain);
  write_grain_blocks(deck, scene);
  write_insertions(deck, scene, materials, walls, domain);
  write_time(deck, scene, shares);
  write_phases(deck, scene, walls, domain);
  write_output(deck, scene);
  write_guards(deck);
  if (!scene.integrates) {
    scene.missing.push_back(
        {scene.runs.front().place, "run", "no fix nve/sphere moves the grains there; here they move"});
  }
  note_unused(scene, materials.model());
  write_notes(deck, "Without a counterpart:", scene.missing);
  write_notes(deck, "Not needed:", scene.needless);
  return {deck.text(), std::move(scene.missing), std::move(walls.mesh_files)};
}

/// The line of the script that stands behind a line of the deck, in which an error was found as "name:line:...".
std::string origin_of(const std::string& error, const std::string& name, const std::string& deck) {
  if (!error.starts_with(name + ":")) return "";
  std::size_t begin = 0;
  for (int line = std::atoi(error.c_str() + name.size() + 1); line > 1 && begin != std::string::npos; --line) {
    begin = deck.find('\n', begin);
    if (begin != std::string::npos) ++begin;
  }
  if (begin == std::string::npos) return "";
  const std::string line = deck.substr(begin, deck.find('\n', begin) - begin);
  const std::size_t remark = line.rfind("  # ");
  return remark == std::string::npos ? "" : line.substr(remark + 4);
}

Deck read_imported_deck(const std::string& deck, const std::string& script) {
  const std::string name = deck_name(script);
  try {
    return read_deck(deck, name, {});
  } catch (const DeckError& error) {
    const std::string origin = origin_of(error.what(), name, deck);
    throw DeckError(fmt::format("{}: as a deck it is refused: {}", origin.empty() ? script : origin, error.what()));
  }
}

/// The time step and its limits, by all checks that come before a run.
TimeStep planned_step(const std::string& deck, const std::string& script, const ReadFile& read_file) {
  const Deck checked = read_imported_deck(deck, script);
  try {
    return RunPlan(checked, read_file).dt;
  } catch (const DeckError& error) {
    throw DeckError(fmt::format("{}: as a deck it is refused: {}", script, error.what()));
  }
}

/// The share of a critical time that a step takes, rounded up to hundredths.
double share_of(double step, double critical) {
  return std::isfinite(critical) ? std::min(1.0, std::ceil(100.0 * step / critical + 1e-9) / 100.0) : 0.0;
}

/// A time step that takes more than the usual shares of the Rayleigh and Hertz times.
std::vector<Note> warnings_of_step(const ImportedScene& scene, const TimeShares& shares) {
  const TimeDeck usual;
  if (shares.rayleigh <= usual.rayleigh_fraction && shares.hertz <= usual.hertz_fraction) return {};
  return {
      {scene.timestep_place, "timestep",
       fmt::format("it takes {} of the Rayleigh time and {} of the Hertz time; shares above {} and {} can keep beds "
                   "from resting",
                   shares.rayleigh, shares.hertz, usual.rayleigh_fraction, usual.hertz_fraction)}};
}

}  // namespace

std::string deck_name(const std::string& script) {
  const std::filesystem::path path(script);
  const std::string file = path.filename().string();
  const std::string name = file.starts_with("in.") ? file.substr(3) : path.stem().string();
  return (name.empty() ? "deck" : name) + ".toml";
}

ImportedDeck import_script(const std::string& script, const ReadFile& read_file,
                           const std::vector<std::string>& variables, const std::string& dump) {
  Translation to(read_file, dump);
  Place last{script, 1};
  read_script(script, read_file, variables, [&](const ScriptCommand& command) {
    translate(to, command);
    last = command.place;
  });
  if (!dump.empty()) {
    if (!to.scene.has_restarted) take_dump(to);
    complete_dump(to.scene, dump);
  }
  check_complete(to.scene, last);
  const Draft loose = draft_of(to.scene, script, {});
  ImportedDeck result{.deck = {}, .files = files_of(to.scene, loose, read_file), .missing = {}, .warnings = {}};
  const ReadFile read_imported = [&](const std::string& name) {
    for (const auto& [file, bytes] : result.files) {
      if (file == name) return bytes;
    }
    throw FileError(fmt::format("{}: not imported", name));
  };
  const TimeStep dt = planned_step(loose.deck, script, read_imported);
  const TimeShares shares{share_of(dt.step, dt.rayleigh_limit), share_of(dt.step, dt.hertz_limit),
                          share_of(dt.step, dt.hooke_limit)};
  Draft draft = draft_of(to.scene, script, shares);
  result.deck = std::move(draft.deck);
  result.missing = std::move(draft.missing);
  result.warnings = warnings_of_step(to.scene, shares);
  read_imported_deck(result.deck, script);
  return result;
}

}  // namespace repose
