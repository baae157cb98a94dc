#include "import/script.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "files/text_table.h"
#include "import/variables.h"

namespace repose {
namespace {

constexpr std::size_t longest_line = 1000000;  // a loop that joins a variable to itself makes a longer one
constexpr int deepest_include = 16;

/// A line of a script without its comment, with those that continue it.
struct Line {
  std::string text;
  std::size_t number;  ///< where it begins
};

std::string without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"' || c == '\'') quote = quote == c ? '\0' : quote == '\0' ? c : quote;
    if (c == '#' && quote == '\0') return std::string(line.substr(0, at));
  }
  return std::string(line);
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  bool continues = false;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(trimmed(without_comment(trimmed(text.substr(0, end)))));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const bool goes_on = line.ends_with('&');
    if (goes_on) line.back() = ' ';
    if (continues) {
      lines.back().text += " " + line;
    } else {
      lines.push_back({line, number});
    }
    continues = goes_on;
  }
  return lines;
}

/// Commands that only say or write something: their variables may be known only while a simulation runs.
bool only_speaks(const std::string& word) {
  constexpr std::array<std::string_view, 7> names = {"print", "thermo_style", "thermo_modify", "dump_modify",
                                                     "log",   "compute",      "write_dump"};
  return std::find(names.begin(), names.end(), word) != names.end();
}

/// Whether a line defines a variable or asks for its value.
bool names_variable(const std::string& line, const std::string& name) {
  const auto has = [&](const std::string& text) {
    const std::size_t at = line.find(text);
    if (at == std::string::npos) return false;
    const std::size_t end = at + text.size();
    return end == line.size() || (std::isalnum(static_cast<unsigned char>(line[end])) == 0 && line[end] != '_');
  };
  if (has("${" + name + "}") || has("v_" + name) || (name.size() == 1 && line.find("$" + name) != std::string::npos))
    return true;
  std::string compact;
  for (const char c : line) {
    const char kept = c == '\t' ? ' ' : c;
    if (kept != ' ' || !compact.ends_with(' ')) compact += kept;
  }
  return compact.find("variable " + name + " ") != std::string::npos;
}

/// Follows a script.
class Reader {
 public:
  Reader(const ReadFile& read_file, const std::function<void(const ScriptCommand&)>& visit, std::size_t most_commands)
      : read_file_(read_file), visit_(visit), most_commands_(most_commands) {}

  /// NAME=VALUE of the command line, which an index variable of the script does not replace.
  void set(const std::string& given) {
    const std::size_t sign = given.find('=');
    if (sign == std::string::npos || sign == 0) throw DeckError(fmt::format("--var {}: write --var NAME=VALUE", given));
    ScriptCommand command;
    command.place.file = "--var";
    command.words = {"variable", given.substr(0, sign), "index", given.substr(sign + 1)};
    variables_.define(command);
    given_[given.substr(0, sign)] = given;
  }

  /// DeckError for a variable of the command line that no line of the script names.
  void check_given(const std::string& script) const {
    for (const auto& [name, given] : given_) {
      const bool is_used = std::any_of(files_.begin(), files_.end(), [&, &wanted = name](const auto& file) {
        return std::any_of(file.second.begin(), file.second.end(),
                           [&](const Line& line) { return names_variable(line.text, wanted); });
      });
      if (!is_used) throw DeckError(fmt::format("--var {}: {} has no variable \"{}\"", given, script, name));
    }
  }

  void follow(const std::string& first_file, int depth) {
    if (depth > deepest_include) throw DeckError(fmt::format("{}: includes itself", first_file));
    std::string file = first_file;
    std::size_t at = 0;
    for (;;) {
      const std::vector<Line>& lines = lines_in(file);
      if (at >= lines.size() || has_quit_) return;
      const Place place{file, lines[at].number};
      const std::optional<Jump> jump = carry_out(lines[at].text, place, depth);
      ++at;
      if (!jump) continue;
      file = jump->file == "SELF" ? file : jump->file;
      lines_to_follow(file, place);
      at = jump->label.empty() ? 0 : label_in(file, jump->label, place);
    }
  }

 private:
  struct Jump {
    std::string file;
    std::string label;
  };

  const std::vector<Line>& lines_in(const std::string& file) {
    const auto found = files_.find(file);
    if (found != files_.end()) return found->second;
    return files_[file] = lines_of(read_file_(file));
  }

  /// FileError with the line that names the file when it cannot be read.
  void lines_to_follow(const std::string& file, const Place& place) {
    try {
      lines_in(file);
    } catch (const FileError& error) {
      throw FileError(fmt::format("{}: {}", repose::text(place), error.what()));
    }
  }

  std::size_t label_in(const std::string& file, const std::string& label, const Place& place) {
    const auto found = labels_.find({file, label});
    if (found != labels_.end()) return found->second;
    const std::vector<Line>& lines = lines_in(file);
    for (std::size_t at = 0; at < lines.size(); ++at) {
      const std::vector<std::string> words = split_words(lines[at].text, {file, lines[at].number});
      if (words.size() > 1 && words[0] == "label" && words[1] == label) return labels_[{file, label}] = at;
    }
    refuse(place, fmt::format("no label \"{}\" in {}", label, file));
  }

  /// A line, perhaps of an if. Where to go on when that is not the next line.
  std::optional<Jump> carry_out(const std::string& line, const Place& place, int depth) {
    const std::string first = line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
    if (first.empty()) return {};
    if (++carried_out_ > most_commands_)
      refuse(place, fmt::format("more than {} commands: a loop without end?", most_commands_));
    const std::string said = only_speaks(first) ? line : variables_.replaced(line, place);
    if (said.size() > longest_line)
      refuse(place, fmt::format("more than {} characters: a variable that is joined to itself?", longest_line));
    std::vector<std::string> words = split_words(said, place);
    if (words.empty()) return {};
    ScriptCommand command{place, std::move(words)};
    const std::string& name = command.words[0];
    Words rest(command);
    if (name == "variable") {
      check_redefinition(rest);
      variables_.define(command);
    } else if (name == "next") {
      next(rest);
    } else if (name == "jump") {
      return jump(rest);
    } else if (name == "include") {
      const std::string& file = rest.word("the file to include");
      lines_to_follow(file, place);
      follow(file, depth + 1);
    } else if (name == "if") {
      return condition(rest, depth);
    } else if (name == "quit") {
      has_quit_ = true;
    } else if (name != "label") {
      if (name == "fix") variables_.put_atom_formulas(command.words);
      if (name == "timestep" && command.words.size() > 1)
        variables_.set_time_step(number_of(command.words[1], place, "the time step"));
      visit_(command);
    }
    return {};
  }

  /// Of a variable that the command line gives; LIGGGHTS stops then too.
  void check_redefinition(Words words) const {
    const auto found = given_.find(words.word("the name of the variable"));
    if (found == given_.end()) return;
    const std::string& style = words.word("the style of the variable");
    if (style != "equal" && style != "string" && style != "atom") return;
    throw DeckError(fmt::format("--var {}: {} defines \"{}\" as {}; only index variables can be given", found->second,
                                text(words.place()), found->first, style));
  }

  void next(Words& words) {
    bool is_over = false;
    for (const std::string& name : words.rest()) is_over = !variables_.advance(name, words.place()) || is_over;
    skips_jump_ = is_over;
  }

  std::optional<Jump> jump(Words& words) {
    const std::string file = words.word("the file to jump to");
    const std::string label = words.at_end() ? "" : words.word("the label");
    if (std::exchange(skips_jump_, false)) return {};
    return Jump{file, label};
  }

  /// if CONDITION then COMMAND... elif CONDITION COMMAND... else COMMAND...
  std::optional<Jump> condition(Words& words, int depth) {
    bool holds = is_true(words.word("the condition"), words.place());
    bool is_done = false;
    words.expect("then");
    std::optional<Jump> jump;
    while (!words.at_end()) {
      if (words.take("elif")) {
        is_done = is_done || holds;
        holds = !is_done && is_true(words.word("the condition"), words.place());
      } else if (words.take("else")) {
        is_done = is_done || holds;
        holds = !is_done;
      } else {
        const std::string command = words.word("a command");
        if (holds && !jump && !has_quit_) jump = carry_out(command, words.place(), depth);
      }
    }
    return jump;
  }

  /// A formula, or two texts that are equal or not.
  bool is_true(const std::string& condition, const Place& place) const {
    const std::string text = variables_.replaced(condition, place, true);
    for (const std::string sign : {"==", "!="}) {
      const std::size_t at = text.find(sign);
      if (at == std::string::npos || text.find_first_of("&|()") != std::string::npos) continue;
      const std::string_view left = trimmed(std::string_view(text).substr(0, at));
      const std::string_view right = trimmed(std::string_view(text).substr(at + 2));
      const auto is_name = [](std::string_view side) {
        return !side.empty() && !side.starts_with("v_") && std::isalpha(static_cast<unsigned char>(side[0])) != 0;
      };
      if (is_name(left) || is_name(right)) return (left == right) == (sign == "==");
    }
    return variables_.value(text, place) != 0.0;
  }

  const ReadFile& read_file_;
  const std::function<void(const ScriptCommand&)>& visit_;
  std::size_t most_commands_;
  Variables variables_;
  std::map<std::string, std::vector<Line>> files_;
  std::map<std::pair<std::string, std::string>, std::size_t> labels_;  ///< by file and label, of those jumped to
  std::map<std::string, std::string> given_;                           ///< NAME=VALUE of the command line, by name
  std::size_t carried_out_ = 0;
  bool skips_jump_ = false;
  bool has_quit_ = false;
};

}  // namespace

std::vector<std::string> split_words(const std::string& line, const Place& place) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < line.size();) {
    if (std::isspace(static_cast<unsigned char>(line[at])) != 0) {
      ++at;
      continue;
    }
    const char quote = line[at] == '"' || line[at] == '\'' ? line[at] : '\0';
    std::size_t end = at;
    if (quote != '\0') {
      end = line.find(quote, ++at);
      if (end == std::string::npos) refuse(place, "a quote that is not closed");
    } else {
      while (end < line.size() && std::isspace(static_cast<unsigned char>(line[end])) == 0) ++end;
    }
    words.push_back(line.substr(at, end - at));
    at = end + (quote != '\0' ? 1 : 0);
  }
  return words;
}

void read_script(const std::string& file, const ReadFile& read_file, const std::vector<std::string>& variables,
                 const std::function<void(const ScriptCommand&)>& visit, std::size_t most_commands) {
  Reader reader(read_file, visit, most_commands);
  for (const std::string& variable : variables) reader.set(variable);
  reader.follow(file, 0);
  reader.check_given(file);
}

}  // namespace repose
