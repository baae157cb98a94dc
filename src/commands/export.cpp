#include <filesystem>
#include <fstream>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "files/atomic_file.h"
#include "files/shared_file.h"
#include "output/particle_export.h"

namespace repose {
namespace {

/// FileError when `path` is there and is no earlier export in the same format.
void refuse_no_export(const std::string& path, const ExportFormat& format) {
  if (!std::filesystem::is_regular_file(path)) return;
  std::string beginning(1 << 13, '\0');
  std::ifstream(path, std::ios::binary).read(beginning.data(), std::ssize(beginning));
  if (beginning.find(format.mark) != std::string::npos) return;
  throw FileError(path + ": is there already, and is no export in this format; name another file");
}

class Export : public Command {
 public:
  void declare(Options& options) override {
    options.argument("SNAPSHOT", snapshot_, "snapshot (.hdf)");
    std::vector<std::string> names;
    std::string meaning;
    for (const ExportFormat& format : export_formats()) {
      names.push_back(format.name);
      meaning += fmt::format("{}{}: {}", meaning.empty() ? "" : "; ", format.name, format.meaning);
    }
    options.choice("--format", format_, names, meaning, Options::Need::must);
    options.option("--output", output_, "FILE", "file to write; an earlier export in the same format is replaced",
                   Options::Need::must);
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] {
      const SnapshotParticles snapshot = snapshot_particles(read_whole_file(snapshot_), snapshot_);
      std::error_code absent;
      if (std::filesystem::equivalent(snapshot_, output_, absent)) {
        throw FileError(output_ + ": is the snapshot itself; name another file");
      }
      for (const ExportFormat& format : export_formats()) {
        if (format.name != format_) continue;
        refuse_no_export(output_, format);
        write_text_file(output_, format.text(snapshot));
      }
      text = fmt::format("{} particles in {}\n", snapshot.particles.size(), output_);
    });
    process.say(text);
  }

 private:
  std::string snapshot_;
  std::string format_;
  std::string output_;
};

}  // namespace

std::unique_ptr<Command> export_command() { return std::make_unique<Export>(); }

}  // namespace repose
