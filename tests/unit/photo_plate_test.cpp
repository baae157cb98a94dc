#include <gtest/gtest.h>

#include "deck_error.h"
#include "photo/found_picture.h"
#include "photo/plate_view.h"
#include "photo_samples.h"

namespace repose::photo {
namespace {

using test::deck_error;

/// 10 px to a millimetre: discs of 1.2 mm.
ScatteringDeck scattering_deck() {
  ScatteringDeck deck;
  deck.enabled = true;
  deck.plate_height = 0.0;
  deck.plate_min = {-0.029, -0.029, 0.0};
  deck.plate_max = {0.029, 0.029, 0.0};
  deck.area_1_width = 5e-3;
  deck.area_3_radius = 20e-3;
  return deck;
}

/// Discs that touch in a hexagon of this radius (px) about the middle: a pile from above.
std::vector<Pixel> heap(double radius, Pixel middle = {300.0, 300.0}) {
  std::vector<Pixel> centres;
  for (int i = -40; i <= 40; ++i) {
    for (int j = -40; j <= 40; ++j) {
      const Pixel p{12.0 * (i + 0.5 * j), 12.0 * std::sqrt(0.75) * j};
      if (std::hypot(p.x, p.y) < radius) centres.push_back({middle.x + p.x, middle.y + p.y});
    }
  }
  return centres;
}

/// Grains at this distance (px), evenly about the middle.
void add_ring(std::vector<Pixel>& centres, double radius, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * (i + 0.3) / count;
    centres.push_back({300.0 + radius * std::cos(angle), 300.0 + radius * std::sin(angle)});
  }
}

Image plate_picture(const std::vector<Pixel>& centres, double front = 0.8,
                    const Backdrop& backdrop = {.width = 600, .height = 600}) {
  Image shares(backdrop.width, backdrop.height);
  for (const Pixel& c : centres) {
    const Discs disc{.centres = {c}, .radius = 6.0};
    for (double y = std::floor(c.y) - 7.0; y < c.y + 8.0; y += 1.0) {
      for (double x = std::floor(c.x) - 7.0; x < c.x + 8.0; x += 1.0) {
        if (x < 0.0 || y < 0.0) continue;
        float& share = shares.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        share = std::max(share, static_cast<float>(disc.share(x, y)));
      }
    }
  }
  return picture(backdrop, front, [&](double x, double y) {
    return static_cast<double>(shares.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)));
  });
}

PlateView measure(const Image& image, const PhotoDeck& deck = deck_with_scale(10.0),
                  const ScatteringDeck& scattering = scattering_deck()) {
  return measure_plate(image, deck, scattering, "p.jpg");
}

TEST(PhotoPlate, SingleGrainsInTheirAreas) {
  std::vector<Pixel> centres = heap(100.0);
  add_ring(centres, 135.0, 12);
  add_ring(centres, 180.0, 17);
  add_ring(centres, 250.0, 23);
  for (const double front : {0.8, 0.0}) {
    const PlateView view = measure(plate_picture(centres, front));
    EXPECT_EQ(view.is_light, front > 0.5);
    // The last ring of two diameters that is dense reaches to 10 mm.
    ASSERT_TRUE(view.measured_base_radius);
    EXPECT_NEAR(*view.measured_base_radius, 10.5e-3, 1.2e-3);
    ASSERT_EQ(view.areas.size(), 3U);
    EXPECT_EQ(view.areas[0].count, 12.0);
    EXPECT_EQ(view.areas[1].count, 17.0);
    EXPECT_EQ(view.areas[2].count, 23.0);
    EXPECT_EQ(view.single, 52.0);
    EXPECT_EQ(view.merged, 0.0);
    EXPECT_NEAR(view.axis.x, 300.0, 0.5);
    EXPECT_NEAR(view.axis.y, 300.0, 0.5);
    EXPECT_NEAR(view.grain_diameter, 1.2e-3, 3e-5);
    EXPECT_EQ(view.seen_share, 1.0);
  }
}

TEST(PhotoPlate, GrainsThatTouchAreCountedOneByOne) {
  std::vector<Pixel> centres = heap(100.0);
  add_ring(centres, 250.0, 10);
  // A pair, a chain of four and a triangle in area 2.
  for (const Pixel p :
       {Pixel{470.0, 300.0}, Pixel{481.0, 304.0}, Pixel{300.0, 480.0}, Pixel{311.8, 480.0}, Pixel{323.6, 480.0},
        Pixel{335.4, 480.0}, Pixel{120.0, 300.0}, Pixel{131.8, 300.0}, Pixel{126.0, 310.2}}) {
    centres.push_back(p);
  }
  const PlateView view = measure(plate_picture(centres));
  EXPECT_EQ(view.areas[1].count, 9.0);
  EXPECT_EQ(view.merged, 9.0);
  EXPECT_LE(view.doubtful, 1.0);
  EXPECT_EQ(view.areas[2].count, 10.0);
}

TEST(PhotoPlate, WithoutAPileTheDeckGivesAxisAndBase) {
  std::vector<Pixel> centres;
  add_ring(centres, 130.0, 21);
  PhotoDeck deck = deck_with_scale(10.0);
  ScatteringDeck scattering = scattering_deck();
  EXPECT_NE(deck_error([&] { measure(plate_picture(centres), deck, scattering); }).find("plate.axis"),
            std::string::npos);
  deck.plate.axis = {300.0, 300.0};
  EXPECT_NE(deck_error([&] { measure(plate_picture(centres), deck, scattering); }).find("base_radius"),
            std::string::npos);
  scattering.base_radius = 10e-3;
  const PlateView view = measure(plate_picture(centres), deck, scattering);
  EXPECT_FALSE(view.measured_base_radius);
  EXPECT_EQ(view.areas[0].count, 21.0);
}

// Whatever radius the areas are counted from.
TEST(PhotoPlate, TheTitleHasTheBaseThatWasMeasured) {
  PlateView view;
  view.base_radius = 11e-3;
  view.areas = {{.number = 1, .to = {}, .count = 78.0}, {.number = 3, .to = {}, .count = 72.0}};
  EXPECT_EQ(found_plate_title(view), "No base, area 1: 78, area 3: 72");
  view.measured_base_radius = 9e-3;
  EXPECT_EQ(found_plate_title(view), "Base 18.00 mm, area 1: 78, area 3: 72");
}

TEST(PhotoPlate, WhatCannotBeCountedIsRefused) {
  std::vector<Pixel> centres = heap(100.0);
  add_ring(centres, 180.0, 17);
  const auto refusal = [](const Image& image, const PhotoDeck& deck, const ScatteringDeck& scattering) {
    return deck_error([&] { measure(image, deck, scattering); });
  };
  const PhotoDeck deck = deck_with_scale(10.0);
  const ScatteringDeck scattering = scattering_deck();
  EXPECT_NE(refusal(plate_picture({}), deck, scattering).find("no grains are found"), std::string::npos);
  ScatteringDeck wide = scattering;
  wide.area_3_radius = 40e-3;
  EXPECT_NE(refusal(plate_picture(centres), deck, wide).find("within area_3_radius"), std::string::npos);
  ScatteringDeck narrow = scattering;
  narrow.area_3_radius = 8e-3;
  EXPECT_NE(refusal(plate_picture(centres), deck, narrow).find("choose a greater one"), std::string::npos);
  PhotoDeck plate = deck_with_scale(unset);
  plate.scale.plate_width = 0.06;
  EXPECT_NE(refusal(plate_picture(centres), plate, scattering).find("piles from the side"), std::string::npos);

  std::vector<Pixel> two = heap(80.0, {150.0, 300.0});
  for (const Pixel& p : heap(80.0, {450.0, 300.0})) two.push_back(p);
  add_ring(two, 280.0, 17);
  EXPECT_NE(refusal(plate_picture(two), deck, scattering).find("two piles"), std::string::npos);

  std::vector<Pixel> cut = heap(100.0, {60.0, 300.0});
  add_ring(cut, 180.0, 17);
  EXPECT_NE(refusal(plate_picture(cut), deck, scattering).find("cut off"), std::string::npos);

  // Grains of which a camera out of focus makes cones of twice their width.
  const Image blurred = picture({.width = 600, .height = 600}, 0.8, [&](double x, double y) {
    const double pile = 100.0 - std::hypot(x - 300.0, y - 300.0);
    double share = pile;
    for (const Pixel& c : centres) {
      if (std::hypot(c.x - 300.0, c.y - 300.0) > 110.0) {
        share = std::max(share, 0.7 * (1.0 - std::hypot(x - c.x, y - c.y) / 14.0));
      }
    }
    return share;
  });
  EXPECT_NE(refusal(blurred, deck, scattering).find("out of focus"), std::string::npos);
}

}  // namespace
}  // namespace repose::photo
