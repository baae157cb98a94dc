#include "command_line.h"

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace repose {
namespace {

void add_overrides(CLI::App& command, CommandLine& line) {
  command.add_option("--set", line.overrides, "replace a key of the deck, such as time.step=2e-6; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);  // one value for each --set, so that DECK may follow
}

void add_deck_options(CLI::App& command, CommandLine& line) {
  command.add_option("DECK", line.deck, "deck (TOML)")->required();
  add_overrides(command, line);
}

CLI::App* add_measure(CLI::App& app, CommandLine& line) {
  CLI::App* measure = app.add_subcommand("measure", "measure the pile of a finished run, or a list of grains, again");
  measure->add_option("FILE", line.file, "snapshot (.hdf), or CSV with the header x,y,z,radius")->required();
  measure->add_option("--deck", line.deck, "deck (TOML) that says what to measure")->required()->type_name("DECK");
  add_overrides(*measure, line);
  measure->add_option("--output", line.output, "directory of measurement.json and the pictures")->type_name("DIR");
  return measure;
}

CLI::App* add_run(CLI::App& app, CommandLine& line) {
  CLI::App* run = app.add_subcommand("run", "simulate the test that a deck describes");
  add_deck_options(*run, line);
  run->add_option("--output", line.output, "directory of the results")->required()->type_name("DIR");
  run->add_option("--vector-level", line.vector_level, "vector instructions; they change the speed, never the result")
      ->check(CLI::IsMember({"auto", "sse2", "avx2", "avx512"}))
      ->capture_default_str();
  run->add_flag("--quiet", line.quiet, "no progress lines");
  return run;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

}  // namespace

CommandLine parse_command_line(int argc, char** argv) {
  CommandLine line;
  CLI::App app("repose: bulk behaviour of granular materials by the discrete element method", "repose");
  app.require_subcommand(0, 1);
  const CLI::App* run = add_run(app, line);
  CLI::App* check = app.add_subcommand("check", "resolve a deck and print what a run would take");
  add_deck_options(*check, line);
  const CLI::App* measure = add_measure(app, line);
  const CLI::App* keys = app.add_subcommand("keys", "list every key of a deck");
  bool wants_version = false;
  app.add_flag("--version", wants_version, "version, commit, compiler, flags, MPI, HDF5, vector level");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.text = app.help();  // of the subcommand that was named, if any
    return line;
  } catch (const CLI::ParseError& error) {
    throw DeckError(one_line(error.what()) + "; see repose --help");
  }
  if (run->parsed()) line.action = CommandLine::Action::run;
  if (check->parsed()) line.action = CommandLine::Action::check;
  if (measure->parsed()) line.action = CommandLine::Action::measure;
  if (keys->parsed()) line.action = CommandLine::Action::keys;
  if (wants_version) line.action = CommandLine::Action::version;
  if (line.action == CommandLine::Action::none) throw DeckError("nothing to do: name a command; see repose --help");
  return line;
}

}  // namespace repose
