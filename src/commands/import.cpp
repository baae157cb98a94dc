#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"
#include "import/import_script.h"

namespace repose {
namespace {

/// FileError when a file is there that has other bytes: it may have been edited.
void refuse_other_file(const std::string& path, const std::string& bytes) {
  if (!std::filesystem::exists(path) || read_whole_file(path) == bytes) return;
  throw FileError(path + ": is there already, with another content; name another folder");
}

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
    std::string said;
    agree_after_root(process.ranks(), [&] { said = write_deck(); });
    process.say(said);
  }

 private:
  /// Writes the deck and its files; what is to be said of it.
  std::string write_deck() const {
    const std::string name = std::filesystem::path(script_).filename().string();
    const ReadFile read = [&](const std::string& file) {
      return read_whole_file(file == dump_ ? file : path_beside(script_, file));
    };
    const ImportedDeck imported = import_script(name, read, variables_, dump_);
    if (strict_ && !imported.missing.empty()) {
      const std::size_t more = imported.missing.size() - 1;
      throw DeckError(text(imported.missing.front()) + (more > 0 ? fmt::format(" (and {} more)", more) : ""));
    }
    const std::string deck = fmt::format("{}/{}", output_, deck_name(name));
    std::vector<std::pair<std::string, std::string>> files = {{deck, imported.deck}};
    for (const auto& [file, bytes] : imported.files) files.emplace_back(output_ + "/" + file, bytes);
    for (const auto& [path, bytes] : files) refuse_other_file(path, bytes);
    create_output_directory(output_);
    for (const auto& [path, bytes] : files) write_text_file(path, bytes);
    std::string said = deck + "\n";
    for (const Note& note : imported.warnings) said += "warning: " + text(note) + "\n";
    for (const Note& note : imported.missing) said += "without a counterpart: " + text(note) + "\n";
    return said;
  }

  std::string script_;
  std::string output_;
  std::string dump_;
  std::vector<std::string> variables_;
  bool strict_ = false;
};

}  // namespace

std::unique_ptr<Command> import_command() { return std::make_unique<Import>(); }

}  // namespace repose
