#include "photo/level.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "photo/base_line.h"
#include "photo/patches.h"

namespace repose::photo {
namespace {

constexpr double rough_share = 0.25;  // of the contrast

BaseLine given_line(const PhotoDeck& deck) {
  const auto& from = deck.pile.base_from;
  const auto& to = deck.pile.base_to;
  const double slope = (to[1] - from[1]) / (to[0] - from[0]);
  return {.y_at_0 = from[1] - slope * from[0], .slope = slope, .plate_left = {}, .plate_right = {}};
}

}  // namespace

double rough_threshold(const Subject& subject) { return std::max(6.0 * subject.noise, rough_share * subject.contrast); }

void no_pile(const std::string& name, const std::string& what) {
  throw DeckError(
      fmt::format("{}: no pile is found: {}; crop_from and crop_to, grains or pile.base_from and base_to say "
                  "where it is",
                  name, what));
}

Level find_level(const Subject& subject, const PhotoDeck& deck, const std::string& name) {
  BaseLine line;
  if (is_given(deck.pile.base_from)) {
    line = given_line(deck);
  } else {
    const double threshold = rough_threshold(subject);
    const Patches patches =
        find_patches(subject.excess.width, subject.excess.height,
                     [&](std::size_t x, std::size_t y) { return subject.excess.at(x, y) > threshold; });
    if (patches.all.empty()) no_pile(name, "nothing stands out from the background");
    line = find_base_line(subject.excess, patches, largest(patches.all).first);
  }
  Level result;
  result.tilt = std::atan(line.slope);
  result.excess = levelled(subject.excess, result.tilt);
  const double middle = 0.5 * static_cast<double>(subject.excess.width - 1);
  result.base_row = before_levelling(subject.excess, -result.tilt, {middle, line.y(middle)}).y;
  if (line.plate_left) result.plate_pixels = (*line.plate_right - *line.plate_left) / std::cos(result.tilt);
  return result;
}

}  // namespace repose::photo
