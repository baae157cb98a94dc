#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/sizes/size_csv.h"

namespace repose {
namespace {

SizeAnalysis parse(const std::string& text) { return parse_size_csv(text, "sieves.csv"); }

void expect_error(const std::string& text, const std::string& place, const std::string& part) {
  std::string message = "no error";
  try {
    parse(text);
  } catch (const DeckError& error) {
    message = error.what();
  }
  EXPECT_EQ(message.find(place), 0U) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

void expect_bins(const SizeAnalysis& analysis, Weighting by) {
  EXPECT_EQ(analysis.by, by);
  ASSERT_EQ(analysis.bins.size(), 2U);
  EXPECT_EQ(analysis.bins[0].low, 200e-6);
  EXPECT_EQ(analysis.bins[0].high, 400e-6);
  EXPECT_EQ(analysis.bins[1].low, 400e-6);
  EXPECT_EQ(analysis.bins[1].high, 700e-6);
  EXPECT_DOUBLE_EQ(analysis.bins[1].share / analysis.bins[0].share, 1.5);
}

TEST(SizeCsv, ReadsCumulativeAndDifferentialShares) {
  expect_bins(parse("diameter_um,cumulative_mass\n200,0\n400,40\n700,100\n"), Weighting::mass);
  expect_bins(parse("diameter_um,cumulative_number\n200,0\n400,0.4\n700,1\n"), Weighting::number);
  expect_bins(parse("diameter_um,share_mass\n200,0\n400,40\n700,60\n"), Weighting::mass);
  expect_bins(parse("# laser\r\n\r\n\"diameter_mm\", share_number\r\n0.2,0\r\n0.4,2\r\n0.7,3\r\n"), Weighting::number);
  expect_bins(parse("diameter,share_mass\n200e-6,0\n400e-6,40\n700e-6,60\n"), Weighting::mass);
}

TEST(SizeCsv, NamesTheBadLine) {
  const std::string header = "diameter_um,cumulative_mass\n";
  expect_error("", "sieves.csv:0: ", "the header line must read");
  expect_error("diameter_um,cumulative\n", "sieves.csv:1: ", "the header line must read");
  expect_error("size,cumulative_mass\n", "sieves.csv:1: ", "the header line must read");
  expect_error(header, "sieves.csv:1: ", "add up to 0");
  expect_error(header + "200,0\n", "sieves.csv:2: ", "add up to 0");
  expect_error(header + "200,3\n400,100\n", "sieves.csv:2: ", "of the first line must be 0");
  expect_error(header + "200,0\n\n200,10\n", "sieves.csv:4: ", "diameter = 200 is not greater");
  expect_error(header + "0,0\n200,10\n", "sieves.csv:2: ", "diameter = 0 is not positive");
  expect_error(header + "200,0\n1e10,10\n", "sieves.csv:3: ", "diameter = 1e10 is not between 1e-12 m and 1000 m");
  expect_error(header + "1e-9,0\n200,10\n", "sieves.csv:2: ", "diameter = 1e-9 is not between 1e-12 m and 1000 m");
  expect_error(header + "200,0\n400,50\n700,40\n", "sieves.csv:4: ", "cumulative_mass = 40 is less than");
  expect_error("diameter_um,share_mass\n200,0\n400,-1\n", "sieves.csv:3: ", "share_mass = -1 is negative");
  expect_error(header + "200,0\n400,25\n700,50\n",
               "sieves.csv:4: ", "cumulative_mass ends at 50; it must come to 1, or to 100");
  expect_error(header + "200,0\n400,25\n700,250\n", "sieves.csv:4: ", "cumulative_mass ends at 250");
  expect_error(header + "200,0,1\n", "sieves.csv:2: ", "3 fields instead of 2");
  expect_error(header + "nan,0\n", "sieves.csv:2: ", "diameter = nan is not finite; write a number");
  expect_error(header + "200,0\ninf,1\n", "sieves.csv:3: ", "diameter = inf is not finite; write a number");
  expect_error(header + "200,0\n400,-inf\n", "sieves.csv:3: ", "cumulative_mass = -inf is not finite");
  expect_error(header + "200,0\n1e999,1\n", "sieves.csv:3: ", "diameter = 1e999 is out of the range of double");
  expect_error(header + "200,none\n", "sieves.csv:2: ", "cumulative_mass = \"none\" is not a number");
}

}  // namespace
}  // namespace repose
