#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "measurement_piles.h"
#include "pictures/silhouette_picture.h"
#include "pictures/top_view_picture.h"

namespace repose {
namespace {

struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<unsigned char> rgb;

  int blue(std::size_t x, std::size_t y) const { return rgb.at(3 * (y * width + x) + 2); }
  int red(std::size_t x, std::size_t y) const { return rgb.at(3 * (y * width + x)); }
};

Picture decode(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0);
  image.format = PNG_FORMAT_RGB;
  Picture picture{image.width, image.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0);
  return picture;
}

TEST(Draw, SilhouetteHasSkyAndAPile) {
  const std::vector<Sphere> pile = test::cone(5e-3, 30.0);
  const Picture picture = decode(silhouette_png(*angle_of_repose(pile, {}), pile, {}));
  EXPECT_EQ(picture.width, 1200u);
  EXPECT_EQ(picture.red(0, 0), 255);
  EXPECT_LT(picture.blue(600, picture.height - 100), 240);  // a grain in the middle of the foot of the pile
}

/// One large grain in each area and one beside the plate, which is covered where the texts are.
TEST(Draw, TopViewHasTheColoursOfTheAreas) {
  ScatteringDeck deck;
  deck.plate_height = 0.0;
  deck.max_height = 1.0;
  deck.plate_min = {-0.05, -0.05, 0.0};
  deck.plate_max = {0.05, 0.05, 0.0};
  deck.base_radius = 0.01;
  deck.area_1_width = 0.01;
  deck.area_3_radius = 0.04;
  const std::vector<Sphere> grains = {
      {{0.0, 0.0, 2e-3}, 2e-3}, {{0.015, 0.0, 2e-3}, 2e-3}, {{0.045, 0.045, 2e-3}, 2e-3}};
  const Picture picture = decode(top_view_png(deck, *scattering(deck, grains, 0), grains));
  EXPECT_EQ(picture.width, 1600u);
  const auto at = [&](double x, double y) {  // 15 pixels per mm, y up, below 130 pixels of text
    return std::pair(static_cast<std::size_t>(800.0 + 15e3 * x), static_cast<std::size_t>(130.0 + 15e3 * (0.05 - y)));
  };
  const auto excess = [&](double x, double y) {
    const auto [px, py] = at(x, y);
    return picture.red(px, py) - picture.blue(px, py);
  };
  EXPECT_NEAR(excess(0.0, 0.0), 0, 10);        // the pile is grey
  EXPECT_LT(excess(0.015, 0.0), -30);          // area 1 is blue
  EXPECT_GT(excess(0.045, 0.045), 30);         // area 3 is red, in the upper right corner
  EXPECT_NEAR(excess(-0.045, -0.045), 0, 10);  // plate
}

}  // namespace
}  // namespace repose
