#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "fields/fields_of.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"

namespace repose {
namespace {

class FieldsCommand : public Command {
 public:
  void declare(Options& options) override {
    options.arguments("FILE", files_, "snapshots or checkpoints (.hdf); several are allowed");
    options.option("--output", output_, "DIR", "directory of the fields (.vti) and their series (fields.pvd)",
                   Options::Need::must);
    const Options::Quantity length = {"LENGTH",
                                      Unit::metre,
                                      {.min = 0.0, .max = 1e6, .excludes_min = true},
                                      "a length above 0, such as 0.002 or \"2 mm\""};
    options.quantity("--width", given_.width, length, "half-width of the kernel; three mean diameters if not given");
    options.quantity("--spacing", given_.spacing, length, "of the cells; a third of the width if not given");
    options.option(
        "--deck", deck_, "DECK",
        "deck (TOML) in place of the one in FILE; needed where it reads meshes or lists, which lie beside it");
    declare_overrides(options, overrides_);
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] { text = write_all(); });
    process.say(text);
  }

 private:
  fields::State state_of(const std::string& file) const {
    const ReadFile read_beside = [&](const std::string& name) {
      if (!deck_.empty()) return read_whole_file(path_beside(deck_, name));
      throw DeckError(
          fmt::format("{}: its deck reads {}: name the deck with --deck, beside which it lies", file, name));
    };
    const std::string text = deck_.empty() ? std::string() : read_whole_file(deck_);
    return fields::read_state(read_whole_file(file), file, {text, deck_, overrides_}, read_beside);
  }

  static std::string name_of(std::int64_t step) { return fmt::format("fields_{:010}.vti", step); }

  /// The files with their times. FileError and DeckError for what cannot be read or put into one series.
  std::vector<std::pair<double, std::string>> checked_series() const {
    std::vector<std::pair<double, std::string>> series;
    for (const std::string& file : files_) {
      const fields::State state = state_of(file);
      const std::string name = name_of(state.step);
      if (std::any_of(series.begin(), series.end(), [&](const auto& other) { return other.second == name; })) {
        throw DeckError(fmt::format("{}: another file is of step {}, too; give files of one run", file, state.step));
      }
      series.emplace_back(state.time, name);
    }
    std::sort(series.begin(), series.end());
    return series;
  }

  std::string write_all() const {
    const std::vector<std::pair<double, std::string>> series = checked_series();  // of all, before anything is written
    fields::Resolution resolution = given_;
    std::string text;
    for (const std::string& file : files_) {
      const fields::State state = state_of(file);
      resolution = fields::resolution_for(state, resolution);  // that of the first holds for all
      const fields::FieldsOfFile one = fields::fields_of(state, file, resolution);
      if (text.empty()) create_output_directory(output_);
      write_text_file(output_ + "/" + name_of(one.step), one.vti);
      text += one.lines;
    }
    write_text_file(output_ + "/fields.pvd", fields::series_text(series));
    return text;
  }

  std::vector<std::string> files_;
  std::string output_;
  std::string deck_;
  std::vector<std::string> overrides_;
  fields::Resolution given_;
};

}  // namespace

std::unique_ptr<Command> fields_command() { return std::make_unique<FieldsCommand>(); }

}  // namespace repose
