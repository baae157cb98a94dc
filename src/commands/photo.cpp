#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/json_text.h"
#include "files/shared_file.h"
#include "output/build_info.h"
#include "photo/photo_tool.h"

namespace repose {
namespace {

/// repose photo pile and repose photo plate.
class Photo : public Command {
 public:
  using Tool = photo::PhotoResult (*)(const std::vector<photo::PhotoFile>&, const photo::PhotoDeck&, const Deck&);
  Photo(std::string name, Tool tool) : name_(std::move(name)), tool_(tool) {}

  void declare(Options& options) override {
    options.arguments("PHOTO", files_, "photographs (JPEG, PNG or TIFF); several are allowed");
    options.option("--deck", deck_, "FILE", "photo deck (TOML): scale, and the deck that says what is measured",
                   Options::Need::must);
    declare_overrides(options, overrides_);
    options.option("--output", output_, "DIR", fmt::format("directory of {}.json and the pictures", name_));
    options.option("--calibration", calibration_, "FILE", "calibration (TOML) to write the observables into");
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] { text = measure(); });
    process.say(text);
  }

 private:
  std::string measure() const {
    const std::string deck_text = read_whole_file(deck_);
    const photo::PhotoDeck deck = photo::read_photo_deck(deck_text, deck_, overrides_);
    const std::string base_path = path_beside(deck_, deck.base);
    const Deck base = read_deck(read_whole_file(base_path), base_path, deck.set);
    std::vector<photo::PhotoFile> photographs;
    for (const std::string& file : files_) {
      if (std::count(files_.begin(), files_.end(), file) > 1) {
        throw DeckError(fmt::format("{}: is named twice; each photograph counts as a measurement of its own", file));
      }
      photographs.push_back({file, read_whole_file(file)});
    }
    const photo::PhotoResult result = tool_(photographs, deck, base);
    // Both results are made before the first is written.
    const std::string calibration =
        calibration_.empty() ? std::string()
                             : photo::with_observables(read_whole_file(calibration_), calibration_, result.figures);
    if (!output_.empty()) write(result, deck_text, base);
    if (!calibration_.empty()) {
      write_text_file(calibration_, calibration);
      return result.text + fmt::format("written into {}\n", calibration_);
    }
    return result.text + "\n" + photo::observable_text(result.figures);
  }

  void write(const photo::PhotoResult& result, const std::string& deck_text, const Deck& base) const {
    create_output_directory(output_);
    const std::string json_file = fmt::format("{}/{}.json", output_, name_);
    std::filesystem::remove(json_file);
    photo::Json json = result.json;
    for (std::size_t i = 0; i < result.pictures.size(); ++i) {
      const std::string picture = fmt::format("{}_{}", name_, i + 1);
      write_picture(output_ + "/" + picture, result.pictures[i]);
      json["photographs"][i]["picture"] = picture + ".png";
    }
    json["observables"] = photo::observable_text(result.figures);
    json["photo_deck"] = {{"file", deck_}, {"set", overrides_}, {"text", deck_text}};
    json["deck"] = resolved_deck(base);
    json["build"] = json_of(build_info(""));
    write_text_file(json_file, json_text(json));
  }

  std::string name_;
  Tool tool_;
  std::vector<std::string> files_;
  std::string deck_;
  std::vector<std::string> overrides_;
  std::string output_;
  std::string calibration_;
};

}  // namespace

std::unique_ptr<Command> photo_pile_command() { return std::make_unique<Photo>("pile", photo::measure_piles); }
std::unique_ptr<Command> photo_plate_command() { return std::make_unique<Photo>("plate", photo::measure_plates); }

}  // namespace repose
