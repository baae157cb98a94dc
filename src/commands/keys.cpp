#include "commands/command.h"
#include "deck/resolved_deck.h"

namespace repose {
namespace {

class Keys : public Command {
 public:
  void carry_out(Process& process) override { process.say(key_reference()); }
};

}  // namespace

std::unique_ptr<Command> keys_command() { return std::make_unique<Keys>(); }

}  // namespace repose
