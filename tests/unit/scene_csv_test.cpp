#include <gtest/gtest.h>

#include "base/error.h"
#include "deck_error.h"
#include "scene/insertion/particle_csv.h"

namespace repose {
namespace {

const std::string header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
NewParticles parse(const std::string& text) {
  std::vector<MaterialDeck> materials(2);
  materials[0].name = "glass";
  materials[1].name = "steel";
  return parse_particle_csv(text, "grains.csv", materials);
}

TEST(MeasuredCsv, NeedsNoMaterial) {
  std::vector<MaterialDeck> materials(1);
  materials[0].name = "glass";
  const auto read = [&](const std::string& text) { return parse_measured_csv(text, "grains.csv", materials); };
  const NewParticles bare = read("x,y,z,radius\n1,2,3,0.5\n");
  EXPECT_EQ(bare.position[0], (Vec3{1, 2, 3}));
  EXPECT_EQ(bare.radius[0], 0.5);
  EXPECT_TRUE(bare.material.empty());
  EXPECT_EQ(read("x,y,z,radius,material\n1,2,3,0.5,glass\n").material, std::vector<int>{0});
  EXPECT_EQ(read(header + "1,2,3,4,5,6,7,8,9,0.5,glass\n").radius[0], 0.5);
  EXPECT_THROW(read("x,y,z\n1,2,3\n"), DeckError);
  EXPECT_THROW(read("x,y,z,radius\n1,2,3,0.5,glass\n"), DeckError);
  EXPECT_THROW(parse("x,y,z,radius\n1,2,3,0.5\n"), DeckError);  // a run must know what its particles are made of
}

std::string error_of(const std::string& text) {
  return test::deck_error([&] { parse(text); });
}

void expect_error(const std::string& text, const std::string& place, const std::string& part) {
  const std::string error = error_of(text);
  EXPECT_EQ(error.find(place), 0U) << error;
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST(ParticleCsv, ReadsEveryColumn) {
  const NewParticles particles = parse(header + "1,2,3,4,5,6,7,8,9,0.5,steel\n-1e-3,+2,0,0,0,0,0,0,0,0.1,glass\n");
  ASSERT_EQ(particles.size(), 2U);
  EXPECT_EQ(particles.position[0], (Vec3{1, 2, 3}));
  EXPECT_EQ(particles.velocity[0], (Vec3{4, 5, 6}));
  EXPECT_EQ(particles.spin[0], (Vec3{7, 8, 9}));
  EXPECT_EQ(particles.radius, (std::vector<double>{0.5, 0.1}));
  EXPECT_EQ(particles.material, (std::vector<int>{1, 0}));
  EXPECT_EQ(particles.position[1], (Vec3{-1e-3, 2, 0}));
}

TEST(ParticleCsv, TheShortHeaderIsForParticlesAtRest) {
  const NewParticles particles = parse("x,y,z,radius,material\n1,2,3,0.5,steel\n");
  ASSERT_EQ(particles.size(), 1U);
  EXPECT_EQ(particles.position[0], (Vec3{1, 2, 3}));
  EXPECT_EQ(particles.velocity[0], Vec3{});
  EXPECT_EQ(particles.spin[0], Vec3{});
  EXPECT_EQ(particles.radius[0], 0.5);
  EXPECT_EQ(particles.material[0], 1);
  expect_error("x,y,z,radius,material\n1,2,3,0,0,0,0,0,0,0.5,steel\n", "grains.csv:2: ", "11 fields instead of 5");
}

TEST(ParticleCsv, KeepsEveryDigit) {
  EXPECT_EQ(parse(header + "0.1000000000000000055,0,0,0,0,0,0,0,0,4.9406564584124654e-324,glass").radius[0], 0x1p-1074);
  EXPECT_EQ(parse(header + "0.30000000000000004,0,0,0,0,0,0,0,0,1,glass").position[0].x, 0.1 + 0.2);
}

TEST(ParticleCsv, AcceptsWhatEditorsAndSpreadsheetsDo) {
  const std::string text =
      "\xEF\xBB\xBF# two grains\r\nx, y, z, vx, vy, vz, wx, wy, wz, radius, material\r\n\r\n"
      "0, 0, 0, 0, 0, 0, 0, 0, 0, 1, glass\r\n# a comment\r\n3,0,0,0,0,0,0,0,0,1,glass \r\n\r\n";
  EXPECT_EQ(parse(text).size(), 2U);
}

TEST(ParticleCsv, NamesTheBadLine) {
  const std::string good = "0,0,0,0,0,0,0,0,0,1,glass\n";
  expect_error("", "grains.csv:0: ", "no particles");
  expect_error(header, "grains.csv:1: ", "no particles");
  expect_error(good, "grains.csv:1: ", "header");
  expect_error(header + good + "0,0,0,0,0,0,0,0,0,1\n", "grains.csv:3: ", "10 fields");
  expect_error(header + good + "0,0,0,0,0,0,0,0,0,1,glass,\n", "grains.csv:3: ", "12 fields");
  expect_error(header + "\n# comment\n0,zero,0,0,0,0,0,0,0,1,glass\n", "grains.csv:4: ", "y = \"zero\"");
  expect_error(header + "0,0,,0,0,0,0,0,0,1,glass\n", "grains.csv:2: ", "z = \"\"");
  expect_error(header + "0,0,0,1.5x,0,0,0,0,0,1,glass\n", "grains.csv:2: ", "vx");
  expect_error(header + "0,0,0,0,+-1,0,0,0,0,1,glass\n", "grains.csv:2: ", "vy");
  expect_error(header + "nan,0,0,0,0,0,0,0,0,1,glass\n", "grains.csv:2: ", "not finite");
  expect_error(header + "0,0,0,0,0,inf,0,0,0,1,glass\n", "grains.csv:2: ", "not finite");
  expect_error(header + "0,0,0,0,0,0,1e999,0,0,1,glass\n", "grains.csv:2: ", "out of the range");
  expect_error(header + "0,0,0,0,0,0,0,0,0,nan,glass\n",
               "grains.csv:2: ", "radius = nan is not finite; write a number");
  expect_error(header + "0,0,0,0,0,0,0,0,0,inf,glass\n", "grains.csv:2: ", "radius = inf is not finite");
  expect_error("x,y,z,radius,material\n0,0,-infinity,1,glass\n", "grains.csv:2: ", "z = -infinity is not finite");
  expect_error(header + "0,0,0,0,0,0,0,0,0,1,gl\rass\n", "grains.csv:2: ", "\"gl?ass\"; the deck has: glass, steel");
  expect_error(header + "0,0,0,0,0,0,0,0,0,0,glass\n", "grains.csv:2: ", "radius = 0 is not positive");
  expect_error(header + "0,0,0,0,0,0,0,0,0,-1,glass\n", "grains.csv:2: ", "not positive");
  expect_error(header + "0,0,0,0,0,0,0,0,0,1,wood\n", "grains.csv:2: ", "\"wood\"; the deck has: glass, steel");
}

}  // namespace
}  // namespace repose
