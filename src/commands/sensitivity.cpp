#include "campaign/sensitivity.h"

#include "commands/command.h"
#include "commands/study_request.h"

namespace repose {
namespace {

class Sensitivity : public Command {
 public:
  void declare(Options& options) override { request_.declare(options, "FILE", "parameters and figures (TOML)"); }

  void carry_out(Process& process) override {
    process.say(sensitivity_file(process.ranks(), request_.run_request(process.ranks()),
                                 process.stop_asked(request_.time_limit)));
  }

 private:
  StudyRequest request_;
};

}  // namespace

std::unique_ptr<Command> sensitivity_command() { return std::make_unique<Sensitivity>(); }

}  // namespace repose
