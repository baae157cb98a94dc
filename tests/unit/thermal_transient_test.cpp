// Transients in files: made, read, evaluated, refused.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "thermal/plane_source/transient.h"
#include "thermal/tools/tps_tool.h"
#include "thermal_files.h"

namespace repose::thermal {
namespace {

const char* const decks[] = {"thermal_tps_steel.toml", "thermal_tps_grains.toml"};

DataFile made(const char* deck, std::vector<std::string> overrides = {}) {
  DataFile file = synthesise_tool(example(deck, std::move(overrides))).tables.at(0);
  EXPECT_EQ(file.name, "transient.csv");
  return file;
}

/// What is made up comes back through its file, with every criterion met.
TEST(TpsTool, EvaluatesWhatWasSynthesised) {
  for (const char* deck : decks) {
    const Json truth = synthesise_tool(example(deck)).json;
    const Json result = tps_tool(example(deck, {}, {made(deck)})).json["transients"][0];
    for (const char* figure : {"conductivity_W_mK", "diffusivity_m2_s", "volumetric_heat_J_m3K"}) {
      const double t = truth[figure].get<double>();
      EXPECT_NEAR(result[figure]["value"].get<double>() / t, 1.0, 0.005) << deck << figure;
      EXPECT_LT(result[figure]["low_95"].get<double>(), result[figure]["high_95"].get<double>());
    }
    EXPECT_TRUE(result["all_criteria_met"].get<bool>()) << deck << result["criteria"];
    EXPECT_EQ(result["criteria"].size(), 10U);
  }
}

/// A layer of the sample's own and no heater is the sample: both ways of making a transient up meet but for a constant.
TEST(TpsTool, LayersOfTheSampleChangeNothing) {
  const std::vector<std::string> own = {
      "synthetic.layer.0.conductivity=0.21", "synthetic.layer.0.radial_conductivity=0.21",
      "synthetic.layer.0.volumetric_heat=1553383", "synthetic.heater.thickness=1e-12", "synthetic.noise=0"};
  const DataFile file = made("thermal_tps_mica.toml", own);
  const Json result = tps_tool(example("thermal_tps_mica.toml", own, {file})).json["transients"][0];
  EXPECT_NEAR(result["conductivity_W_mK"]["value"].get<double>() / 0.21, 1.0, 1e-3);
  EXPECT_NEAR(result["volumetric_heat_J_m3K"]["value"].get<double>() / 1553383.0, 1.0, 2e-3);
}

/// The insulation that the sample's rise is added to and the layers it is one problem with are not given together, and
/// a mistake in a layer is one line.
TEST(TpsTool, RefusesBadLayers) {
  const auto refused = [](const std::string& override, const std::string& what) {
    expect_deck_error([&] { made("thermal_tps_mica.toml", {override}); }, what);
  };
  refused("synthetic.layer.0.thickness=-1 um", "\"thickness\" = -1e-06 is out of range");
  refused("synthetic.layer.0.conductivity=0", "\"conductivity\" = 0 is out of range");
  refused("synthetic.layer.0.radial_conductivity=-4", "\"radial_conductivity\" = -4 is out of range");
  refused("synthetic.layer.0.volumetric_heat=0", "\"volumetric_heat\" = 0 is out of range");
  refused("synthetic.heater.coverage=1.5", "\"coverage\" = 1.5 is out of range");
  refused("synthetic.layer.1.thickness=1 um", "there is no [[synthetic.layer]] \"1\"; the deck has 1");
  refused("synthetic.insulation={thickness=1e-4, conductivity=1, diffusivity=1e-7}",
          "[synthetic.insulation] adds to the sample's rise, [[synthetic.layer]] and [synthetic.heater] conduct");
}

/// The table of docs/theory-thermal.md: mica that conducts along its sheet is read as a bed that conducts better by a
/// third, hardly seen on steel; what it stores is not the reason, nor what it conducts across.
TEST(TpsTool, ReadsMicaAsTheBed) {
  const auto bias = [](std::vector<std::string> overrides, double conductivity) {
    overrides.emplace_back("synthetic.noise=0");
    const DataFile file = made("thermal_tps_mica.toml", overrides);
    const Json result = tps_tool(example("thermal_tps_mica.toml", overrides, {file})).json["transients"][0];
    return result["conductivity_W_mK"]["value"].get<double>() / conductivity - 1.0;
  };
  EXPECT_NEAR(bias({}, 0.21), 0.34, 0.03);
  EXPECT_NEAR(bias({"synthetic.layer.0.radial_conductivity=0.46"}, 0.21), 0.015, 0.01);
  EXPECT_NEAR(bias({"synthetic.layer.0.radial_conductivity=1e-6"}, 0.21), -0.03, 0.01);
  EXPECT_NEAR(bias({"synthetic.conductivity=13.55", "synthetic.volumetric_heat=3713000", "synthetic.duration=9.6",
                    "evaluation.power=2.5"},
                   13.55),
              -0.012, 0.01);
}

TEST(TpsTool, MakesNothingUpBeyondItsTable) {
  expect_deck_error([] { made(decks[0], {"synthetic.duration=0.1 ms"}); },
                    "synthetic.duration = 0.0001 s is tau = 0.00294, not above \"cutoff\" = 0.01 of [sensor]");
  expect_deck_error([] { made(decks[0], {"synthetic.duration=1e6 s"}); }, "at most 100 is tabulated");
}

TEST(TpsTool, TakesThePowerOfThePointsThatAreUsed) {
  const Transient t = parse_transient(made(decks[0]), {});
  std::string text = "time,temperature,power\n";
  for (std::size_t i = 0; i < t.time.size(); ++i)
    text += fmt::format("{},{},{}\n", t.time[i], t.rise[i], i < 10 ? 1.7 : i < 150 ? 1.8 : 0.1);
  const ToolInput input = example(decks[0], {"evaluation.leave_out_last=50"}, {{"t.csv", text}});
  EXPECT_NEAR(tps_tool(input).json["transients"][0]["power_W"].get<double>(), 1.8, 1e-12);
}

TEST(TpsTool, ReportsABrokenCriterion) {
  const Json result =
      tps_tool(example(decks[0], {"criteria.available_depth=5 mm"}, {made(decks[0])})).json["transients"][0];
  EXPECT_FALSE(result["all_criteria_met"].get<bool>());
  for (const Json& c : result["criteria"])
    EXPECT_EQ(c["is_met"].get<bool>(), c["name"].get<std::string>() != "probing_depth") << c;
}

/// At least three measurements, 45 minutes apart (thesis section 5.2), with the scatter between them.
TEST(TpsTool, ChecksTheRepeats) {
  std::vector<DataFile> files;
  for (const char* seed : {"1", "2", "3"}) files.push_back(made(decks[0], {std::string("synthetic.seed=") + seed}));
  const auto repeats = [&](const std::string& starts, std::vector<DataFile> which) {
    return tps_tool(example(decks[0], {"repeats.starts=" + starts}, std::move(which))).json["repeats"];
  };
  const Json good = repeats("[0, 2700, 5400]", files);
  EXPECT_TRUE(good["is_met"].get<bool>());
  EXPECT_NEAR(good["conductivity_W_mK"]["mean"].get<double>() / 13.55, 1.0, 0.003);
  const double deviation = good["conductivity_W_mK"]["standard_deviation"].get<double>();
  EXPECT_GT(deviation, 0.0);
  // Student's t of 95 % with 2 degrees of freedom, 4.302653, over sqrt(3)
  EXPECT_NEAR(good["conductivity_W_mK"]["high_95"].get<double>() - good["conductivity_W_mK"]["mean"].get<double>(),
              2.484138 * deviation, 1e-6 * deviation);
  EXPECT_FALSE(repeats("[0, 2700, 5000]", files)["is_met"].get<bool>());
  EXPECT_FALSE(repeats("[0, 2700]", {files[0], files[1]})["is_met"].get<bool>());
  expect_deck_error([&] { repeats("[0, 2700]", files); }, "[repeats] starts has 2 times for 3 files");
}

/// A resistance is a temperature (5.2): 10 ohm, 0.005 1/K, so 10.1 ohm are 2 K.
TEST(ParseTransient, ReadsResistances) {
  const Transient t = parse_transient({"r.csv", "time,resistance\n-1,10\n0.5,10.1\n"}, {10.0, 0.005});
  ASSERT_EQ(t.time.size(), 1U);
  EXPECT_NEAR(t.rise[0], 2.0, 1e-12);
  EXPECT_EQ(t.idle_rise, std::vector<double>{0.0});
  expect_deck_error(
      [] {
        parse_transient({"r.csv", "time,resistance\n1,10\n"}, {});
      },
      "r.csv:1: a column of resistances needs resistance and resistance_coefficient");
}

/// As spreadsheets write them: a byte order mark, carriage returns, no end of the last line; a time of any size.
TEST(ParseTransient, ReadsFilesOfSpreadsheets) {
  const Transient t = parse_transient({"t.csv",
                                       "\xEF\xBB\xBF"
                                       "time,temperature\r\n-1e20,0\r\n0.5,2"},
                                      {});
  EXPECT_EQ(t.idle_time, std::vector<double>{-1e20});
  EXPECT_EQ(t.rise, std::vector<double>{2.0});
}

TEST(ParseTransient, RefusesBadFiles) {
  const auto refused = [](const std::string& text, const std::string& what) {
    expect_deck_error([&] { parse_transient({"t.csv", text}, {}); }, what);
  };
  refused("", "t.csv:0: the file is empty");
  refused("t,T\n1,2\n", "t.csv:1: the first line must be the header time,temperature");
  refused("time,temperature\n1,1\n3,2\n2,3\n", "t.csv:4: time = 2 does not come after 3; sort the rows by time");
  refused("time,temperature\n1,1\n1,2\n", "t.csv:3: time = 1 does not come after 1");
  refused("time,temperature\n1,nan\n", "t.csv:2: temperature = nan is not finite");
  refused("time,temperature\n1\n", "t.csv:2: 1 values, 2 were expected");
  refused("time,temperature,power\n1,1,0\n", "t.csv:2: power = 0 must be above 0 after time 0");
}

TEST(TpsTool, RefusesBadTransients) {
  const auto refused = [](const std::string& text, const std::string& what, std::vector<std::string> overrides = {}) {
    expect_deck_error([&] { tps_tool(example(decks[0], std::move(overrides), {{"t.csv", text}})); }, what);
  };
  std::string few = "time,temperature\n";
  for (int i = 1; i <= 29; ++i) few += fmt::format("{},{}\n", 0.1 * i, std::sqrt(i));
  refused(few, "t.csv: 29 points after time 0, of which 10 are left out; at least 20 must remain");
  std::string saturated = "time,temperature\n";  // ends sooner than any source without a boundary
  std::string falling = "time,temperature\n";
  for (int i = 1; i <= 200; ++i) saturated += fmt::format("{},{}\n", 0.025 * i, 3.0 - 1.0 / (i * i));
  for (int i = 1; i <= 200; ++i) falling += fmt::format("{},{}\n", 0.025 * i, 1.0 - 0.1 * std::sqrt(i) + 1e-3 * i);
  refused(saturated, "t.csv: the points do not determine the diffusivity");
  refused(falling, "t.csv: the temperature does not rise with time");
  expect_deck_error(
      [&] {
        tps_tool(example(decks[0], {"sensor.radius=-1 mm"}, {{"t.csv", few}}));
      },
      "\"radius\" = -0.001 is out of range");
  expect_deck_error(
      [&] {
        tps_tool(example(decks[0], {"criteria.max_rise=1"}, {{"t.csv", few}}));
      },
      "\"max_rise\" of [criteria] must be above \"min_rise\"");
}

}  // namespace
}  // namespace repose::thermal
