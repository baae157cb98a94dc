#include <gtest/gtest.h>

#include "deck/scaled_deck.h"
#include "deck_error.h"

namespace repose {
namespace {

constexpr const char* text = R"(# a comment of 4 mm stays
[[material]]
name = "4 mm"  # so does a name
density = 2500
youngs_modulus = 5e6  # soft
[[particles]]
diameter = '1 mm'
count = 1000
mass = "2 g"
min = [0.0, -0.004, "4 mm"]  # m
velocity = [0, 0, "-1 m/s"]
[particles.sizes]
diameters = ["1 mm", 2e-3]
[[wall]]
points = [["4 mm", 0.0], [0.004, "8 mm"]]
[[wall.motion]]
angular_velocity = "20 rpm"
[[phase]]
time = 3
kinetic_energy = "1 nJ"
max_time = "50 ms"
[measurement.angle_of_repose]
azimuths = 36
plate_height = 0.002)";

TEST(ScaledDeck, StaysAsItIs) { EXPECT_EQ(scaled_deck(text, "deck.toml", {}), text); }

TEST(ScaledDeck, NumbersFollowTheirUnits) {
  DeckScale scale;
  scale.grains = 2.0;
  scale.lengths = 4.0;
  scale.density = 3.0;
  EXPECT_EQ(scaled_deck(text, "deck.toml", scale), R"(# a comment of 4 mm stays
[[material]]
name = "4 mm"  # so does a name
density = 2500
youngs_modulus = 6e+07  # soft
[[particles]]
diameter = "2 mm"
count = 8000
mass = "384 g"
min = [0.0, -0.016, "16 mm"]  # m
velocity = [0, 0, "-2 m/s"]
[particles.sizes]
diameters = ["2 mm", 0.004]
[[wall]]
points = [["16 mm", 0.0], [0.016, "32 mm"]]
[[wall.motion]]
angular_velocity = "10 rpm"
[[phase]]
time = 6.0
kinetic_energy = "48 nJ"
max_time = "100 ms"
[measurement.angle_of_repose]
azimuths = 36
plate_height = 0.008)");
}

TEST(ScaledDeck, GivenNumbersTakeTheirCommentsAway) {
  DeckScale scale;
  scale.grains = scale.lengths = 4.0;
  scale.given = {{"material.0.youngs_modulus", 7e10}};
  const std::string scaled = scaled_deck(text, "deck.toml", scale);
  EXPECT_NE(scaled.find("\nyoungs_modulus = 70000000000.0\n"), std::string::npos) << scaled;
  scale.given = {{"material.1.density", 1.0}};
  EXPECT_EQ(test::deck_error([&] { scaled_deck(text, "deck.toml", scale); }),
            "deck.toml: has no number \"material.1.density\" that could be replaced");
}

}  // namespace
}  // namespace repose
