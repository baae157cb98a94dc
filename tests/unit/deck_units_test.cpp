#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "deck/nearest.h"
#include "deck/units.h"

namespace repose {
namespace {

struct Exact {
  const char* text;
  Unit unit;
  double value;  ///< the literal, to the bit
};

TEST(Units, JoinThePowerBeforeRounding) {
  const Exact cases[] = {
      {"440 um", Unit::metre, 440e-6},
      {"440um", Unit::metre, 0.00044},
      {"440 \xC2\xB5m", Unit::metre, 440e-6},
      {"440 \xCE\xBCm", Unit::metre, 440e-6},
      {" 40\tmm ", Unit::metre, 0.04},
      {"-20 mm", Unit::metre, -0.02},
      {"+0.1 mm", Unit::metre, 0.0001},
      {"3 cm", Unit::metre, 0.03},
      {"4.4e2 um", Unit::metre, 440e-6},
      {"4.4E+2 um", Unit::metre, 440e-6},
      {"4400e-1 um", Unit::metre, 440e-6},
      {"0.7 nm", Unit::metre, 0.7e-9},
      {"1.5 g", Unit::kilogram, 0.0015},
      {"25 mg", Unit::kilogram, 25e-6},
      {"2 ms", Unit::second, 0.002},
      {"2.3 us", Unit::second, 2.3e-6},
      {"5 MPa", Unit::pascal, 5e6},
      {"0.21 GPa", Unit::pascal, 0.21e9},
      {"3.592 g/cm3", Unit::density, 3592.0},
      {"3.592 g/cm^3", Unit::density, 3592.0},
      {"300 mm/s", Unit::speed, 0.3},
      {"9810 mm/s2", Unit::acceleration, 9.81},
      {"100 fJ", Unit::joule, 1e-13},
      {"2.5 mN", Unit::newton, 0.0025},
      {"2.5 kN/m", Unit::stiffness, 2500.0},
      {"0.21 W/(m K)", Unit::conductivity, 0.21},
      {"80 mW", Unit::watt, 0.08},
      {"298.15 K", Unit::kelvin, 298.15},
      {"0.0775 mm2/s", Unit::diffusivity, 0.0775e-6},
      {"734.46 J/(kg K)", Unit::specific_heat, 734.46},
      {"1.5 MJ/(m3 K)", Unit::volumetric_heat, 1.5e6},
      {"17.3e-6 1/K", Unit::per_kelvin, 17.3e-6},
      {"2 mK/s", Unit::heating_rate, 0.002},
      {"10 ohm", Unit::ohm, 10.0},
  };
  for (const Exact& c : cases) {
    const Quantity quantity = parse_quantity(c.text, c.unit);
    EXPECT_EQ(quantity.problem, "") << c.text;
    EXPECT_EQ(quantity.value, c.value) << c.text;
  }
}

/// A product with the unit's factor would round twice; this counts that the cases above could tell the difference.
TEST(Units, AProductWouldDifferSomewhere) {
  int different = 0;
  for (int i = 1; i <= 1000; ++i) {
    const std::string digits = std::to_string(i);
    const double exact = std::stod(digits + "e-6");
    EXPECT_EQ(parse_quantity(digits + " um", Unit::metre).value, exact) << i;
    if (i * 1e-6 != exact) ++different;
  }
  EXPECT_GT(different, 0);
}

TEST(Units, SayWhatIsAccepted) {
  struct Bad {
    const char* text;
    Unit unit;
    const char* problem;
  };
  const std::string lengths = "; write a length with one of the units m, km, cm, mm, um, nm";
  const Bad cases[] = {
      {"440 kg", Unit::metre, "\"440 kg\" is not a length"},
      {"440", Unit::metre, "\"440\" has no unit"},
      {"mm", Unit::metre, "\"mm\" is not a number"},
      {"", Unit::metre, "\"\" is not a number"},
      {"nan mm", Unit::metre, "\"nan mm\" is not a number"},
      {"inf mm", Unit::metre, "\"inf mm\" is not a number"},
      {"+-5 mm", Unit::metre, "\"+-5 mm\" is not a number"},
      {"4 4 mm", Unit::metre, "\"4 4 mm\" is not a length"},
      {"5 MM", Unit::metre, "\"5 MM\" is not a length"},
      {"1e308 km", Unit::metre, "\"1e308 km\" is too large or too small for a double"},
      {"1e999 m", Unit::metre, "\"1e999 m\" is too large or too small for a double"},
      {"1e99999999999 m", Unit::metre, "\"1e99999999999 m\" is too large or too small for a double"},
      {"1e-99999999999 m", Unit::metre, "\"1e-99999999999 m\" is too large or too small for a double"},
      {"1e2147483647 km", Unit::metre, "\"1e2147483647 km\" is too large or too small for a double"},
      {"1e-320 nm", Unit::metre, "\"1e-320 nm\" is too large or too small for a double"},
  };
  for (const Bad& c : cases) EXPECT_EQ(parse_quantity(c.text, c.unit).problem, c.problem + lengths);
}

TEST(Nearest, EditDistance) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("step", "step"), 0u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(nearest("densty", {"name", "density", "diameter"}), "density");
  EXPECT_EQ(nearest("drum", {"dream", "a_long_rotating_drum", "rotating_drum"}), "rotating_drum");
  EXPECT_EQ(nearest("is", {"disc", "if"}), "if");  // two letters are in a name by chance
  EXPECT_EQ(nearest("anything", {}), "");
}

}  // namespace
}  // namespace repose
