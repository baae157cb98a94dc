#include "campaign/calibrate.h"

#include "commands/command.h"
#include "commands/study_request.h"

namespace repose {
namespace {

class Calibrate : public Command {
 public:
  void declare(Options& options) override {
    request_.declare(options, "FILE", "parameters, points and laboratory values (TOML)");
    options.option("--report", report_, "FILE", "a report (HTML), renewed while the runs go on and at the end");
  }

  void carry_out(Process& process) override {
    process.say(calibrate_file(process.ranks(), request_.run_request(process.ranks()),
                               process.stop_asked(request_.time_limit), report_));
  }

 private:
  StudyRequest request_;
  std::string report_;
};

}  // namespace

std::unique_ptr<Command> calibrate_command() { return std::make_unique<Calibrate>(); }

}  // namespace repose
