#include "commands/command_line.h"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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

/// Seconds of "HH:MM:SS" or "D-HH:MM:SS", as batch systems write time limits.
double seconds_of(const std::string& time_limit) {
  unsigned days = 0;
  unsigned hours = 0;
  unsigned minutes = 0;
  unsigned seconds = 0;
  int end = 0;
  const char* text = time_limit.c_str();
  const bool plain = time_limit.find_first_not_of("0123456789:-") == std::string::npos && time_limit.size() < 16;
  const bool with_days = plain && std::sscanf(text, "%u-%u:%2u:%2u%n", &days, &hours, &minutes, &seconds, &end) == 4;
  if (!with_days) {
    days = 0;
    if (!plain || std::sscanf(text, "%u:%2u:%2u%n", &hours, &minutes, &seconds, &end) != 3) end = -1;
  }
  if (end != static_cast<int>(time_limit.size()) || minutes > 59 || seconds > 59) {
    throw DeckError(fmt::format("--time-limit {}: HH:MM:SS or D-HH:MM:SS was expected", time_limit));
  }
  return 86400.0 * days + 3600.0 * hours + 60.0 * minutes + seconds;
}

CLI::App* add_measure(CLI::App& app, CommandLine& line) {
  CLI::App* measure = app.add_subcommand("measure", "measure the pile of a finished run, or a list of grains, again");
  measure->add_option("FILE", line.file, "snapshot (.hdf), or CSV with the header x,y,z,radius")->required();
  measure->add_option("--deck", line.deck, "deck (TOML) that says what to measure")->required()->type_name("DECK");
  add_overrides(*measure, line);
  measure->add_option("--output", line.output, "directory of measurement.json and the pictures")->type_name("DIR");
  return measure;
}

CLI::App* add_info(CLI::App& app, CommandLine& line) {
  CLI::App* info = app.add_subcommand("info", "what is in a snapshot, a checkpoint or the grid of a calibration");
  info->add_option("FILE", line.file, "snapshot or checkpoint (.hdf), or grid.h5")->required();
  return info;
}

CLI::App* add_export(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("export", "write the grains of a snapshot for other programs");
  command->add_option("SNAPSHOT", line.file, "snapshot (.hdf)")->required();
  command->add_option("--format", line.format, "vtp: PolyData of VTK; csv: a list that measure and decks read")
      ->required()
      ->check(CLI::IsMember({"vtp", "csv"}));
  command->add_option("--output", line.output, "file to write")->required()->type_name("FILE");
  return command;
}

/// What the commands that run decks have in common.
void add_run_options(CLI::App& command, CommandLine& line) {
  command.add_option("--output", line.output, "directory of the results")->required()->type_name("DIR");
  command
      .add_option("--vector-level", line.vector_level, "vector instructions; they change the speed, never the result")
      ->check(CLI::IsMember({"auto", "sse2", "avx2", "avx512"}))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--time-limit", [&](const std::string& limit) { line.time_limit = seconds_of(limit); },
          "stop in time with a checkpoint and exit code 75")
      ->type_name("HH:MM:SS");
  command.add_flag("--quiet", line.quiet, "no progress lines");
}

CLI::App* add_run(CLI::App& app, CommandLine& line) {
  CLI::App* run = app.add_subcommand("run", "simulate the test that a deck describes");
  add_deck_options(*run, line);
  add_run_options(*run, line);
  run->add_flag("--restart", line.restart,
                "go on from the newest checkpoint in DIR, on any number of ranks; without one begin");
  return run;
}

/// A command that runs decks as a file of its own kind says.
CLI::App* add_study(CLI::App& app, CommandLine& line, const std::string& name, const std::string& what,
                    const std::string& file) {
  CLI::App* study = app.add_subcommand(name, what);
  study->add_option("FILE", line.deck, file)->required();
  add_overrides(*study, line);
  add_run_options(*study, line);
  return study;
}

CLI::App* add_validate(CLI::App& app, CommandLine& line) {
  CLI::App* validate =
      add_study(app, line, "validate", "run cases and compare their figures with those of a laboratory",
                "cases and values to compare with (TOML)");
  validate->add_option("--case", line.cases, "only this case; repeatable")->type_name("NAME")->allow_extra_args(false);
  return validate;
}

CLI::App* add_estimate(CLI::App& app, CommandLine& line) {
  CLI::App* estimate = app.add_subcommand("estimate", "estimate again from the runs of a calibration");
  estimate->add_option("DIR", line.file, "directory of the calibration")->required();
  estimate->add_option("--deck", line.deck, "calibration (TOML) with other laboratory values")->type_name("FILE");
  return estimate;
}

/// A tool that takes data takes its deck as an option, like measure; one that takes none, as its argument.
void add_thermal_tool(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& files,
                      const std::string& what) {
  CLI::App* tool = parent.add_subcommand(name, what);
  if (files == "FILE") tool->add_option(files, line.files, "data; several are allowed")->required();
  if (files == "FILES") tool->add_option(files, line.files, "two files")->required()->expected(2)->type_name("A B");
  tool->add_option(files.empty() ? "DECK" : "--deck", line.deck, "deck (TOML)")->required()->type_name("DECK");
  add_overrides(*tool, line);
  tool->add_option("--output", line.output, "directory of the JSON result")->type_name("DIR");
  tool->callback([&line, name] {
    line.action = CommandLine::Action::thermal;
    line.tool = name;
  });
}

void add_thermal(CLI::App& app, CommandLine& line) {
  CLI::App* thermal = app.add_subcommand("thermal", "thermal properties of beds, and of measurements of them");
  thermal->require_subcommand(1);
  add_thermal_tool(*thermal, line, "bed", "", "conductivity of a bed by Zehner, Bauer and Schluender");
  add_thermal_tool(*thermal, line, "network", "FILE", "conductivity of simulated beds from snapshots or CSV");
  add_thermal_tool(*thermal, line, "tps", "FILE", "evaluate transients (CSV) of a plane source");
  add_thermal_tool(*thermal, line, "synthesise", "", "make up a transient of a plane source");
  add_thermal_tool(*thermal, line, "sensor", "", "correct readings for the insulation of the sensor");
  add_thermal_tool(*thermal, line, "mixture", "", "heat capacity of a bed with and without its air");
  add_thermal_tool(app, line, "compare", "FILES", "are two sets of repeated measurements (CSV) equivalent?");
}

std::string joined_lines(std::string text) {
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
  const CLI::App* info = add_info(app, line);
  const CLI::App* exported = add_export(app, line);
  const CLI::App* validate = add_validate(app, line);
  const CLI::App* calibrate = add_study(
      app, line, "calibrate", "run a deck over a grid of parameters and find those that give the laboratory's figures",
      "parameters, points and laboratory values (TOML)");
  const CLI::App* estimate = add_estimate(app, line);
  const CLI::App* sensitivity = add_study(app, line, "sensitivity", "what each parameter does to the figures of a deck",
                                          "parameters and figures (TOML)");
  add_thermal(app, line);
  const CLI::App* keys = app.add_subcommand("keys", "list every key of a deck");
  bool wants_version = false;
  app.add_flag("--version", wants_version, "version, commit, compiler, flags, MPI, HDF5, vector level");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.text = app.help();  // of the subcommand that was named, if any
    return line;
  } catch (const CLI::ParseError& error) {
    throw DeckError(joined_lines(error.what()) + "; see repose --help");
  }
  if (run->parsed()) line.action = CommandLine::Action::run;
  if (check->parsed()) line.action = CommandLine::Action::check;
  if (measure->parsed()) line.action = CommandLine::Action::measure;
  if (info->parsed()) line.action = CommandLine::Action::info;
  if (exported->parsed()) line.action = CommandLine::Action::export_file;
  if (validate->parsed()) line.action = CommandLine::Action::validate;
  if (calibrate->parsed()) line.action = CommandLine::Action::calibrate;
  if (estimate->parsed()) line.action = CommandLine::Action::estimate;
  if (sensitivity->parsed()) line.action = CommandLine::Action::sensitivity;
  if (keys->parsed()) line.action = CommandLine::Action::keys;
  if (wants_version) line.action = CommandLine::Action::version;
  if (line.action == CommandLine::Action::none) throw DeckError("nothing to do: name a command; see repose --help");
  return line;
}

}  // namespace repose
