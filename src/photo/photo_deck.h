#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "deck/key.h"

namespace repose::photo {

enum class Channel { grey, red, green, blue };
constexpr auto enumerators(Channel) { return std::array<std::string_view, 4>{"grey", "red", "green", "blue"}; }

enum class Grains { found, light, dark };
constexpr auto enumerators(Grains) { return std::array<std::string_view, 3>{"found", "light", "dark"}; }

inline constexpr std::array<double, 2> no_place{unset, unset};

/// How long a pixel is.
struct ScaleDeck {
  bool enabled = false;  ///< true when the deck has the section
  double pixels_per_mm = unset;
  std::array<double, 2> bar_from = no_place, bar_to = no_place;  ///< px
  double bar_length = unset;
  double plate_width = unset;  ///< of the plate that a side view shows from edge to edge
  double deviation = 0.005;    ///< of the scale, share
};

/// Where the plate of a side view is.
struct PileViewDeck {
  std::array<double, 2> base_from = no_place, base_to = no_place;  ///< px; two points of the plate's edge
  double edge_behind_axis = 0.0;                                   ///< of the plate's edge that is seen, m
  double most_blur = 0.03;                                         ///< of the pile's height
};

/// What is seen from above.
struct PlateViewDeck {
  std::array<double, 2> axis = no_place;  ///< px; default: the middle of the pile
  double grain_diameter = unset;          ///< m, root mean square; default: the base deck's, or as in the picture
  double least_roundness = 0.9;           ///< of a patch that is one grain
  double layer_coverage = 0.77;           ///< share of the plate that the lowest layer of a pile covers
  double most_doubtful = 0.25;            ///< share of the grains by which the areas of clumps may say otherwise
};

/// How to measure photographs.
struct PhotoDeck {
  std::string title;
  std::string base;              ///< path of the deck that says what is measured, relative to this file
  std::vector<std::string> set;  ///< "key=value" for it
  Channel channel = Channel::grey;
  Grains grains = Grains::found;
  double threshold = unset;
  double threshold_deviation = 0.05;
  double least_contrast = 0.08;
  std::array<double, 2> crop_from = no_place, crop_to = no_place;  ///< px
  ScaleDeck scale;
  PileViewDeck pile;
  PlateViewDeck plate;
};

template <class V>
void describe(V& v, ScaleDeck& s) {
  v("pixels_per_mm", s.pixels_per_mm, Unit::none, above(0), optional, "pixels in a millimetre");
  v("bar_from", s.bar_from, Unit::none, any_value, optional, "or the ends of a length that is known: x and y, px");
  v("bar_to", s.bar_to, Unit::none, any_value, optional, "its other end");
  v("bar_length", s.bar_length, Unit::metre, above(0), optional, "its length");
  v("plate_width", s.plate_width, Unit::metre, above(0), optional,
    "or the width of a plate that the side view shows from edge to edge");
  v("deviation", s.deviation, Unit::none, from_to_below(0, 0.5), optional, "standard deviation of the scale, share");
}

template <class V>
void describe(V& v, PileViewDeck& p) {
  v("base_from", p.base_from, Unit::none, any_value, optional_else("found"),
    "a point of the plate's edge: x and y, px");
  v("base_to", p.base_to, Unit::none, any_value, optional_else("found"), "another point of it");
  v("edge_behind_axis", p.edge_behind_axis, Unit::metre, any_value, optional,
    "distance of that edge behind the pile's axis; counts with camera = perspective");
  v("most_blur", p.most_blur, Unit::none, above_to(0, 1), optional,
    "width of the outline's edge over the pile's height, above which a picture is out of focus");
}

template <class V>
void describe(V& v, PlateViewDeck& p) {
  v("axis", p.axis, Unit::none, any_value, optional_else("the middle of the pile"), "of the areas: x and y, px");
  v("grain_diameter", p.grain_diameter, Unit::metre, above(0),
    optional_else("of the base deck's grains where all are alike, or as in the picture"),
    "root mean square of the grains' diameters");
  v("least_roundness", p.least_roundness, Unit::none, above_to(0, 1), optional,
    "area squared over 2 pi times the polar second moment of what is one grain: 1 for a disc, 0.67 for two that touch");
  v("layer_coverage", p.layer_coverage, Unit::none, above_to(0, 1), optional,
    "share of the plate that the lowest layer of grains under a pile covers");
  v("most_doubtful", p.most_doubtful, Unit::none, from_to(0, 1), optional,
    "share of the grains beside the pile by which the areas of clumps may say more or fewer");
}

template <class V>
void describe(V& v, PhotoDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("base", d.base, Unit::none, any_value, required, "path of the deck that says what is measured");
  v("set", d.set, Unit::none, any_value, optional, "\"key=value\" texts that replace keys of it");
  v("channel", d.channel, Unit::none, any_value, optional, "what of a colour picture is looked at");
  v("grains", d.grains, Unit::none, any_value, optional, "before their background");
  v("threshold", d.threshold, Unit::none, Range{.min = 0, .max = 1, .excludes_min = true, .excludes_max = true},
    optional_else("0.3 for a pile, 0.5 for a plate"), "share of the contrast at which grains begin");
  v("threshold_deviation", d.threshold_deviation, Unit::none, from_to_below(0, 0.5), optional,
    "its standard deviation");
  v("least_contrast", d.least_contrast, Unit::none, above_to(0, 1), optional,
    "between grains and background, share of black to white, below which nothing is measured");
  v("crop_from", d.crop_from, Unit::none, at_least(0), optional_else("the whole picture"),
    "upper left corner of the part that is looked at: x and y, px");
  v("crop_to", d.crop_to, Unit::none, at_least(0), optional_else("the whole picture"), "its lower right corner");
  v.section("scale", d.scale, required, "how long a pixel is");
  v.section("pile", d.pile, optional, "a pile from the side");
  v.section("plate", d.plate, optional, "a plate from above");
}

/// All its keys, for a person.
std::string photo_keys();

/// Reads and checks it. DeckError, with the place, on the first mistake.
PhotoDeck read_photo_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides);

/// Whether a place was given.
inline bool is_given(const std::array<double, 2>& place) { return !std::isnan(place[0]); }

/// px/m, by pixels_per_mm or the bar; empty where the deck gives another length.
std::optional<double> pixels_per_metre(const ScaleDeck& scale);

/// The threshold of a picture, and those by which its deviation is felt.
struct Thresholds {
  double best = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};

/// Those of the deck; `otherwise` is the threshold that it does not give.
Thresholds thresholds_of(const PhotoDeck& deck, double otherwise);

}  // namespace repose::photo
