#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "import/fix_groups.h"
#include "import/translate.h"

namespace repose {
namespace {

constexpr const char* contacts_are_written =
    "contacts are written with their forces beside each snapshot with output.contacts = true";

void timestep(Translation& to, Words& words) {
  const double step = words.number("the time step") * to.scene.units.time;
  if (!(step > 0.0)) words.fail("the time step is above 0");
  if (to.scene.has_run() && to.scene.timestep && step != *to.scene.timestep) {
    return note_missing(to.scene, words.command(),
                        "the time step does not change during a run; it stays the first one");
  }
  to.scene.timestep = step;
  to.scene.timestep_place = words.place();
}

/// Whether something begins or ends with the next run.
bool begins_anew(const ImportedScene& scene) {
  const auto changes = [&](const auto& items) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) {
      return item.from == scene.runs.size() || item.until == scene.runs.size();
    });
  };
  return scene.runs.empty() || changes(scene.walls) || changes(scene.motions) || changes(scene.insertions) ||
         changes(scene.growths) || changes(scene.heatings);
}

/// Each fix gravity acts by itself.
void add_gravities(ImportedScene& scene) {
  for (const auto& [name, gravity] : scene.gravities) {
    scene.gravity += gravity.acceleration;
    scene.gravity_place = gravity.place;
  }
}

/// reset_timestep N: for the runs that end at a step, and insertions that start at one.
void reset_timestep(Translation& to, Words& words) {
  to.scene.first_step = words.steps("the step") - to.scene.steps();
  note_needless(to.scene, words.command(), "steps are counted from 0");
}

/// run N [upto]; runs between which nothing changes are one.
void run(Translation& to, Words& words) {
  ScriptRun run{words.place(), words.steps("the number of steps")};
  constexpr std::int64_t most = 1'000'000'000'000;
  while (!words.at_end()) {
    if (words.take("upto")) {
      run.steps -= to.scene.first_step + to.scene.steps();
    } else if (words.take("pre") || words.take("post")) {
      words.choice("pre or post");
    } else if (words.take("start") || words.take("stop")) {
      words.steps("a step");
    } else {
      note_missing(to.scene, words.command(), fmt::format("\"{}\" of a run", words.word("a key")));
      words.rest();
    }
  }
  if (run.steps < 0 || run.steps > most) words.fail(fmt::format("a run of {} steps", run.steps));
  if (run.steps == 0) return note_needless(to.scene, words.command(), "no step is made");
  if (!to.scene.timestep) words.fail("a run before any timestep");
  if (!to.scene.has_run()) add_gravities(to.scene);
  settle_groups(to.scene);
  if (begins_anew(to.scene)) {
    to.scene.runs.push_back(run);
  } else {
    to.scene.runs.back().steps += run.steps;
  }
}

/// Ends what a fix has begun, from the next run on.
void unfix(Translation& to, Words& words) {
  const std::string name = words.word("the name of the fix");
  const auto found = to.scene.fixes.find(name);
  if (found == to.scene.fixes.end()) words.fail(fmt::format("no fix \"{}\" is there", name));
  const std::string style = found->second.style();
  to.scene.fixes.erase(found);
  if (end_fix(to.scene, name)) return;
  const bool lasts = style == "gravity" || style.starts_with("heat/gran");
  if (lasts || (to.scene.has_run() && (style == "nve/sphere" || style == "freeze"))) {
    return note_missing(to.scene, words.command(), fmt::format("{} lasts for the whole run", style));
  }
  note_needless(to.scene, words.command(), fmt::format("fix {} is not in the deck", style));
}

/// Why a compute is not needed: where a run has what it computes.
std::string reason_of_compute(const std::string& style) {
  if (style.ends_with("/gran/local")) return contacts_are_written;
  if (style.starts_with("coord/")) return "contacts are counted in series.csv, not for each grain";
  if (style.starts_with("stress/atom")) return fields_are_made;
  return "a run writes its own results";
}

/// compute ID GROUP STYLE ...: of interest is who knows the radii, and who the contacts.
void compute(Translation& to, Words& words) {
  const std::string name = words.word("the name of the compute");
  words.word("the group of the compute");
  const std::string style = words.word("the style of the compute");
  const bool knows_radii = style == "property/atom" && words.take("radius") && words.at_end();
  if (knows_radii) to.scene.radius_computes.insert(name);
  to.scene.contact_computes.erase(name);
  if (style.ends_with("/gran/local")) to.scene.contact_computes.insert(name);
  words.rest();
  note_needless(to.scene, words.command(), reason_of_compute(style));
}

/// Whether a word of a dump, such as c_NAME[1], is of a compute of contacts.
bool is_of_contacts(const std::string& word, const ImportedScene& scene) {
  const std::size_t begin = word.starts_with("c_") ? 2 : 0;
  return scene.contact_computes.contains(word.substr(begin, word.find('[') - begin));
}

void dump_local(Translation& to, Words& words) {
  const std::vector<std::string> what = words.rest();
  to.scene.writes_contacts = to.scene.writes_contacts || std::any_of(what.begin(), what.end(), [&](const auto& word) {
                               return is_of_contacts(word, to.scene);
                             });
  note_needless(to.scene, words.command(), contacts_are_written);
}

void dump_mesh(Translation& to, Words& words) {
  to.scene.writes_walls = true;
  note_needless(
      to.scene, words.command(),
      "the walls are written beside each snapshot with output.walls = true; forces are in walls.csv, for each "
      "wall, not for each triangle");
}

/// A dump that has no grains in it.
bool is_of_other_things(const std::string& style) {
  return style.starts_with("decomposition") || style == "image" || style == "movie";
}

/// dump ID GROUP STYLE N FILE ...: the first of grains says how often snapshots are written.
void dump(Translation& to, Words& words) {
  words.word("the name of the dump");
  words.word("the group of the dump");
  const std::string& style = words.word("the style of the dump");
  const auto every = static_cast<double>(words.steps("the steps between dumps"));
  if (style.starts_with("local")) return dump_local(to, words);
  if (style.starts_with("mesh")) return dump_mesh(to, words);
  if (style.starts_with("euler")) return note_needless(to.scene, words.command(), fields_are_made);
  if (is_of_other_things(style) || !(every >= 1.0)) {
    return note_needless(to.scene, words.command(), "a run writes its own results");
  }
  if (to.scene.dump_interval) {
    return note_needless(to.scene, words.command(),
                         "snapshots have all of the grains, as often as the first dump says");
  }
  if (!to.scene.timestep) return note_missing(to.scene, words.command(), "its interval is not known before a timestep");
  to.scene.dump_interval = every * *to.scene.timestep;
}

void thermo(Translation& to, Words& words) {
  const std::string& every = words.word("the steps between lines");
  const bool is_number = every.find_first_not_of("0123456789.") == std::string::npos;
  const double steps = is_number ? std::trunc(number_of(every, words.place(), "steps")) : 0.0;
  if (steps < 1.0 || !to.scene.timestep || to.scene.series_interval) {
    return note_needless(to.scene, words.command(), "a run writes its own results");
  }
  to.scene.series_interval = steps * *to.scene.timestep;
}

}  // namespace

const Translations& run_commands() {
  static const Translations commands = {{"timestep", timestep}, {"run", run},   {"reset_timestep", reset_timestep},
                                        {"unfix", unfix},       {"dump", dump}, {"compute", compute},
                                        {"thermo", thermo}};
  return commands;
}

}  // namespace repose
