// Tables 5.1 and 5.2 of the thesis from their own readings, and the correction of readings with mica.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/philox.h"
#include "thermal/plane_source/sensor_correction.h"
#include "thermal/tools/sensor_tool.h"
#include "thermal_files.h"

namespace repose::thermal {
namespace {

/// The printed specific heat errors within 0.05 percentage points, each printed conductivity error inside what the
/// rounding of the inputs allows. The deviations are those of docs/theory-thermal.md.
TEST(SensorTool, ReproducesTables51And52) {
  const Json json = sensor_tool(example("thermal_sensor.toml")).json;
  int compared = 0;
  for (const Json& material : json["materials"]) {
    for (const Json& r : material["room"]) {
      const Json& heat = r["specific_heat_error"];
      const Json& conductivity = r["conductivity_error"];
      if (heat.is_null()) continue;
      ++compared;
      EXPECT_LE(std::abs(heat["percent"].get<double>() - heat["printed"].get<double>()), 0.05) << r;
      EXPECT_GE(conductivity["printed"].get<double>(), conductivity["lowest_possible"].get<double>()) << r;
      EXPECT_LE(conductivity["printed"].get<double>(), conductivity["highest_possible"].get<double>()) << r;
      EXPECT_TRUE(conductivity["printed_is_possible"].get<bool>()) << r;
      std::printf("%s\n",
                  fmt::format("{} {} {:.1f} mm: c_p {:.3f} % ({:+.3f}), k {:.3f} % ({:+.3f}, {:.2f} to {:.2f})",
                              material["name"].get<std::string>(), r["insulation"].get<std::string>(),
                              1e3 * r["radius_m"].get<double>(), heat["percent"].get<double>(),
                              heat["difference"].get<double>(), conductivity["percent"].get<double>(),
                              conductivity["difference"].get<double>(), conductivity["lowest_possible"].get<double>(),
                              conductivity["highest_possible"].get<double>())
                      .c_str());
    }
  }
  EXPECT_EQ(compared, 8);
}

/// The printed errors are rounded, too: 2.174 % is printed as 2.17, and possible. Only 20.97 for 20.996 % is not.
TEST(SensorTool, AllowsForTheRoundingOfThePrintedErrors) {
  const auto impossible = [](std::vector<std::string> overrides) {
    std::vector<double> printed;
    const Json json = sensor_tool(example("thermal_sensor.toml", std::move(overrides))).json;
    for (const Json& material : json["materials"])
      for (const Json& r : material["room"])
        if (const Json& e = r["specific_heat_error"]; !e.is_null() && !e["printed_is_possible"].get<bool>())
          printed.push_back(e["printed"].get<double>());
    return printed;
  };
  EXPECT_EQ(impossible({}), std::vector<double>{20.97});
  EXPECT_EQ(impossible({"printed_error_half_unit=0"}).size(), 6U);
}

/// An error that no rounding gives is called impossible: 0.29 instead of 0.31 W/(m K), for which 45.163 % is printed.
TEST(SensorTool, TellsAnImpossibleError) {
  const Json json = sensor_tool(example("thermal_sensor.toml", {"material.carbohsp.room.2.conductivity=0.29"})).json;
  EXPECT_FALSE(json["materials"][1]["room"][2]["conductivity_error"]["printed_is_possible"].get<bool>());
}

TEST(SensorCorrection, IntervalsOfErrors) {
  const ErrorInterval apart = possible_errors(0.24, 0.21, 0.005);
  EXPECT_NEAR(apart.low, 100.0 * (0.235 / 0.215 - 1.0), 1e-12);
  EXPECT_NEAR(apart.high, 100.0 * (0.245 / 0.205 - 1.0), 1e-12);
  const ErrorInterval equal = possible_errors(0.21, 0.21, 0.005);
  EXPECT_EQ(equal.low, 0.0);
  EXPECT_NEAR(equal.high, 100.0 * (0.215 / 0.205 - 1.0), 1e-12);
  const ErrorInterval below = possible_errors(0.19, 0.21, 0.005);
  EXPECT_NEAR(below.low, 100.0 * (1.0 - 0.195 / 0.205), 1e-12);
  EXPECT_NEAR(below.high, 100.0 * (1.0 - 0.185 / 0.215), 1e-12);
}

/// The difference at room temperature is subtracted; three independent deviations add in quadrature.
TEST(SensorCorrection, SubtractsTheBias) {
  const Measured bias = sensor_bias({0.30, 0.02}, {0.21, 0.01});
  EXPECT_NEAR(bias.value, 0.09, 1e-15);
  const Measured hot = corrected({0.40, 0.03}, bias);
  EXPECT_NEAR(hot.value, 0.31, 1e-15);
  EXPECT_NEAR(hot.deviation, std::sqrt(9.0 + 4.0 + 1.0) / 100.0, 1e-15);
}

/// (T.10) against many draws of the three readings; the deviation of 100 000 draws is known to 0.22 %.
TEST(SensorCorrection, DeviationIsThatOfDraws) {
  const auto draw = [](std::uint64_t i, std::uint32_t k) {  // uniform with deviation 1
    return std::sqrt(12.0) * (uniform(7, i, RandomStream::transient_noise, k) - 0.5);
  };
  double sum = 0.0;
  double squares = 0.0;
  constexpr int draws = 100'000;
  for (std::uint64_t i = 0; i < draws; ++i) {
    const Measured bias = sensor_bias({864.0 + 20.0 * draw(i, 0), 0.0}, {752.0 + 10.0 * draw(i, 1), 0.0});
    const double x = corrected({950.0 + 30.0 * draw(i, 2), 0.0}, bias).value;
    sum += x;
    squares += x * x;
  }
  const double mean = sum / draws;
  const Measured propagated = corrected({950.0, 30.0}, sensor_bias({864.0, 20.0}, {752.0, 10.0}));
  EXPECT_NEAR(mean, propagated.value, 0.5);
  EXPECT_NEAR(std::sqrt(squares / draws - mean * mean) / propagated.deviation, 1.0, 0.01);
}

/// Section 5.2.2 at room temperature: what remains is the reading with kapton, and its error.
TEST(SensorTool, CorrectsToKapton) {
  const Json hot = sensor_tool(example("thermal_sensor.toml")).json["materials"][1]["hot"][0];
  EXPECT_NEAR(hot["specific_heat_J_kgK"]["corrected"].get<double>(), 751.55, 1e-9);
  EXPECT_NEAR(hot["specific_heat_J_kgK"]["reading_error_percent"].get<double>(), 17.64, 0.05);
  EXPECT_NEAR(hot["specific_heat_J_kgK"]["corrected_error_percent"].get<double>(), 2.33, 0.05);
  EXPECT_NEAR(hot["conductivity_W_mK"]["corrected"].get<double>(), 0.21, 1e-12);
  // 2 % of 0.30, of 0.30 again and of 0.21 W/(m K)
  EXPECT_NEAR(hot["conductivity_W_mK"]["corrected_deviation"].get<double>(),
              0.02 * std::sqrt(0.30 * 0.30 + 0.30 * 0.30 + 0.21 * 0.21), 1e-12);
}

TEST(SensorTool, NeedsBothReadingsAtRoomTemperature) {
  expect_deck_error([] { sensor_tool(example("thermal_sensor.toml", {"material.sand.hot.0.radius=7 mm"})); },
                    "\"sand\" has no reading at room temperature with kapton of radius 0.007 m");
  expect_deck_error([] { sensor_tool(example("thermal_sensor.toml", {"material.sand.room.0.conductivity=-0.3"})); },
                    "\"conductivity\" = -0.3 is out of range");
}

}  // namespace
}  // namespace repose::thermal
