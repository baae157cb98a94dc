#include <fmt/core.h>

#include "comm/agreement.h"
#include "commands/command.h"
#include "files/atomic_file.h"
#include "files/shared_file.h"
#include "output/particle_export.h"

namespace repose {
namespace {

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
    options.option("--output", output_, "FILE", "file to write", Options::Need::must);
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] {
      const SnapshotParticles snapshot = snapshot_particles(read_whole_file(snapshot_), snapshot_);
      for (const ExportFormat& format : export_formats()) {
        if (format.name == format_) write_text_file(output_, format.text(snapshot));
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
