#include <functional>
#include <map>

#include <fmt/ranges.h>

#include "base/error.h"
#include "commands/command.h"
#include "deck/calibration_deck.h"
#include "deck/nearest.h"
#include "deck/resolved_deck.h"
#include "deck/sensitivity_deck.h"
#include "deck/validation_deck.h"
#include "photo/photo_deck.h"
#include "thermal/plane_source/tps_deck.h"
#include "thermal/tools/bed_tool.h"
#include "thermal/tools/compare_tool.h"
#include "thermal/tools/mixture_tool.h"
#include "thermal/tools/network_tool.h"
#include "thermal/tools/sensor_tool.h"

namespace repose {
namespace {

std::string keys_of(const std::string& command) {
  static const std::map<std::string, std::function<std::string()>> files = {{"run", deck_keys},
                                                                            {"calibrate", calibration_keys},
                                                                            {"sensitivity", sensitivity_keys},
                                                                            {"validate", validation_keys},
                                                                            {"photo", photo::photo_keys},
                                                                            {"photo pile", photo::photo_keys},
                                                                            {"photo plate", photo::photo_keys},
                                                                            {"compare", thermal::compare_keys},
                                                                            {"thermal bed", thermal::bed_keys},
                                                                            {"thermal mixture", thermal::mixture_keys},
                                                                            {"thermal network", thermal::network_keys},
                                                                            {"thermal sensor", thermal::sensor_keys},
                                                                            {"thermal synthesise", thermal::tps_keys},
                                                                            {"thermal tps", thermal::tps_keys}};
  if (const auto found = files.find(command); found != files.end()) return found->second();
  std::vector<std::string> names;
  std::vector<std::string> tools;  // of this command
  for (const auto& [name, keys] : files) {
    names.push_back(name);
    if (name.rfind(command + ' ', 0) == 0) tools.push_back(name);
  }
  if (const std::string near = nearest(command, names); tools.empty() && edit_distance(command, near) <= 2) {
    tools.push_back(near);
  }
  if (tools.empty()) {
    throw DeckError(fmt::format("there are no keys of \"{}\", but of {}", command, fmt::join(names, ", ")));
  }
  throw DeckError(fmt::format("there are no keys of \"{}\"; did you mean {}?", command, fmt::join(tools, ", ")));
}

class Keys : public Command {
 public:
  void declare(Options& options) override {
    options.argument("COMMAND", command_,
                     "whose file: run (the default), calibrate, sensitivity, validate, photo, compare or thermal",
                     Options::Need::may);
    options.argument("TOOL", tool_,
                     "of thermal: bed, mixture, network, sensor, synthesise or tps; of photo: pile or plate",
                     Options::Need::may);
  }
  void carry_out(Process& process) override {
    process.say(keys_of(tool_.empty() ? command_ : fmt::format("{} {}", command_, tool_)));
  }

 private:
  std::string command_ = "run";
  std::string tool_;
};

}  // namespace

std::unique_ptr<Command> keys_command() { return std::make_unique<Keys>(); }

}  // namespace repose
