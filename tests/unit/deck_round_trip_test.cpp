#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "deck/calibration_deck.h"
#include "deck/deck.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "deck/sensitivity_deck.h"
#include "deck/validation_deck.h"
#include "deck/value_text.h"
#include "deck_example.h"
#include "support/input_decks.h"

namespace repose {
namespace {

/// A visitor that lists every member of a deck, whether its key applies or not.
class Members {
 public:
  template <class T>
  void operator()(std::string_view key, T& value, Unit, const Range&, const Presence&, std::string_view) {
    keys[section_].insert(std::string(key));
    values[child(path_, key)] = toml_text(value);
  }
  template <class S>
  void section(std::string_view name, S& value, const Presence&, std::string_view) {
    if constexpr (requires { value.enabled; }) values[child(path_, name)] = toml_text(value.enabled);
    visit(group_ + std::string(name), child(path_, name), value);
  }
  template <class S>
  void sections(std::string_view name, std::vector<S>& all, const Presence&, std::string_view) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      visit(group_ + std::string(name), child(child(path_, name), i), all[i]);
    }
  }
  template <class F>
  void group(std::string_view name, F&& inside) {
    path_ = std::string(name);
    group_ = path_ + ".";
    inside(*this);
    path_.clear();
    group_.clear();
  }

  std::map<std::string, std::set<std::string>> keys;  ///< by section
  std::map<std::string, std::string> values;

 private:
  template <class S>
  void visit(const std::string& section, const std::string& path, S& value) {
    const std::string outer_section = std::exchange(section_, section);
    const std::string outer_path = std::exchange(path_, path);
    const std::string outer_group = std::exchange(group_, section + ".");
    describe(*this, value);
    group_ = outer_group;
    section_ = outer_section;
    path_ = outer_path;
  }

  std::string section_;
  std::string path_;
  std::string group_;
};

Members members(Deck deck) {
  Members all;
  describe(all, deck);
  return all;
}

const std::filesystem::path input = std::filesystem::path(REPOSE_SOURCE_DIR) / "input";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string all_keys_text() { return text_of(input / "all_keys.toml"); }

void expect_round_trip(const Deck& deck) {
  const std::string text = resolved_deck(deck);
  const Deck again = read_deck(text, "resolved.toml", {});
  EXPECT_EQ(members(again).values, members(deck).values) << text;
  EXPECT_EQ(resolved_deck(again), text);
}

TEST(RoundTrip, Example) { expect_round_trip(read_deck(example_deck, "deck.toml", {})); }

TEST(RoundTrip, EveryDeckOfTheInputFolder) {
  int decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(input)) {
    if (!test::is_deck_of_a_run(entry.path())) continue;
    SCOPED_TRACE(entry.path());
    expect_round_trip(read_deck(text_of(entry.path()), entry.path().filename().string(), {}));
    ++decks;
  }
  EXPECT_GT(decks, 0);
}

TEST(RoundTrip, AwkwardValues) {
  Deck deck = read_deck(example_deck, "deck.toml", {});
  deck.run.title = "quotes \" and \\ and\nnew lines\t\x01, \xC2\xB5";
  deck.run.seed = 9223372036854775807;
  deck.gravity = {-0.0, 1e-300, -1.0 / 3.0};
  deck.materials[0].youngs_modulus = 123456789012345680000.0;
  deck.materials[1].youngs_modulus = 1e16;
  deck.time.step = 4.9406564584124654e-324;
  deck.angle_of_repose.camera = Camera::perspective;
  deck.angle_of_repose.camera_distance = 0.1 + 0.2;
  deck.angle_of_repose.camera_height = 0.0;
  deck.output.snapshot_times = {0.1, 2e22, 3.0};
  expect_round_trip(deck);
}

TEST(RoundTrip, OtherTypes) {
  Deck deck = read_deck(example_deck, "deck.toml", {});
  ParticlesDeck list;
  list.type = ParticlesType::csv;
  list.file = "grains.csv";
  ParticlesDeck box = deck.particles[0];
  box.region = RegionShape::box;
  box.radius = box.radius_top = box.height = unset;
  box.count = 0;
  box.mass = 1e-3;
  box.min = {0, 0, 0};
  box.max = {0.01, 0.02, 0.03};
  deck.particles = {list, box};
  deck.phases[1].until = PhaseUntil::steps;
  deck.phases[1].time = unset;
  deck.phases[1].steps = 12;
  deck.discharge = {};
  expect_round_trip(deck);
}

TEST(AllKeys, NamesEveryKeyInItsSection) {
  std::map<std::string, std::set<std::string>> found;
  std::istringstream lines(all_keys_text());
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = line.find_first_not_of("# ");
    if (start == std::string::npos) continue;
    line = line.substr(start);
    const std::size_t name = line.find_first_not_of('[');
    if (name > 0) {
      section = line.substr(name, line.find(']') - name);
    } else if (const std::size_t equals = line.find(" = "); equals != std::string::npos) {
      found[section].insert(line.substr(0, equals));
    }
  }
  const Members all = members(read_deck(all_keys_text(), "all_keys.toml", {}));
  EXPECT_EQ(all.keys.size(), 33u);
  for (const auto& [name, keys] : all.keys) {
    for (const std::string& key : keys) EXPECT_TRUE(found[name].contains(key)) << "[" << name << "] " << key;
  }
}

TEST(KeyReference, NamesEveryKeyOnItsOwnLine) {
  const std::string text = deck_keys();
  for (const auto& [section, keys] : members(read_deck(all_keys_text(), "all_keys.toml", {})).keys) {
    for (const std::string& key : keys)
      EXPECT_NE(text.find("\n  " + key + " "), std::string::npos) << section << "." << key;
  }
  std::string single_spaced = text;  // the widths of the columns are those of the longest key and range
  single_spaced.erase(
      std::unique(single_spaced.begin(), single_spaced.end(), [](char a, char b) { return a == ' ' && b == ' '; }),
      single_spaced.end());
  EXPECT_NE(single_spaced.find("\n poisson_ratio - number 0 <= x < 0.5 required Poisson's ratio"), std::string::npos);
  EXPECT_NE(text.find("profile|plane|disc|rectangle|mesh"), std::string::npos);
  EXPECT_NE(text.find("1.1 diameters"), std::string::npos);
}

TEST(KeyReference, OfStudiesHasTheirSections) {
  for (const char* section :
       {"[[parameter]]", "[[observable]]", "[[experiment.observable]]", "[[level]]", "[adaptive]"}) {
    EXPECT_NE(calibration_keys().find(section), std::string::npos) << section;
  }
  EXPECT_NE(sensitivity_keys().find("[morris]"), std::string::npos);
  EXPECT_NE(validation_keys().find("[[case.compare]]"), std::string::npos);
  EXPECT_EQ(calibration_keys().find("nan"), std::string::npos);
  EXPECT_LT(calibration_keys().find("\n  confidence "), calibration_keys().find("[[parameter]]"));
}

}  // namespace
}  // namespace repose
