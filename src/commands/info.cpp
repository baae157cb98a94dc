#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "deck/parse_toml.h"
#include "files/shared_file.h"
#include "output/file_contents.h"

namespace repose {
namespace {

using Kind = FileContents::Kind;
using Count = FileContents::Count;

std::string counts(const std::vector<Count>& of) {
  std::vector<std::string> texts;
  for (const Count& c : of) texts.push_back(fmt::format("{} {}", c.name, c.count));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Of [run] in a deck, of the whole file in a study.
std::string title_of(const toml::table& deck) {
  const std::string title = deck["run"]["title"].value_or(deck["title"].value_or(std::string()));
  return title.empty() ? "none" : title;
}

/// Checkpoints count materials by their place in the deck. Particles that are held have places behind those of all.
void name_materials(const toml::table& deck, std::vector<Count>& materials, const std::string& file) {
  std::vector<std::string> names;
  if (const toml::array* array = deck["material"].as_array()) {
    for (const toml::node& node : *array) {
      const toml::table* table = node.as_table();
      names.push_back(table != nullptr ? (*table)["name"].value_or(std::string("?")) : "?");
    }
  }
  if (materials.size() > 2 * names.size()) throw FileError(file + ": has more materials than its deck");
  for (std::size_t m = 0; m < materials.size(); ++m) {
    materials[m].name = m < names.size() ? names[m] : names[m - names.size()] + " (held)";
  }
  for (std::size_t m = materials.size(); m < names.size(); ++m) materials.push_back({names[m], 0});
}

toml::table toml_of(const std::string& deck, const std::string& file) {
  try {
    return parse_toml(deck, file + ", the deck in it");
  } catch (const DeckError& error) {
    throw FileError(error.what());
  }
}

std::string lines_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text;
  for (const auto& [name, value] : rows) text += fmt::format("{:<13}{}\n", name, value);
  return text;
}

std::string describe(FileContents contents, const std::string& file) {
  const toml::table deck = toml_of(contents.deck, file);
  std::vector<std::pair<std::string, std::string>> rows;
  const auto add = [&](const char* name, std::string value) { rows.emplace_back(name, std::move(value)); };
  if (contents.kind == Kind::grid) {
    add("kind", "grid of runs");
    add("title", title_of(deck));
    const std::int64_t runs = std::accumulate(contents.states.begin(), contents.states.end(), std::int64_t{0},
                                              [](std::int64_t sum, const Count& c) { return sum + c.count; });
    add("runs", fmt::format("{}: {}", runs, counts(contents.states)));
    if (!contents.experiments.empty()) add("experiments", counts(contents.experiments));
    if (!contents.levels.empty()) add("levels", counts(contents.levels));
    add("parameters", fmt::format("{}", fmt::join(contents.columns, ", ")));
    add("figures", fmt::format("{}", fmt::join(contents.figures, ", ")));
  } else {
    const bool is_snapshot = contents.kind == Kind::snapshot;
    add("kind", is_snapshot ? "snapshot" : "checkpoint");
    add("title", title_of(deck));
    add("step", std::to_string(contents.step));
    add("time", fmt::format("{} s", contents.time_s));
    add("particles", fmt::format("{}", contents.particles) +
                         (is_snapshot ? fmt::format(" ({} inserted, {} left)", contents.inserted, contents.left) : ""));
    if (!is_snapshot) name_materials(deck, contents.materials, file);
    add("materials", counts(contents.materials));
    if (!contents.radii.empty()) {
      add("diameters", fmt::format("{:.6g} to {:.6g} mm", 2e3 * contents.radii[0], 2e3 * contents.radii[1]));
    }
    add("state", contents.state_hash);
  }
  add("build", fmt::format("repose {}, commit {}, {}", contents.version, contents.commit, contents.compiler));
  return lines_of(rows);
}

class Info : public Command {
 public:
  void declare(Options& options) override {
    options.argument("FILE", file_, "snapshot or checkpoint (.hdf), or grid.h5");
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] { text = describe(file_contents(read_whole_file(file_), file_), file_); });
    process.say(text);
  }

 private:
  std::string file_;
};

}  // namespace

std::unique_ptr<Command> info_command() { return std::make_unique<Info>(); }

}  // namespace repose
