#include "photo/level.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "photo/base_line.h"
#include "photo/patches.h"

namespace repose::photo {
namespace {

constexpr double rough_share = 0.25;  // of the contrast
constexpr double most_below = 0.2;    // of what stands out: a heap on a photograph from above has a quarter and more
constexpr double most_tilt_deg = 5.0;

BaseLine given_line(const PhotoDeck& deck) {
  const auto& from = deck.pile.base_from;
  const auto& to = deck.pile.base_to;
  const double slope = (to[1] - from[1]) / (to[0] - from[0]);
  return {.y_at_0 = from[1] - slope * from[0], .slope = slope, .plate_left = {}, .plate_right = {}};
}

/// Of the pixels of a patch.
double share_below(const BaseLine& line, const Patches& patches, std::int32_t which) {
  double below = 0.0, all = 0.0;
  patches.for_each_pixel(which, [&](std::size_t x, std::size_t y) {
    below += static_cast<double>(y) > line.y(static_cast<double>(x)) ? 1.0 : 0.0;
    all += 1.0;
  });
  return below / all;
}

/// Of a line that was found.
void check_line(const BaseLine& line, const Patches& patches, std::int32_t pile, const std::string& name) {
  const double below = line.plate_left ? 0.0 : share_below(line, patches, pile);
  if (below > most_below) {
    no_pile(name, fmt::format("{:.0f} % of what stands out lies below the line through its feet, as on a photograph "
                              "from above",
                              100.0 * below));
  }
  const double tilt = std::atan(line.slope) * 180.0 / pi;
  if (std::abs(tilt) > most_tilt_deg) {
    no_pile(name, fmt::format("its base line would be tilted by {:.1f} degrees, above {:.0f}", std::abs(tilt),
                              most_tilt_deg));
  }
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
    const std::int32_t pile = largest(patches.all).first;
    line = find_base_line(subject.excess, patches, pile);
    check_line(line, patches, pile, name);
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
