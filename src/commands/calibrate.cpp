#include "campaign/calibrate.h"

#include "commands/command.h"
#include "commands/study_request.h"

namespace repose {
namespace {

class Calibrate : public Command {
 public:
  void declare(Options& options) override {
    request_.declare(options, "FILE", "parameters, points and laboratory values (TOML)");
  }

  void carry_out(Process& process) override {
    process.say(calibrate_file(process.ranks(), request_.run_request(), process.stop_asked(request_.time_limit)));
  }

 private:
  StudyRequest request_;
};

}  // namespace

std::unique_ptr<Command> calibrate_command() { return std::make_unique<Calibrate>(); }

}  // namespace repose
