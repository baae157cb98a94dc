#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "commands/command.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"
#include "import/import_script.h"

namespace repose {
namespace {

class Import : public Command {
 public:
  void declare(Options& options) override {
    options.argument("SCRIPT", script_, "input script of LIGGGHTS");
    options.option("--output", output_, "DIR", "folder of the deck and its files", Options::Need::must);
    options.option("--dump", dump_, "FILE", "text dump whose grains are there at the start, in place of insertions");
    options.repeatable("--var", variables_, "NAME=VALUE", "a variable of the script, as LIGGGHTS's -var; repeatable");
    options.flag("--strict", strict_, "a command without a counterpart is an error");
  }

  void carry_out(Process& process) override {
    const std::string name = std::filesystem::path(script_).filename().string();
    const ReadFile read = [&](const std::string& file) {
      return read_whole_file(file == dump_ ? file : path_beside(script_, file));
    };
    const ImportedDeck imported = import_script(name, read, variables_, dump_);
    if (strict_ && !imported.missing.empty()) {
      const std::size_t more = imported.missing.size() - 1;
      throw DeckError(text(imported.missing.front()) + (more > 0 ? fmt::format(" (and {} more)", more) : ""));
    }
    create_output_directory(output_);
    for (const auto& [file, bytes] : imported.files) write_text_file(output_ + "/" + file, bytes);
    write_text_file(output_ + "/" + deck_name(name), imported.deck);
    std::string said = fmt::format("{}/{}\n", output_, deck_name(name));
    for (const Note& note : imported.missing) said += "without a counterpart: " + text(note) + "\n";
    process.say(said);
  }

 private:
  std::string script_;
  std::string output_;
  std::string dump_;
  std::vector<std::string> variables_;
  bool strict_ = false;
};

}  // namespace

std::unique_ptr<Command> import_command() { return std::make_unique<Import>(); }

}  // namespace repose
