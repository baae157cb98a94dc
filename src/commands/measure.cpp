#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include "output/snapshot_reader.h"
#include "photo/photo_file.h"
#include "photo/rendered.h"
#include "run/measurements/measurement.h"
#include "scene/insertion/particle_csv.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

constexpr const char* result_file = "/measurement.json";
constexpr const char* pile_view_file = "/pile_view.png";
constexpr const char* plate_view_file = "/plate_view.png";

FinishedState read_state(const Deck& deck, const std::string& file) {
  const std::string bytes = read_whole_file(file);
  FinishedState state{.deck = deck, .grains = {}, .mass = {}, .left = {}, .directory = {}};
  NewParticles particles;
  if (is_snapshot(bytes)) {
    particles = parse_snapshot(bytes, file, deck.materials);
    state.left = left_before_snapshot(bytes, file);
  } else {
    particles = parse_measured_csv(bytes, file, deck.materials);
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    state.grains.push_back({particles.position[i], particles.radius[i]});
  }
  for (std::size_t i = 0; i < particles.material.size(); ++i) {
    const auto material = static_cast<std::size_t>(particles.material[i]);
    state.mass.push_back(sphere_mass(particles.radius[i], deck.materials[material].density));
  }
  return state;
}

/// The measurements that the deck asks for and a file can answer. DeckError when there is none.
std::vector<const MeasurementKind*> chosen(const Deck& deck) {
  std::vector<const MeasurementKind*> kinds;
  std::vector<std::string> sections;
  for (const MeasurementKind& kind : measurement_kinds()) {
    if (kind.measure == nullptr) continue;
    sections.push_back("[" + kind.section + "]");
    if (kind.is_enabled(deck)) kinds.push_back(&kind);
  }
  if (!kinds.empty()) return kinds;
  const std::string last = sections.back();
  sections.pop_back();
  throw DeckError(fmt::format("nothing to measure: the deck has none of {} and {}", fmt::join(sections, ", "), last));
}

/// Where a measurement writes until all of it has succeeded: what an earlier one has left there would pass for this
/// one's, and must not be lost to one that is refused.
class Staging {
 public:
  explicit Staging(const std::string& output) : output_(output), folder_(output + "/.repose-measure") {
    create_output_directory(output_);
    std::filesystem::remove_all(folder_);
    create_output_directory(folder_);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    std::filesystem::remove(output_, ignored);  // if it is empty: it was made here
  }

  const std::string& folder() const { return folder_; }
  /// In place of an earlier measurement's files. FileError.
  void publish() const {
    for (const char* file : {result_file, pile_view_file, plate_view_file}) remove(output_ + file);
    for (const MeasurementKind& kind : measurement_kinds()) {
      if (kind.measure == nullptr) continue;
      for (const std::string& name : kind.files) remove(output_ + "/" + name);
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      std::filesystem::rename(entry.path(), std::filesystem::path(output_) / entry.path().filename());
    }
  }

 private:
  static void remove(const std::string& path) {
    std::error_code reason;
    std::filesystem::remove(path, reason);
    if (reason) throw FileError(fmt::format("{}: cannot be replaced: {}", path, reason.message()));
  }

  std::string output_;
  std::string folder_;
};

std::string result_text(const FinishedState& state, const std::string& file, const Figures& figures) {
  Figures json = {{"file", file},
                  {"title", state.deck.run.title},
                  {"particles", state.grains.size()},
                  {"left", state.left ? Figures(*state.left) : Figures(nullptr)}};
  json.update(figures);
  json.update(Figures{{"build", json_of(build_info(""))}, {"deck", resolved_deck(state.deck)}});
  return json_text(json);
}

std::string lines_of(const FinishedState& state, const std::vector<const MeasurementKind*>& kinds,
                     const Figures& figures) {
  std::string text =
      fmt::format("{} particles{}\n", state.grains.size(),
                  state.left ? fmt::format(", {} had left the domain before", *state.left) : std::string());
  if (const auto below = number_in(figures, "discharged_mass_kg")) {
    text += fmt::format("below the orifice {:.6g} g, retained {:.6g} g\n", 1e3 * *below,
                        1e3 * number_in(figures, "retained_mass_kg").value_or(0.0));
  }
  if (const auto height = number_in(figures, "pile_height_m")) {
    text += fmt::format("height of the pile {:.4g} mm\n", 1e3 * *height);
  }
  for (const MeasurementKind* kind : kinds) {
    if (kind->section == "measurement.discharge") continue;  // its line speaks of a run
    const std::string lines = kind->lines(figures);
    text += lines.empty() ? absence_of(*kind) + "\n" : lines;
  }
  return text;
}

/// The grains as photographs would show them, for `repose photo`.
void write_views(const FinishedState& state, double pixels_per_mm) {
  const Deck& deck = state.deck;
  if (deck.angle_of_repose.enabled) {
    write_text_file(state.directory + pile_view_file,
                    photo::png_of(photo::rendered_pile(state.grains, deck.angle_of_repose, pixels_per_mm)));
  }
  if (deck.scattering.enabled) {
    write_text_file(state.directory + plate_view_file,
                    photo::png_of(photo::rendered_plate(state.grains, deck.scattering, pixels_per_mm)));
  }
}

class Measure : public Command {
 public:
  void declare(Options& options) override {
    options.argument("FILE", file_, "snapshot (.hdf), or CSV with the header x,y,z,radius");
    options.option("--deck", deck_, "DECK", "deck (TOML) that says what to measure", Options::Need::must);
    declare_overrides(options, overrides_);
    options.option("--output", output_, "DIR", "directory of measurement.json and the pictures");
    options.parsed(
        "--pixels-per-mm", [this](const std::string& text) { read_pixels_per_mm(text); }, "NUMBER",
        "also draw the views as photographs of this scale");
  }

  void carry_out(Process& process) override {
    const Deck deck = read_deck(read_shared_file(process.ranks(), deck_), deck_, overrides_);
    std::string text;
    agree_after_root(process.ranks(), [&] { text = measure(deck); });
    process.say(text);
  }

 private:
  void read_pixels_per_mm(const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, pixels_per_mm_);
    if (error != std::errc() || rest != end || !(pixels_per_mm_ > 0.0) || std::isinf(pixels_per_mm_)) {
      throw DeckError(fmt::format("--pixels-per-mm {}: must be a number above 0, such as 40", text));
    }
  }

  std::string measure(const Deck& deck) const {
    if (pixels_per_mm_ > 0.0 && output_.empty()) {
      throw DeckError("--pixels-per-mm needs --output, the directory of the views");
    }
    const std::vector<const MeasurementKind*> kinds = chosen(deck);
    FinishedState state = read_state(deck, file_);
    std::optional<Staging> staging;
    if (!output_.empty()) state.directory = staging.emplace(output_).folder();
    Figures figures = no_figures(Figure::From::grains);
    for (const MeasurementKind* kind : kinds) kind->measure(state, figures);
    if (pixels_per_mm_ > 0.0) write_views(state, pixels_per_mm_);
    if (staging) {
      staging->publish();
      write_text_file(output_ + result_file, result_text(state, file_, figures));
    }
    return lines_of(state, kinds, figures);
  }

  std::string file_;
  std::string deck_;
  std::vector<std::string> overrides_;
  std::string output_;
  double pixels_per_mm_ = 0.0;
};

}  // namespace

std::unique_ptr<Command> measure_command() { return std::make_unique<Measure>(); }

}  // namespace repose
