#include <gtest/gtest.h>

#include "deck_error.h"
#include "photo/patches.h"
#include "photo/pile_view.h"
#include "photo_samples.h"

namespace repose::photo {
namespace {

using test::deck_error;

PileView measure(const Image& image, PhotoDeck deck = deck_with_scale(10.0), AngleOfReposeParameters parameters = {}) {
  return measure_pile(image, deck, parameters, "p.jpg");
}

Image heap_picture(const Heap& heap, const Backdrop& backdrop = {}, double front = 0.8) {
  return picture(backdrop, front, [&](double x, double y) { return heap.share(x, y); });
}

/// Below the heap a plate of 500 px, as bright as half the contrast.
Image heap_on_plate() {
  const Heap heap;
  return picture({}, 0.8, [&](double x, double y) {
    const bool is_plate = y > heap.foot.y && x >= 50.0 && x < 550.0;
    return is_plate ? 0.5 : heap.share(x, y);
  });
}

// The edge is one pixel wide and its rows are exact: what is left is noise over a hundred rows.
constexpr double exact_deg = 0.05;

TEST(PhotoPile, FlanksOfAHeapOfKnownAngles) {
  const PileView view = measure(heap_picture({.left_deg = 25.0, .right_deg = 35.0}));
  EXPECT_NEAR(view.fit.left.angle_deg, 25.0, exact_deg);
  EXPECT_NEAR(view.fit.right.angle_deg, 35.0, exact_deg);
  // The lines meet where 360 px = h (cot 25 + cot 35).
  EXPECT_NEAR(view.height, 1e-4 * 360.0 / (1.0 / std::tan(25.0 * pi / 180.0) + 1.0 / std::tan(35.0 * pi / 180.0)),
              2e-4);
  EXPECT_NEAR(view.base_width, 36e-3, 4e-4);  // a pixel of the base line is 3.6 of the width
  EXPECT_TRUE(view.is_light);
  EXPECT_FALSE(view.plate_is_seen);
}

TEST(PhotoPile, TheTiltOfTheCameraIsTakenAway) {
  for (const double tilt : {-0.035, 0.02, 0.035}) {
    const PileView view = measure(heap_picture({.left_deg = 25.0, .right_deg = 35.0, .tilt = tilt}));
    EXPECT_NEAR(view.tilt, tilt, 2e-3);
    EXPECT_NEAR(view.fit.left.angle_deg, 25.0, 0.15) << tilt;
    EXPECT_NEAR(view.fit.right.angle_deg, 35.0, 0.15) << tilt;
  }
}

TEST(PhotoPile, DarkGrainsBeforeALightBackground) {
  const PileView view = measure(heap_picture({}, {.level = 0.8}, 0.2));
  EXPECT_FALSE(view.is_light);
  EXPECT_NEAR(view.fit.mean_deg(), 30.0, exact_deg);
}

TEST(PhotoPile, APlateThatIsSeenGivesBaseLineAndScale) {
  PhotoDeck deck = deck_with_scale(unset);
  deck.scale.plate_width = 50e-3;
  const PileView view = measure(heap_on_plate(), deck);
  EXPECT_TRUE(view.plate_is_seen);
  EXPECT_NEAR(view.pixels_per_metre, 1e4, 30.0);
  EXPECT_NEAR(view.base_row, Heap().foot.y, 1.0);
  EXPECT_NEAR(view.fit.mean_deg(), 30.0, exact_deg);
}

TEST(PhotoPile, AGivenBaseLineAndBar) {
  PhotoDeck deck = deck_with_scale(unset);
  deck.scale.bar_from = {100.0, 100.0};
  deck.scale.bar_to = {400.0, 500.0};  // 500 px
  deck.scale.bar_length = 0.1;
  deck.pile.base_from = {0.0, 310.0};  // above the foot: a smaller heap
  deck.pile.base_to = {599.0, 310.0};
  const PileView view = measure(heap_picture({}), deck);
  EXPECT_NEAR(view.pixels_per_metre, 5000.0, 1e-9);
  EXPECT_NEAR(view.base_width, (360.0 - 40.0 * std::tan(pi / 3.0)) / 5000.0, 1e-3);
  EXPECT_NEAR(view.fit.mean_deg(), 30.0, exact_deg);
}

TEST(PhotoPile, ACameraAboveThePlateSeesTheEdgeBehindTheAxisTooHigh) {
  // 1 m away and 0.1 m up, an edge 50 mm behind the axis is seen 0.1 (1 - 1/1.05) = 4.76 mm above the plate there.
  AngleOfReposeParameters parameters;
  parameters.camera_distance = 1.0;
  parameters.camera_height = 0.1;
  PhotoDeck deck = deck_with_scale(10.0);
  deck.pile.base_from = {0.0, 282.4};
  deck.pile.base_to = {599.0, 282.4};
  deck.pile.edge_behind_axis = 0.05;
  const PileView view = measure(heap_picture({}), deck, parameters);
  EXPECT_NEAR(view.base_row, 330.0, 0.1);
  EXPECT_NEAR(view.base_width, 36e-3, 4e-4);
}

TEST(PhotoPile, APlatesWidthIsThatOfItsEdge) {
  // A camera 1 m away at the plate's height sees an edge 50 mm in front of the axis larger by 1/0.95, one behind it
  // smaller by 1/1.05.
  AngleOfReposeParameters parameters;
  parameters.camera_distance = 1.0;
  PhotoDeck deck = deck_with_scale(unset);
  deck.scale.plate_width = 50e-3;
  for (const double behind : {-0.05, 0.05}) {
    deck.pile.edge_behind_axis = behind;
    const PileView view = measure(heap_on_plate(), deck, parameters);
    EXPECT_NEAR(view.pixels_per_metre, 1e4 * (1.0 + behind), 30.0);
    EXPECT_NEAR(view.base_width, 36e-3 / (1.0 + behind), 4e-4);
  }
}

std::string refusal(const Image& image, PhotoDeck deck = deck_with_scale(10.0)) {
  return deck_error([&] { measure(image, deck); });
}

TEST(PhotoPile, WhatIsNoPictureOfAPileIsRefused) {
  EXPECT_NE(refusal(picture({}, 0.8, [](double, double) { return 0.0; })).find("p.jpg: no grains are found"),
            std::string::npos);
  EXPECT_NE(refusal(heap_picture({}, {.noise = 0.002}, 0.26)).find("too little contrast"), std::string::npos);
  EXPECT_NE(refusal(heap_picture({.foot = {100.0, 330.0}})).find("cut off at the left edge"), std::string::npos);
  EXPECT_NE(refusal(heap_picture({.half_width = 290.0, .left_deg = 52.0, .right_deg = 52.0})).find("the upper edge"),
            std::string::npos);
  EXPECT_NE(refusal(heap_picture({.half_width = 20.0})).find("pixels high"), std::string::npos);

  const Heap left{.foot = {150.0, 330.0}, .half_width = 100.0};
  const Heap right{.foot = {440.0, 330.0}, .half_width = 110.0};
  EXPECT_NE(refusal(picture({}, 0.8, [&](double x, double y) { return std::max(left.share(x, y), right.share(x, y)); }))
                .find("two piles"),
            std::string::npos);

  // The same heap with an edge that is twenty pixels wide.
  const Heap heap;
  EXPECT_NE(refusal(picture({}, 0.8, [&](double x, double y) { return (heap.share(x, y) - 0.5) / 20.0 + 0.5; }))
                .find("out of focus"),
            std::string::npos);

  // A picture frame is no heap.
  EXPECT_NE(refusal(picture({}, 0.8,
                            [](double x, double y) {
                              const double r = std::max(std::abs(x - 300.0), std::abs(y - 200.0));
                              return r > 80.0 && r < 120.0 && !(x > 300.0 && y < 200.0) ? 1.0 : 0.0;
                            }))
                .find("no pile is found"),
            std::string::npos);

  // A plate without a pile: its fitted edge is exact for some of these, and off by the last bit for others.
  for (const double top : {200.0, 230.0, 251.0, 300.0}) {
    for (const double width : {240.0, 333.0, 400.0, 500.0}) {
      const Image bare =
          picture({}, 0.8, [&](double x, double y) { return y >= top && x >= 50.0 && x < 50.0 + width ? 1.0 : 0.0; });
      EXPECT_NE(refusal(bare).find("no pile is found: nothing stands out above the base line"), std::string::npos)
          << top << ", " << width << ": " << refusal(bare);
    }
  }

  PhotoDeck plate = deck_with_scale(unset);
  plate.scale.plate_width = 0.05;
  EXPECT_NE(refusal(heap_picture({}), plate).find("scale.plate_width"), std::string::npos);
}

// From above, a heap is round: much of it lies below the line through what would be its feet. This one is pointed, so
// that its upper part has straight flanks.
TEST(PhotoPile, APhotographFromAboveIsRefused) {
  const std::string found = refusal(picture({}, 0.8, [](double x, double y) {
    const double up = 200.0 - y;
    return up < 0.0 ? 120.5 - std::hypot(x - 300.0, up) : 120.5 - std::abs(x - 300.0) - 0.8 * up;
  }));
  EXPECT_NE(found.find("p.jpg: no pile is found"), std::string::npos) << found;
  EXPECT_NE(found.find("from above"), std::string::npos) << found;
}

TEST(PhotoPile, ALineThatIsSteepIsTakenFromTheDeckAlone) {
  const Image steep = heap_picture({.left_deg = 25.0, .right_deg = 35.0, .tilt = 0.1});
  const std::string found = refusal(steep);
  EXPECT_NE(found.find("tilted by 5.7 degrees, above 5; "), std::string::npos) << found;
  PhotoDeck deck = deck_with_scale(10.0);
  deck.pile.base_from = {0.0, 330.0 - 300.0 * std::tan(0.1)};
  deck.pile.base_to = {600.0, 330.0 + 300.0 * std::tan(0.1)};
  EXPECT_NEAR(measure(steep, deck).fit.mean_deg(), 30.0, 0.15);
}

TEST(PhotoPatches, AreaCentreAndRoundness) {
  // Ten pixels across, discs that touch: one has a roundness of 1, two have 2/3, three 9/11.
  const auto patches = [](const Discs& discs) {
    return find_patches(200, 100, [&](std::size_t x, std::size_t y) {
      return discs.share(static_cast<double>(x), static_cast<double>(y)) > 0.5;
    });
  };
  const Patches one = patches({.centres = {{50.25, 40.5}}, .radius = 20.0});
  ASSERT_EQ(one.all.size(), 1U);
  EXPECT_NEAR(one.all[0].area, 400.0 * pi, 6.0);
  EXPECT_NEAR(one.all[0].x, 50.25, 0.05);
  EXPECT_NEAR(one.all[0].y, 40.5, 0.05);
  EXPECT_NEAR(one.all[0].roundness, 1.0, 0.005);
  EXPECT_EQ(one.all[0].left, 31U);
  EXPECT_EQ(one.all[0].right, 70U);

  const Patches two = patches({.centres = {{50.0, 40.0}, {79.5, 50.0}, {150.0, 30.0}}, .radius = 16.0});
  ASSERT_EQ(two.all.size(), 2U);
  EXPECT_NEAR(two.all[static_cast<std::size_t>(largest(two.all).first)].roundness, 2.0 / 3.0, 0.02);
  const Patches three = patches({.centres = {{50.0, 40.0}, {79.0, 40.0}, {64.5, 65.0}}, .radius = 15.0});
  ASSERT_EQ(three.all.size(), 1U);
  EXPECT_NEAR(three.all[0].roundness, 9.0 / 11.0, 0.03);
}

// A ring is one patch, although its rows begin as many.
TEST(PhotoPatches, PartsThatMeetLaterAreOne) {
  const Patches ring = find_patches(50, 50, [](std::size_t x, std::size_t y) {
    const double r = std::hypot(static_cast<double>(x) - 25.0, static_cast<double>(y) - 25.0);
    return r > 10.0 && r < 13.0;
  });
  EXPECT_EQ(ring.all.size(), 1U);
}

}  // namespace
}  // namespace repose::photo
