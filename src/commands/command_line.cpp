#include "commands/command_line.h"

#include <algorithm>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "base/error.h"
#include "base/vector_level.h"
#include "deck/nearest.h"
#include "output/build_info.h"

namespace repose {
namespace {

/// --help and --version.
class Text : public Command {
 public:
  explicit Text(std::string text) : text_(std::move(text)) {}
  void carry_out(Process& process) override { process.say(text_); }

 private:
  std::string text_;
};

std::string nothing_named(const std::string& path) {
  return fmt::format("nothing to do: name a command; see {} --help", path);
}

std::string joined_lines(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// The first option of the command line that the command does not have; empty when it has all.
std::string unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true)) {
    if (word.size() > 1 && word[0] == '-') return word.substr(0, word.find('='));
  }
  return {};
}

std::string no_option(const std::string& word, const CLI::App& command, const std::string& path) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  if (std::find(names.begin(), names.end(), word) != names.end()) {
    return fmt::format("\"{}\" belongs behind the command: {} {} ...; see {} --help", word, path, word, path);
  }
  return fmt::format("there is no option \"{}\"; did you mean {}? {} --help lists them", word, nearest(word, names),
                     path);
}

/// What is wrong with a command line that CLI11 does not take, and whose help tells more: that of the command, the
/// group or the program that was named last.
std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* named = &app;
  std::string path = app.get_name();
  int words = 1;
  for (; !named->get_subcommands().empty(); ++words) {
    named = named->get_subcommands().front();
    path += " " + named->get_name();
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : named->get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  if (const std::string unknown = unknown_option(app); commands.empty() && !unknown.empty()) {
    return no_option(unknown, *named, path);  // it may be meant for what is required
  }
  if (commands.empty() || (words < argc && argv[words][0] == '-')) {
    return fmt::format("{}; see {} --help", joined_lines(error.what()), path);
  }
  if (words == argc) return nothing_named(path);
  return fmt::format("there is no command \"{}\"; did you mean {}? {} --help lists them", argv[words],
                     nearest(argv[words], commands), path);
}

/// A command of the help and what carries it out.
struct Offer {
  const CommandEntry& entry;
  const CLI::App* app;
  std::unique_ptr<Command> command;
};

std::vector<Offer> offer_commands(CLI::App& app) {
  std::vector<Offer> offers;
  std::map<std::string, CLI::App*> groups;
  for (const CommandEntry& entry : command_entries()) {
    const std::size_t space = entry.name.find(' ');
    CLI::App* parent = &app;
    if (space != std::string::npos) {
      CLI::App*& group = groups[entry.name.substr(0, space)];
      if (group == nullptr) {
        group = app.add_subcommand(entry.name.substr(0, space), group_meaning(entry.name.substr(0, space)));
        group->require_subcommand(1);
      }
      parent = group;
    }
    CLI::App* command = parent->add_subcommand(entry.name.substr(space + 1), entry.meaning);  // npos + 1 is 0
    offers.push_back({entry, command, entry.make()});
    Options options(*command);
    offers.back().command->declare(options);
  }
  return offers;
}

}  // namespace

CommandLine parse_command_line(int argc, char** argv) {
  CLI::App app("repose: bulk behaviour of granular materials by the discrete element method", "repose");
  app.require_subcommand(0, 1);
  std::vector<Offer> offers = offer_commands(app);
  bool wants_version = false;
  app.add_flag("--version", wants_version, "version, commit, compiler, flags, MPI, HDF5, vector level");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {std::make_unique<Text>(app.help())};  // of the subcommand that was named, if any
  } catch (const CLI::ParseError& error) {
    throw DeckError(refusal(app, error, argc, argv));
  }
  if (wants_version) return {std::make_unique<Text>(version_text(to_string(best_vector_level())))};
  for (Offer& offer : offers) {
    if (offer.app->parsed()) return {std::move(offer.command), offer.entry.need};
  }
  throw DeckError(nothing_named(app.get_name()));
}

}  // namespace repose
