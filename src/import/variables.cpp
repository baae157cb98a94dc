#include "import/variables.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/nearest.h"
#include "files/csv_file.h"
#include "import/formula.h"

namespace repose {
namespace {

constexpr int deepest = 50;             // formulas that name one another
constexpr std::int64_t most = 1000000;  // values of a loop

/// `loop N`, `loop FIRST LAST`, with or without `pad`.
std::vector<std::string> loop_values(Words& words) {
  std::int64_t first = 1;
  std::int64_t last = words.integer("the end of the loop");
  const bool is_padded_at_once = words.take("pad");
  if (!words.at_end() && !is_padded_at_once) {
    first = last;
    last = words.integer("the end of the loop");
  }
  const bool is_padded = is_padded_at_once || words.take("pad");
  if (last < first || last - first >= most) words.fail(fmt::format("a loop from {} to {}", first, last));
  std::vector<std::string> values;
  const std::size_t width = is_padded ? std::to_string(last).size() : 0;
  for (std::int64_t k = first; k <= last; ++k) values.push_back(fmt::format("{:0{}}", k, width));
  return values;
}

}  // namespace

void Variables::define(const ScriptCommand& command) {
  Words words(command);
  const std::string name = words.word("the name of the variable");
  std::string style = words.word("the style of the variable");
  if (style == "universe" || style == "world") style = "index";  // of which one partition sees the values in turn
  if (style == "uloop") style = "loop";
  if (style == "delete") {
    variables_.erase(name);
  } else if (style == "index" || style == "loop") {
    if (variables_.contains(name)) return;  // as LAMMPS does, so that a loop may jump to before its definition
    std::vector<std::string> values = style == "loop" ? loop_values(words) : words.rest();
    if (values.empty()) words.fail("an index variable without values");
    variables_[name] = {Style::list, std::move(values)};
  } else if (style == "string" || style == "equal" || style == "atom") {
    std::string text = words.word("the value of the variable");
    for (const std::string& more : words.rest()) text += " " + more;
    variables_[name] = {style == "string" ? Style::text : style == "equal" ? Style::formula : Style::of_atoms, {text}};
  } else {
    words.fail(fmt::format("variables of style \"{}\" are not known; index, loop, string and equal are", style));
  }
}

bool Variables::advance(const std::string& name, const Place& place) {
  const Variable& known = find(name, place);
  if (known.style != Style::list) refuse(place, fmt::format("variable \"{}\" has no next value", name));
  if (known.at + 1 < known.values.size()) {
    ++variables_[name].at;
    return true;
  }
  variables_.erase(name);
  return false;
}

const Variables::Variable& Variables::find(const std::string& name, const Place& place) const {
  const auto found = variables_.find(name);
  if (found != variables_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, variable] : variables_) names.push_back(known);
  refuse(place, fmt::format("no variable \"{}\" is defined above{}", name,
                            names.empty() ? "" : fmt::format("; the nearest is \"{}\"", nearest(name, names))));
}

std::string Variables::text(const std::string& name, const Place& place, int depth) const {
  const Variable& variable = find(name, place);
  switch (variable.style) {
    case Style::list:
    case Style::text:
      return variable.values[variable.at];
    case Style::formula:
      return fmt::format("{:.15g}", value(variable.values[0], place, depth));
    case Style::of_atoms:
      break;
  }
  refuse(place, fmt::format("variable \"{}\" has a value for each atom, none for the whole", name));
}

std::string Variables::text(const std::string& name, const Place& place) const { return text(name, place, 0); }

double Variables::value(const std::string& formula, const Place& place, int depth) const {
  if (depth > deepest) refuse(place, fmt::format("formula \"{}\" names itself", formula));
  const NamedValue value_of = [&](const std::string& known_as) -> std::optional<double> {
    if (known_as == "dt") return time_step_;
    if (!known_as.starts_with("v_")) return {};
    const std::string name = known_as.substr(2);
    return number_of(text(name, place, depth + 1), place, "variable " + name);
  };
  try {
    return evaluate(replaced(formula, place, true), value_of);
  } catch (const DeckError& error) {
    const std::string what = error.what();
    if (what.starts_with(repose::text(place))) throw;
    refuse(place, what);
  }
}

double Variables::value(const std::string& formula, const Place& place) const { return value(formula, place, 0); }

void Variables::put_atom_formulas(std::vector<std::string>& words) const {
  for (std::string& word : words) {
    const auto found = word.starts_with("v_") ? variables_.find(word.substr(2)) : variables_.end();
    if (found != variables_.end() && found->second.style == Style::of_atoms) word = found->second.values[0];
  }
}

/// Replaces what begins with the $ at `at`; where the line goes on.
std::size_t Variables::replace_one(const std::string& line, std::size_t at, const Place& place,
                                   std::string& result) const {
  if (at + 1 >= line.size()) refuse(place, "a $ at the end of the line");
  if (line[at + 1] == '{') {
    const std::size_t end = line.find('}', at);
    if (end == std::string::npos) refuse(place, "a ${ that is not closed");
    result += text(line.substr(at + 2, end - at - 2), place);
    return end + 1;
  }
  if (line[at + 1] == '(') {
    int open = 0;
    for (std::size_t end = at + 1; end < line.size(); ++end) {
      open += line[end] == '(' ? 1 : line[end] == ')' ? -1 : 0;
      if (open > 0) continue;
      result += shortest_text(value(line.substr(at + 2, end - at - 2), place));
      return end + 1;
    }
    refuse(place, "a $( that is not closed");
  }
  result += text(line.substr(at + 1, 1), place);
  return at + 2;
}

std::string Variables::replaced(const std::string& line, const Place& place, bool in_quotes) const {
  std::string result;
  char quote = '\0';
  for (std::size_t at = 0; at < line.size();) {
    const char c = line[at];
    if (c == '"' || c == '\'') quote = quote == c ? '\0' : quote == '\0' ? c : quote;
    if (c == '$' && (quote == '\0' || in_quotes)) {
      at = replace_one(line, at, place, result);
    } else {
      result += c;
      ++at;
    }
  }
  return result;
}

}  // namespace repose
