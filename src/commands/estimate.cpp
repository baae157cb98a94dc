#include "campaign/calibrate.h"
#include "commands/command.h"

namespace repose {
namespace {

class Estimate : public Command {
 public:
  void declare(Options& options) override {
    options.argument("DIR", directory_, "directory of the calibration");
    options.option("--deck", deck_, "FILE", "calibration (TOML) with other laboratory values");
  }

  void carry_out(Process& process) override { process.say(estimate_directory(process.ranks(), directory_, deck_)); }

 private:
  std::string directory_;
  std::string deck_;
};

}  // namespace

std::unique_ptr<Command> estimate_command() { return std::make_unique<Estimate>(); }

}  // namespace repose
