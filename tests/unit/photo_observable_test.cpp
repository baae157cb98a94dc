#include <gtest/gtest.h>

#include "deck/calibration_deck.h"
#include "deck_error.h"
#include "photo/observable_text.h"
#include "photo/photo_deck.h"

namespace repose::photo {
namespace {

using test::deck_error;

TEST(PhotoMeasured, MeanScatterAndWhatAllShare) {
  const Measured m = measured({30.0, 32.0, 34.0, 36.0}, 0.3, 99.0);
  EXPECT_DOUBLE_EQ(m.mean, 33.0);
  EXPECT_DOUBLE_EQ(m.scatter, std::sqrt(20.0 / 3.0));
  EXPECT_DOUBLE_EQ(m.error, std::sqrt(20.0 / 12.0 + 0.09));
  EXPECT_DOUBLE_EQ(m.deviation / 2.0, m.error);
  const Measured one = measured({30.0}, 0.3, 0.4);
  EXPECT_DOUBLE_EQ(one.error, 0.5);
  EXPECT_DOUBLE_EQ(one.deviation, 0.5);
}

const std::string calibration = R"(# friction of sand
base = "a.toml"
seeds = 2
[[parameter]]
name = "mu"
key = "pair.0.sliding_friction"
min = 0.1
max = 0.9
points = 5

[[observable]]  # from the scales
figure = "discharged_mass_kg"
laboratory = 0.0218
deviation = 0.0001

[[observable]]
figure = "angle_of_repose_deg"
laboratory = 30.0  # by hand
deviation = 2.0
)";

TEST(PhotoObservables, ReplaceThoseOfACalibrationAndAddOthers) {
  const std::vector<MeasuredFigure> figures = {
      {.figure = "angle_of_repose_deg", .value = measured({31.0, 33.0}, 0.0, 0.0), .photographs = 2},
      {.figure = "scattering.area_1.count", .value = measured({120.0}, 3.0, 4.0), .photographs = 1, .is_count = true}};
  const std::string text = with_observables(calibration, "c.toml", figures);
  EXPECT_NE(text.find("laboratory = 32  # by hand\ndeviation = 1.414\n"), std::string::npos) << text;
  EXPECT_NE(text.find("# friction of sand\n"), std::string::npos);
  EXPECT_NE(text.find("[[observable]]  # from the scales\n"), std::string::npos);
  const CalibrationDeck deck = read_calibration_deck(text, "c.toml");
  ASSERT_EQ(deck.observables.size(), 3U);
  EXPECT_EQ(deck.observables[0].laboratory, 0.0218);
  EXPECT_EQ(deck.observables[1].laboratory, 32.0);
  EXPECT_EQ(deck.observables[1].repeats, 2);
  EXPECT_FALSE(deck.observables[1].deviation_is_known);
  EXPECT_EQ(deck.observables[2].figure, "scattering.area_1.count");
  EXPECT_EQ(deck.observables[2].laboratory, 120.0);
  EXPECT_EQ(deck.observables[2].deviation, 5.0);
  EXPECT_EQ(deck.observables[2].scale, ObservableScale::square_root);
  // Twice is once.
  EXPECT_EQ(with_observables(text, "c.toml", figures), text);
}

TEST(PhotoObservables, WhatIsNoCalibrationIsRefused) {
  EXPECT_NE(deck_error([] { with_observables("base = \"a.toml\"\n", "c.toml", {}); }).find("c.toml"),
            std::string::npos);
}

std::string refusal(const std::string& text) {
  return deck_error([&] { read_photo_deck(text, "p.toml", {}); });
}

TEST(PhotoDeckTest, WhatMakesNoSenseIsRefusedWithItsPlace) {
  EXPECT_EQ(read_photo_deck("base = \"a.toml\"\n[scale]\npixels_per_mm = 40\n", "p.toml", {}).scale.pixels_per_mm,
            40.0);
  EXPECT_NE(refusal("base = \"a.toml\"\n[scale]\n").find("p.toml:2"), std::string::npos);
  EXPECT_NE(refusal("base = \"a.toml\"\n[scale]\npixels_per_mm = 4\nplate_width = \"60 mm\"\n").find("has 2 of"),
            std::string::npos);
  EXPECT_NE(refusal("base = \"a.toml\"\n[scale]\nbar_from = [1, 2]\nbar_length = \"60 mm\"\n").find("bar_to"),
            std::string::npos);
  EXPECT_NE(refusal("base = \"a.toml\"\n[scale]\npixels_per_mm = 4\n[pile]\nbase_from = [5, 2]\nbase_to = [5, 9]\n")
                .find("above or below"),
            std::string::npos);
  EXPECT_NE(refusal("base = \"a.toml\"\ncrop_from = [5, 2]\ncrop_to = [9, 9]\n[scale]\npixels_per_mm = 4\n")
                .find("16 pixels"),
            std::string::npos);
}

}  // namespace
}  // namespace repose::photo
