#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
#include "commands/ready_tests.h"
#include "deck/nearest.h"
#include "deck/read_deck.h"
#include "deck/scaled_deck.h"
#include "files/atomic_file.h"
#include "run/run_plan.h"

namespace repose {
namespace {

/// The tests, a line each: the titles of their decks.
std::string list_of_tests() {
  std::string text;
  for (const ReadyTest& test : ready_tests()) {
    text += fmt::format("{:<22}{}\n", test.name, read_deck(test.deck, test.name + ".toml", {}).run.title);
  }
  return text;
}

const ReadyTest& test_named(const std::string& name) {
  std::vector<std::string> names;
  for (const ReadyTest& test : ready_tests()) {
    if (test.name == name) return test;
    names.push_back(test.name);
  }
  throw DeckError(
      fmt::format("there is no ready test \"{}\"; did you mean {}? repose new lists them", name, nearest(name, names)));
}

/// Mean diameter of the grains of a ready test, in m.
double diameter_of(const ParticlesDeck& block) {
  const SizesDeck& sizes = block.sizes;
  return sizes.enabled ? 0.5 * (sizes.min_diameter + sizes.max_diameter) : block.diameter;
}

std::size_t place_of(const std::vector<MaterialDeck>& materials, const std::string& name) {
  std::size_t place = 0;
  while (materials.at(place).name != name) ++place;
  return place;
}

class New : public Command {
 public:
  void declare(Options& options) override {
    options.argument("TEST", test_, "one of the tests that repose new lists", Options::Need::may);
    options.quantity("--diameter", diameter_, {"LENGTH", Unit::metre, above(0), "a length above 0, such as \"440 um\""},
                     "of the grains");
    options.quantity("--density", density_,
                     {"DENSITY", Unit::density, above(0), "a density above 0, such as 2500 or \"2.5 g/cm3\""},
                     "of the grains");
    options.quantity("--grains", grains_,
                     {"NUMBER", Unit::none, from_to_below(100, 1e9), "a number from 100 to less than 1e9"},
                     "how many; the apparatus becomes larger or smaller by the cube root");
    options.quantity("--youngs-modulus", youngs_modulus_,
                     {"PRESSURE", Unit::pascal, above(0), "a pressure above 0, such as 5e6 or \"5 MPa\""},
                     "of grains and walls; as soft as in the test if not given");
    const Options::Quantity coefficient = {"NUMBER", Unit::none, at_least(0), "a number, 0 at least"};
    options.quantity("--restitution", restitution_, {"NUMBER", Unit::none, from_to(0, 1), "a number from 0 to 1"},
                     "between grains");
    options.quantity("--sliding-friction", sliding_friction_, coefficient, "between grains");
    options.quantity("--rolling-friction", rolling_friction_, coefficient, "between grains");
    options.option("--output", output_, "FILE", "deck to write, which must not be there; printed if not given");
  }

  void carry_out(Process& process) override {
    if (test_.empty()) {
      process.say(list_of_tests());
      return;
    }
    std::string text;
    agree_after_root(process.ranks(), [&] {
      text = deck_text();
      if (output_.empty()) return;
      if (std::filesystem::exists(output_)) throw FileError(output_ + ": is there already; name another file");
      write_text_file(output_, text);
      text = output_ + "\n";
    });
    process.say(text);
  }

 private:
  std::string deck_text() const {
    const ReadyTest& test = test_named(test_);
    const std::string path = test.name + ".toml";
    const Deck deck = read_deck(test.deck, path, {});
    const std::string text = scaled_deck(test.deck, path, scale_for(deck));
    check(read_deck(text, output_.empty() ? path : output_, {}));
    return text;
  }

  /// DeckError when a run of the deck could not be set up, as far as that is soon said: it is small apparatus that the
  /// grains do not fit into.
  void check(const Deck& deck) const {
    constexpr double most = 1e6;
    if (static_cast<double>(deck.particles.front().count) > most) return;
    try {
      const RunPlan plan(deck, [](const std::string& file) -> std::string {
        throw FileError(fmt::format("{}: a ready test reads no files", file));
      });
    } catch (const DeckError& error) {
      throw DeckError(fmt::format("{} of this size cannot be set up; take more --grains: {}", test_, error.what()));
    }
  }

  DeckScale scale_for(const Deck& deck) const {
    const ParticlesDeck& block = deck.particles.front();
    const std::size_t material = place_of(deck.materials, block.material);
    DeckScale scale;
    if (!std::isnan(diameter_)) scale.grains = diameter_ / diameter_of(block);
    scale.lengths = scale.grains;
    if (!std::isnan(grains_)) scale.lengths *= std::cbrt(grains_ / static_cast<double>(block.count));
    const auto give = [&scale](const std::string& key, double value) {
      if (!std::isnan(value)) scale.given[key] = value;
    };
    if (!std::isnan(density_)) scale.density = density_ / deck.materials[material].density;
    give(fmt::format("material.{}.density", material), density_);
    for (std::size_t m = 0; m < deck.materials.size(); ++m) {
      give(fmt::format("material.{}.youngs_modulus", m), youngs_modulus_);
    }
    give("pair.0.restitution", restitution_);
    give("pair.0.sliding_friction", sliding_friction_);
    give("pair.0.rolling_friction", rolling_friction_);
    return scale;
  }

  std::string test_;
  double diameter_ = unset;
  double density_ = unset;
  double grains_ = unset;
  double youngs_modulus_ = unset;
  double restitution_ = unset;
  double sliding_friction_ = unset;
  double rolling_friction_ = unset;
  std::string output_;
};

}  // namespace

std::unique_ptr<Command> new_command() { return std::make_unique<New>(); }

}  // namespace repose
