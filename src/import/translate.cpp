#include "import/translate.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {
namespace {

/// What a deck need not say, and why.
const std::map<std::string, std::string>& needless_commands() {
  static const std::string lists = "neighbour lists adapt by themselves";
  static const std::string ranks = "ranks share the particles by themselves";
  static const std::string results = "a run writes its own results";
  static const std::map<std::string, std::string> reasons = {
      {"atom_modify", lists},
      {"neighbor", lists},
      {"newton", ranks},
      {"communicate", ranks},
      {"comm_modify", ranks},
      {"comm_style", ranks},
      {"processors", ranks},
      {"balance", ranks},
      {"pair_coeff", "the properties of the materials say it"},
      {"print", results},
      {"echo", results},
      {"log", results},
      {"thermo_style", results},
      {"thermo_modify", results},
      {"uncompute", results},
      {"compute_modify", results},
      {"dump_modify", results},
      {"undump", results},
      {"restart", "checkpoints are written by themselves"},
      {"write_restart", "checkpoints are written by themselves"},
      {"write_dump", results},
      {"write_data", results},
      {"info", results},
      {"thermo_log", results},
      {"hard_particles", "any stiffness is allowed"},
      {"soft_particles", "any stiffness is allowed"},
      {"modify_timing", results},
      {"timers", results},
      {"suffix", ranks},
      {"package", ranks},
  };
  return reasons;
}

const std::map<std::string, std::string>& needless_fixes() {
  static const std::map<std::string, std::string> reasons = {
      {"check/timestep/gran", "the time step is always watched"},
      {"print", "a run writes its own results"},
      {"ave/time", "a run writes its own results"},
      {"ave/atom", "a run writes its own results"},
      {"ave/euler", fields_are_made},
      {"ave/histo", "a run writes its own results"},
      {"ave/spatial", "a run writes its own results"},
      {"store/state", "a run writes its own results"},
      {"store/force", "a run writes its own results"},
      {"balance", "ranks share the particles by themselves"},
  };
  return reasons;
}

/// What would be another simulation without it: refused, not listed.
const std::map<std::string, std::string>& refused_commands() {
  static const std::map<std::string, std::string> reasons = {
      {"coarsegraining", "coarse graining has no counterpart; write the scaled sizes and properties out"},
      {"bond_style", "bonds have no counterpart"},
      {"kspace_style", "forces over long distances have no counterpart"},
      {"minimize", "there is no minimiser"},
      {"python", "nothing in a script is executed"},
  };
  return reasons;
}

const std::map<std::string, std::string>& missing_commands() {
  static const std::map<std::string, std::string> reasons = {
      {"lattice", "grains on a lattice are [[particles]] of type lattice; write them by hand"},
      {"replicate", "grains are not multiplied"},
      {"displace_atoms", "grains are not displaced"},
      {"change_box", "the domain does not change"},
      {"fix_modify", "nothing of a fix is changed afterwards"},
  };
  return reasons;
}

/// Styles of fixes that have no counterpart, with the beginning of their names.
std::string reason_of_missing_fix(const std::string& style) {
  static const std::vector<std::pair<std::string, std::string>> reasons = {
      {"heat/gran", "of fix heat/gran conduction alone has a counterpart"},
      {"property/atom", "grains have no other properties"},
      {"viscous", "there is no drag"},
      {"drag", "there is no drag"},
      {"addforce", "gravity is the only force from outside"},
      {"setforce", "gravity is the only force from outside"},
      {"aveforce", "gravity is the only force from outside"},
      {"enforce2d", "space has three dimensions"},
      {"momentum", "momentum is what the forces make it"},
      {"deform", "the domain does not change"},
      {"rigid", "grains are single spheres"},
      {"multisphere", "grains are single spheres"},
      {"sph/", "there are no fluids"},
      {"couple", "there is no coupling to other programs"},
      {"cfd", "there is no coupling to other programs"},
      {"lb/", "there are no fluids"},
      {"massflow/mesh",
       "mass is counted at the exits of the domain ([[exit]]) and below a height ([measurement.discharge])"},
      {"mesh/module", "such a mesh has no counterpart"},
      {"efield", "there are no fields"},
  };
  for (const auto& [begins, reason] : reasons) {
    if (style.starts_with(begins)) return reason;
  }
  return fmt::format("there is nothing like fix {}", style);
}

/// Nothing is executed; what a folder or a variable of the system would be then is not known.
void translate_shell(Translation& to, Words& words) {
  const std::string& what = words.word("what to execute");
  if (what == "cd" || what == "putenv") words.fail(fmt::format("shell {}: nothing in a script is executed", what));
  note_needless(to.scene, words.command(), "nothing in a script is executed");
}

void translate_fix(Translation& to, Words& words) {
  const std::string id = words.word("the name of the fix");
  find_item(to.scene.groups, words.word("the group of the fix"), words, "group");
  std::string style = words.word("the style of the fix");
  if (to.scene.fixes.contains(id)) end_fix(to.scene, id);  // a fix of the same name replaces it
  to.scene.fixes[id] = {words.command()};
  if (style.starts_with("mesh/surface")) {
    if (style.find("servo") != std::string::npos) {
      words.fail(fmt::format("fix {}: write the mesh as a [[wall]] with [wall.servo] by hand (docs/user-guide.md#wall)",
                             style));
    }
    if (style.find("6dof") != std::string::npos) {
      words.fail(fmt::format("fix {}: a mesh that the grains move has no counterpart", style));
    }
    style = "mesh/surface";
  }
  for (const Translations* fixes : {&property_fixes(), &wall_fixes(), &insertion_fixes(), &grain_fixes()}) {
    const auto found = fixes->find(style);
    if (found != fixes->end()) return found->second(to, words);
  }
  const auto needless = needless_fixes().find(style);
  if (needless != needless_fixes().end()) return note_needless(to.scene, words.command(), needless->second);
  note_missing(to.scene, words.command(), reason_of_missing_fix(style));
}

bool is_noted(const std::vector<Note>& notes, const ScriptCommand& command) {
  return std::any_of(notes.begin(), notes.end(), [&](const Note& note) {
    return note.place.file == command.place.file && note.place.line == command.place.line;
  });
}

}  // namespace

std::string text(const Note& note) {
  return one_line(fmt::format("{}: {}: {}", text(note.place), note.command, note.reason));
}

bool ImportedScene::has_wall_of(const std::string& mesh) const {
  return std::any_of(walls.begin(), walls.end(), [&](const ScriptWall& wall) {
    return std::find(wall.meshes.begin(), wall.meshes.end(), mesh) != wall.meshes.end();
  });
}

void note_missing(ImportedScene& scene, const ScriptCommand& command, const std::string& reason) {
  scene.missing.push_back({command.place, text(command), reason});
}

void note_needless(ImportedScene& scene, const ScriptCommand& command, const std::string& reason) {
  if (!is_noted(scene.needless, command)) scene.needless.push_back({command.place, text(command), reason});
}

bool end_fix(ImportedScene& scene, const std::string& name) {
  bool is_done = false;
  const auto end = [&](auto& items) {
    for (auto& item : items) {
      if (item.until != never_removed || item.name != name) continue;
      item.until = scene.runs.size();
      is_done = true;
    }
  };
  end(scene.walls);
  end(scene.insertions);
  end(scene.motions);
  end(scene.growths);
  if (!scene.has_run() && scene.gravities.erase(name) > 0) is_done = true;
  return is_done;
}

bool is_in_use(const ImportedScene& scene, const std::string& name) {
  const auto any = [](const auto& items, const auto& names_it) {
    return std::any_of(items.begin(), items.end(), names_it);
  };
  const auto has = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return scene.has_wall_of(name) || any(scene.motions, [&](const MeshMotion& moves) { return moves.mesh == name; }) ||
         any(scene.heatings, [&](const ScriptHeating& heating) { return heating.region == name; }) ||
         any(scene.insertions, [&](const ScriptInsertion& insertion) {
           return insertion.distribution == name || insertion.region == name || insertion.face == name ||
                  has(scene.distributions.at(insertion.distribution).templates);
         });
}

void refuse_second(const ImportedScene& scene, const std::string& name, const Words& words) {
  if (is_in_use(scene, name)) {
    words.fail(fmt::format("\"{0}\" is in use above and would become another; give this one another name", name));
  }
}

void translate(Translation& to, const ScriptCommand& command) {
  Words words(command);
  const std::string& name = command.words[0];
  if (name == "fix") return translate_fix(to, words);
  if (name == "pair_style") return translate_pair_style(to, words);
  if (name == "shell") return translate_shell(to, words);
  for (const Translations* commands : {&box_commands(), &grain_commands(), &run_commands()}) {
    const auto found = commands->find(name);
    if (found != commands->end()) return found->second(to, words);
  }
  const auto refused = refused_commands().find(name);
  if (refused != refused_commands().end()) words.fail(fmt::format("{}: {}", name, refused->second));
  const auto needless = needless_commands().find(name);
  if (needless != needless_commands().end()) return note_needless(to.scene, command, needless->second);
  const auto missing = missing_commands().find(name);
  if (missing != missing_commands().end()) return note_missing(to.scene, command, missing->second);
  note_missing(to.scene, command, fmt::format("there is nothing like {}", name));
}

}  // namespace repose
