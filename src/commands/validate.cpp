#include "campaign/validate.h"

#include "commands/command.h"
#include "commands/study_request.h"

namespace repose {
namespace {

class Validate : public Command {
 public:
  void declare(Options& options) override {
    request_.declare(options, "FILE", "cases and values to compare with (TOML)");
    options.repeatable("--case", cases_, "NAME", "only this case; repeatable");
  }

  void carry_out(Process& process) override {
    process.say(validate_file(process.ranks(), request_.run_request(process.ranks()), cases_,
                              process.stop_asked(request_.time_limit)));
  }

 private:
  StudyRequest request_;
  std::vector<std::string> cases_;
};

}  // namespace

std::unique_ptr<Command> validate_command() { return std::make_unique<Validate>(); }

}  // namespace repose
