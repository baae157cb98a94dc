#include <map>

#include "commands/command.h"

namespace repose {

std::unique_ptr<Command> run_command();
std::unique_ptr<Command> check_command();
std::unique_ptr<Command> measure_command();
std::unique_ptr<Command> info_command();
std::unique_ptr<Command> export_command();
std::unique_ptr<Command> fields_command();
std::unique_ptr<Command> validate_command();
std::unique_ptr<Command> calibrate_command();
std::unique_ptr<Command> estimate_command();
std::unique_ptr<Command> sensitivity_command();
std::unique_ptr<Command> report_command();
std::unique_ptr<Command> thermal_bed_command();
std::unique_ptr<Command> thermal_network_command();
std::unique_ptr<Command> thermal_tps_command();
std::unique_ptr<Command> thermal_synthesise_command();
std::unique_ptr<Command> thermal_sensor_command();
std::unique_ptr<Command> thermal_mixture_command();
std::unique_ptr<Command> compare_command();
std::unique_ptr<Command> photo_pile_command();
std::unique_ptr<Command> photo_plate_command();
std::unique_ptr<Command> import_command();
std::unique_ptr<Command> new_command();
std::unique_ptr<Command> keys_command();

const std::vector<CommandEntry>& command_entries() {
  constexpr auto ranks = Process::Need::ranks;
  static const std::vector<CommandEntry> entries = {
      {"run", "simulate the test that a deck describes", run_command, ranks},
      {"check", "resolve a deck, or those of a study, and print what the runs would take", check_command},
      {"measure", "measure the pile of a finished run, or a list of grains, again", measure_command},
      {"info", "what is in a snapshot, a checkpoint or the grid of a calibration", info_command},
      {"export", "write the grains of a snapshot for other programs", export_command},
      {"fields", "density, velocity and stress of the continuum that the grains of snapshots make", fields_command},
      {"validate", "run cases and compare their figures with those of a laboratory", validate_command, ranks},
      {"calibrate", "run a deck over a grid of parameters and find those that give the laboratory's figures",
       calibrate_command, ranks},
      {"estimate", "estimate again from the runs of a calibration", estimate_command},
      {"sensitivity", "what each parameter does to the figures of a deck", sensitivity_command, ranks},
      {"report", "one HTML file of what a run, a calibration, a validation or a sensitivity study has left",
       report_command},
      {"thermal bed", "conductivity of a bed by Zehner, Bauer and Schluender", thermal_bed_command},
      {"thermal network", "conductivity of simulated beds from snapshots or CSV", thermal_network_command},
      {"thermal tps", "evaluate transients (CSV) of a plane source", thermal_tps_command},
      {"thermal synthesise", "make up a transient of a plane source", thermal_synthesise_command},
      {"thermal sensor", "correct readings for the insulation of the sensor", thermal_sensor_command},
      {"thermal mixture", "heat capacity of a bed with and without its air", thermal_mixture_command},
      {"compare", "are two sets of repeated measurements (CSV) equivalent?", compare_command},
      {"photo pile", "measure the angle of repose on photographs of a pile", photo_pile_command},
      {"photo plate", "count scattered grains on photographs from above", photo_plate_command},
      {"import", "make a deck of an input script of LIGGGHTS", import_command},
      {"new", "write the deck of a ready test, sized for given grains", new_command},
      {"keys", "list every key of a deck, or of the file of another command", keys_command},
  };
  return entries;
}

std::string group_meaning(const std::string& group) {
  static const std::map<std::string, std::string> meanings = {
      {"thermal", "thermal properties of beds, and of measurements of them"},
      {"photo", "photographs of the laboratory, measured as simulated piles are"},
  };
  return meanings.at(group);
}

}  // namespace repose
