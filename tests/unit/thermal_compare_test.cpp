// Equivalence of repeated measurements, thesis chapter 4.
#include <cmath>

#include <gtest/gtest.h>

#include "base/philox.h"
#include "thermal/equivalence.h"
#include "thermal/tools/compare_tool.h"
#include "thermal_files.h"

namespace repose::thermal {
namespace {

/// By hand: means 10 and 11, variances 1 and 4, five values each: the error is sqrt(1/5 + 4/5) = 1, and Welch's degrees
/// of freedom are 1/((1/5)^2/4 + (4/5)^2/4) = 100/17. For them the t of 95 % is between those of 5 and 6, 2.015
/// and 1.943.
TEST(Equivalence, ByHand) {
  const double a[] = {10.0 - std::sqrt(2.0), 10.0, 10.0, 10.0, 10.0 + std::sqrt(2.0)};
  const double b[] = {11.0 - 2.0 * std::sqrt(2.0), 11.0, 11.0, 11.0, 11.0 + 2.0 * std::sqrt(2.0)};
  const Equivalence e = compare_means(a, b, 3.0, 0.05);
  EXPECT_NEAR(e.difference, 1.0, 1e-14);
  EXPECT_NEAR(e.standard_error, 1.0, 1e-14);
  EXPECT_NEAR(e.degrees, 100.0 / 17.0, 1e-12);
  EXPECT_NEAR(e.high - 1.0, 1.951, 0.003);  // interpolated in 1/degrees
  EXPECT_NEAR(e.low + e.high, 2.0, 1e-12);
  // t = (1 - 3)/1 = -2 beyond the quantile of 5 %: just equivalent, and the interval is inside the bound.
  EXPECT_LT(e.p_equivalence, 0.05);
  EXPECT_GT(e.p_equivalence, 0.04);
  EXPECT_LT(e.high, 3.0);
  EXPECT_GT(compare_means(a, b, 2.9, 0.05).p_equivalence, 0.05);
  EXPECT_GT(compare_means(b, a, 2.9, 0.05).p_equivalence, 0.05);  // on the other side as well
}

/// In any unit the verdict is the same, also where the square of a variance is beyond the range of double precision.
TEST(Equivalence, InAnyUnit) {
  for (const double unit : {1e90, 1e-90}) {
    const double a[] = {1.0 * unit, 2.0 * unit, 4.0 * unit};
    const double b[] = {2.0 * unit, 3.0 * unit, 7.0 * unit};
    const double plain_a[] = {1.0, 2.0, 4.0};
    const double plain_b[] = {2.0, 3.0, 7.0};
    const Equivalence e = compare_means(a, b, 3.0 * unit, 0.05);
    const Equivalence plain = compare_means(plain_a, plain_b, 3.0, 0.05);
    EXPECT_NEAR(e.degrees, plain.degrees, 1e-12);
    EXPECT_NEAR(e.p_equivalence, plain.p_equivalence, 1e-12);
    EXPECT_NEAR(e.p_difference, plain.p_difference, 1e-12);
    EXPECT_NEAR(e.high / unit, plain.high, 1e-12);
  }
}

/// The test at its own limit: where the means differ by just the bound, 5 % are called equivalent. 4000 trials: +- 0.35
/// %.
TEST(Equivalence, HasItsSignificance) {
  int equivalent = 0;
  int covered = 0;
  constexpr int trials = 4000;
  const auto normal = [](std::uint64_t id, std::uint32_t k) {
    const double u = 1.0 - uniform(3, id, RandomStream::transient_noise, 2 * k);
    return std::sqrt(-2.0 * std::log(u)) *
           std::cos(2.0 * M_PI * uniform(3, id, RandomStream::transient_noise, 2 * k + 1));
  };
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    std::vector<double> a(8);
    std::vector<double> b(5);
    for (std::uint32_t k = 0; k < a.size(); ++k) a[k] = 32.0 + 0.65 * normal(trial, k);
    for (std::uint32_t k = 0; k < b.size(); ++k) b[k] = 34.0 + 1.2 * normal(trial, 20 + k);
    const Equivalence e = compare_means(a, b, 2.0, 0.05);
    equivalent += e.p_equivalence < 0.05 ? 1 : 0;
    covered += e.low <= 2.0 && 2.0 <= e.high ? 1 : 0;
  }
  EXPECT_NEAR(equivalent / static_cast<double>(trials), 0.05, 0.012);
  EXPECT_NEAR(covered / static_cast<double>(trials), 0.90, 0.02);
}

TEST(Equivalence, WithoutScatter) {
  const double a[] = {5.0, 5.0};
  const double b[] = {5.1, 5.1};
  EXPECT_EQ(compare_means(a, b, 0.2, 0.05).p_equivalence, 0.0);
  EXPECT_EQ(compare_means(a, b, 0.05, 0.05).p_equivalence, 1.0);
}

const char* const before =
    "discharged_mass_g,angle_of_repose_deg,area_1\n21.90,32.0,640\n21.91,32.5,660\n21.89,31.6,655\n21.92,32.1,\n";

ToolInput compared(const std::string& after, std::vector<std::string> overrides = {}) {
  return example("thermal_compare.toml", std::move(overrides), {{"before.csv", before}, {"after.csv", after}});
}

/// Not significant is not the same: a scatter that hides everything is undecided, a difference is a difference.
TEST(CompareTool, TellsEquivalentFromUndecided) {
  const Json same = compare_tool(compared("angle_of_repose_deg,discharged_mass_g,area_1\n32.2,21.9,650\n31.8,21.9,660\n"
                                          "32.4,21.91,640\n"))
                        .json;
  for (const Json& f : same["figures"]) EXPECT_EQ(f["verdict"], "equivalent") << f;
  EXPECT_EQ(same["figures"][2]["repeats_a"], 3);
  const Json other = compare_tool(compared("discharged_mass_g,angle_of_repose_deg,area_1\n22.5,20,650\n22.51,45,10\n"
                                           "22.49,31,1200\n"))
                         .json;
  EXPECT_EQ(other["figures"][0]["verdict"], "different");
  EXPECT_TRUE(other["figures"][1]["verdict"].get<std::string>().starts_with("undecided"));
  EXPECT_FALSE(other["figures"][1]["is_different"].get<bool>());
}

/// 5 mm of stainless steel by 580 K: 50 um, a quarter of the smallest grain (section 4.2).
TEST(CompareTool, OrificeGrowsLessThanTheSmallestGrain) {
  EXPECT_NEAR(thermal_growth(5e-3, 17.3e-6, 580.0), 50.17e-6, 1e-9);
  const Json o = compare_tool(compared(before)).json["orifice"];
  EXPECT_NEAR(o["share_of_smallest_grain"].get<double>(), 50.17 / 208.0, 1e-6);
  EXPECT_TRUE(o["is_below"].get<bool>());
  EXPECT_FALSE(compare_tool(compared(before, {"orifice.max_share=0.2"})).json["orifice"]["is_below"].get<bool>());
}

/// As spreadsheets write them: a byte order mark, carriage returns, names in quotes and with blanks.
TEST(CompareTool, ReadsFilesOfSpreadsheets) {
  const DataFile file{"file.csv",
                      "\xEF\xBB\xBF\"angle of repose\", discharged_mass_g ,area_1\r\n32,21,6\r\n33,22,7\r\n"};
  const Json json =
      compare_tool(example("thermal_compare.toml", {"figure.1.column=angle of repose"}, {file, file})).json;
  EXPECT_EQ(json["figures"][1]["mean_a"], 32.5);
}

TEST(CompareTool, RefusesBadFiles) {
  expect_deck_error([] { compare_tool(compared("# nothing\n")); }, "after.csv:1: the file is empty; a header");
  expect_deck_error([] { compare_tool(compared("discharged_mass_g,angle_of_repose_deg,area_1\n")); },
                    "after.csv: column \"discharged_mass_g\" has 0 values; two are needed");
  expect_deck_error([] { compare_tool(compared("discharged_mass_g,area_1\n1,2\n3,4\n")); },
                    "after.csv: has no column \"angle_of_repose_deg\"");
  expect_deck_error([] { compare_tool(compared("discharged_mass_g,angle_of_repose_deg,area_1\n1,2,3\n")); },
                    "after.csv: column \"discharged_mass_g\" has 1 values; two are needed");
  expect_deck_error([] { compare_tool(compared("discharged_mass_g,angle_of_repose_deg,area_1\n1,x,3\n")); },
                    "after.csv:2: angle_of_repose_deg = \"x\" is not a number");
  expect_deck_error([] { compare_tool(compared("discharged_mass_g,area_1\n1,2,3\n")); },
                    "after.csv:2: 3 values, 2 were expected");
  expect_deck_error([] { compare_tool(compared(before, {"figure.0.relative_bound=0.1"})); },
                    "[[figure]] needs one of \"bound\" and \"relative_bound\"");
}

}  // namespace
}  // namespace repose::thermal
