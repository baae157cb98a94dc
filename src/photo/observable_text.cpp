#include "photo/observable_text.h"

#include <algorithm>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "base/error.h"
#include "deck/calibration_deck.h"
#include "deck/parse_toml.h"

namespace repose::photo {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

/// Four digits and without an exponent where a person would write none.
std::string number(double value) { return fmt::format("{:.4g}", value); }

Keys keys_of(const MeasuredFigure& f) {
  // With one photograph the deviation is an estimate of the method, not of repeats.
  return {{"laboratory", fmt::format("{:.6g}", f.value.mean)},
          {"deviation", number(f.value.deviation)},
          {"repeats", std::to_string(f.photographs)},
          {"deviation_is_known", f.photographs > 1 ? "false" : "true"}};
}

std::string section_text(const MeasuredFigure& f) {
  std::string text = fmt::format("[[observable]]\nfigure = \"{}\"\n", f.figure);
  for (const auto& [key, value] : keys_of(f)) text += fmt::format("{} = {}\n", key, value);
  if (f.is_count) text += "scale = \"square_root\"\n";
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What is done to the lines of a file: replaced by number (from 0), or put behind a line.
struct Edits {
  std::map<std::size_t, std::string> replaced;
  std::map<std::size_t, std::vector<std::string>> behind;
};

void edit_key(Edits& edits, const std::vector<std::string>& lines, const toml::table& section, const std::string& key,
              const std::string& value) {
  const toml::node* node = section.get(key);
  if (node == nullptr) {
    const std::size_t figure = section.get("figure")->source().begin.line - 1;
    edits.behind[figure].push_back(fmt::format("{} = {}", key, value));
    return;
  }
  const toml::source_region& source = node->source();
  const std::size_t at = source.begin.line - 1;
  const std::string& line = edits.replaced.contains(at) ? edits.replaced[at] : lines[at];
  edits.replaced[at] = line.substr(0, source.begin.column - 1) + value + line.substr(source.end.column - 1);
}

const toml::table* find_observable(const toml::table& root, const std::string& figure) {
  const toml::array* sections = root["observable"].as_array();
  if (sections == nullptr) return nullptr;
  for (const toml::node& node : *sections) {
    const toml::table* section = node.as_table();
    if (section != nullptr && (*section)["figure"].value_or(std::string()) == figure) return section;
  }
  return nullptr;
}

std::string edited(const std::vector<std::string>& lines, const Edits& edits) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto replaced = edits.replaced.find(i);
    text += (replaced != edits.replaced.end() ? replaced->second : lines[i]) + "\n";
    const auto behind = edits.behind.find(i);
    if (behind == edits.behind.end()) continue;
    for (const std::string& line : behind->second) text += line + "\n";
  }
  return text;
}

}  // namespace

std::string observable_text(const std::vector<MeasuredFigure>& figures) {
  std::string text;
  for (const MeasuredFigure& f : figures) text += (text.empty() ? "" : "\n") + section_text(f);
  return text;
}

std::string with_observables(const std::string& text, const std::string& path,
                             const std::vector<MeasuredFigure>& figures) {
  const toml::table root = parse_toml(text, path);
  const std::vector<std::string> lines = lines_of(text);
  Edits edits;
  std::string added;
  for (const MeasuredFigure& f : figures) {
    const toml::table* section = find_observable(root, f.figure);
    if (section == nullptr) {
      added += "\n" + section_text(f);
      continue;
    }
    for (const auto& [key, value] : keys_of(f)) {
      if (key == "deviation_is_known" && section->get(key) == nullptr && value == "true") continue;  // its default
      edit_key(edits, lines, *section, key, value);
    }
  }
  std::string result = edited(lines, edits) + added;
  read_calibration_deck(result, path);
  return result;
}

}  // namespace repose::photo
