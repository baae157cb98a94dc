#pragma once

#include <map>
#include <string>
#include <vector>

#include "files/read_file.h"
#include "import/imported_scene.h"

/// The commands of a script, by subject. Each function reads one command into the scene, or notes that it has no
/// counterpart; DeckError at its line when it is malformed or the rest would mean nothing without it.
namespace repose {

/// What all commands act on.
struct Translation {
  Translation(const ReadFile& reads, const std::string& dump_file) : read_file(reads), dump(dump_file) {}
  ImportedScene scene;
  const ReadFile& read_file;
  const std::string& dump;  ///< whose grains are there at the start; empty: none
};

/// Why commands for fields are not needed.
inline constexpr const char* fields_are_made = "repose fields makes density, velocity and stress from snapshots";

void note_missing(ImportedScene& scene, const ScriptCommand& command, const std::string& reason);
void note_needless(ImportedScene& scene, const ScriptCommand& command, const std::string& reason);

using Translate = void (*)(Translation&, Words&);
using Translations = std::map<std::string, Translate>;

/// By the first word of the command; of a fix, by its style, where the words behind it are left.
const Translations& box_commands();
const Translations& grain_commands();
const Translations& run_commands();
const Translations& grain_fixes();
const Translations& property_fixes();
const Translations& wall_fixes();
const Translations& insertion_fixes();

/// Ends what a fix has begun, from the next run on; whether it had begun something that ends.
bool end_fix(ImportedScene& scene, const std::string& name);
/// Whether walls, motions or insertions name this mesh, region, template or distribution.
bool is_in_use(const ImportedScene& scene, const std::string& name);

/// DeckError when something in use would get another meaning.
void refuse_second(const ImportedScene& scene, const std::string& name, const Words& words);

/// The words of a contact model, in pair_style and fix wall/gran, up to the first that is none of them.
ScriptModel read_model(Words& words);
/// A setting of a contact model that is on or off; false when the next word is none.
bool read_setting(Words& words, ScriptModel& model);
/// `pair_style`
void translate_pair_style(Translation& to, Words& words);

/// A command of a script.
void translate(Translation& to, const ScriptCommand& command);

/// An item by its name. DeckError that says which are known.
template <class Items>
auto& find_item(Items& items, const std::string& name, const Words& words, const std::string& kind) {
  const auto found = items.find(name);
  if (found != items.end()) return found->second;
  std::string known;
  for (const auto& [key, item] : items) known += (known.empty() ? "" : ", ") + key;
  words.fail("no " + kind + " \"" + name + "\" is defined above; " +
             (known.empty() ? "there is none" : "there are: " + known));
}

}  // namespace repose
