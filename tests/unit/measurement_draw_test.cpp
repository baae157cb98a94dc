#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <cairo.h>
#include <gtest/gtest.h>

#include "measurement_piles.h"
#include "pictures/silhouette_picture.h"
#include "pictures/top_view_picture.h"

namespace repose {
namespace {

/// The pixels of a PNG.
class Pixels {
 public:
  explicit Pixels(const std::string& png) {
    Source source{png, 0};
    image_ = cairo_image_surface_create_from_png_stream(read, &source);
    EXPECT_EQ(cairo_surface_status(image_), CAIRO_STATUS_SUCCESS);
  }
  ~Pixels() { cairo_surface_destroy(image_); }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;

  int width() const { return cairo_image_surface_get_width(image_); }
  int height() const { return cairo_image_surface_get_height(image_); }
  int red(int x, int y) const { return channel(x, y, 16); }
  int blue(int x, int y) const { return channel(x, y, 0); }

 private:
  struct Source {
    const std::string& bytes;
    std::size_t at;
  };
  static cairo_status_t read(void* closure, unsigned char* to, unsigned count) {
    auto& source = *static_cast<Source*>(closure);
    if (source.at + count > source.bytes.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, source.bytes.data() + source.at, count);
    source.at += count;
    return CAIRO_STATUS_SUCCESS;
  }
  int channel(int x, int y, int shift) const {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, cairo_image_surface_get_data(image_) + y * cairo_image_surface_get_stride(image_) + 4 * x, 4);
    return static_cast<int>(pixel >> shift & 255U);
  }

  cairo_surface_t* image_ = nullptr;
};

TEST(Draw, SilhouetteHasSkyAndAPile) {
  const std::vector<Sphere> pile = test::cone(5e-3, 30.0);
  const Pixels picture(silhouette_picture(*angle_of_repose(pile, {}), pile, {}).png);
  EXPECT_EQ(picture.width(), 1200);
  EXPECT_EQ(picture.red(0, 0), 255);
  EXPECT_LT(picture.blue(600, picture.height() - 100), 240);  // a grain in the middle of the foot of the pile
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
  const Pixels picture(top_view_picture(deck, *scattering(deck, grains, 0), grains).png);
  EXPECT_EQ(picture.width(), 1600);
  const auto at = [&](double x, double y) {  // 15 pixels per mm, y up, below 150 pixels of text
    return std::pair(static_cast<int>(800.0 + 15e3 * x), static_cast<int>(150.0 + 15e3 * (0.05 - y)));
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

/// Whatever radius the areas are counted from.
TEST(Draw, TheBaseIsTheOneThatWasMeasured) {
  Scattering result;
  result.base_radius = 11e-3;
  EXPECT_EQ(base_text(result), "No base");
  result.measured_base_radius = 9e-3;
  EXPECT_EQ(base_text(result), "Base 18.0 mm");
}

/// Lines and texts stay what they are in PDF and SVG; many grains are an image there, few are circles.
TEST(Draw, VectorFormatsAreSmallAndRepeatable) {
  const std::vector<Sphere> pile = test::cone(5e-3, 30.0);
  const AngleOfRepose angle = *angle_of_repose(pile, {});
  const Picture picture = silhouette_picture(angle, pile, {});
  EXPECT_EQ(picture.pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(picture.pdf.find("CreationDate"), std::string::npos);
  EXPECT_NE(picture.pdf.find("/Font"), std::string::npos);
  EXPECT_EQ(picture.svg.substr(0, 5), "<?xml");
  EXPECT_NE(picture.svg.find("<image"), std::string::npos);
  EXPECT_NE(picture.svg.find("<path"), std::string::npos);
  EXPECT_LT(picture.pdf.size(), 4'000'000U);
  EXPECT_LT(picture.svg.size(), 4'000'000U);
  const Picture again = silhouette_picture(angle, pile, {});
  EXPECT_EQ(again.png, picture.png);
  EXPECT_EQ(again.pdf, picture.pdf);
  const auto is_image = [&](std::size_t grains) {
    return silhouette_picture(angle, std::span(pile).first(grains), {}).svg.find("<image") != std::string::npos;
  };
  ASSERT_GT(pile.size(), 3001U);
  EXPECT_TRUE(is_image(3001));
  EXPECT_FALSE(is_image(3000));
}

}  // namespace
}  // namespace repose
