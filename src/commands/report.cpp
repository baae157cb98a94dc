#include <cstdio>
#include <memory>
#include <string>

#include "campaign/report_program.h"
#include "comm/agreement.h"
#include "commands/command.h"

namespace repose {
namespace {

class Report : public Command {
 public:
  void declare(Options& options) override {
    options.argument("DIR", directory_, "directory of a run, calibration, validation or sensitivity study");
    options.option("--output", output_, "FILE", "the report; DIR/report.html if not given");
  }

  void carry_out(Process& process) override {
    agree_after_root(process.ranks(), [&] {
      std::fflush(stdout);
      finish_report(*start_report(directory_, output_, ChildProcess::Says::where_we_do));
    });
  }

 private:
  std::string directory_;
  std::string output_;
};

}  // namespace

std::unique_ptr<Command> report_command() { return std::make_unique<Report>(); }

}  // namespace repose
