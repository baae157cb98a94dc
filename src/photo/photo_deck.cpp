#include "photo/photo_deck.h"

#include <algorithm>

#include "deck/key_reference.h"
#include "deck/read_described.h"

namespace repose::photo {
namespace {

/// Two places that make sense together only.
void check_pair(DeckErrors& errors, const std::string& from_key, const std::array<double, 2>& from,
                const std::string& to_key, const std::array<double, 2>& to) {
  if (is_given(from) != is_given(to)) {
    errors.add(is_given(from) ? from_key : to_key, "needs " + (is_given(from) ? to_key : from_key) + " as well");
  } else if (is_given(from) && from == to) {
    errors.add(to_key, "is the same place as " + from_key + "; choose two that lie apart");
  }
}

void check(PhotoDeck& deck, DeckErrors& errors) {
  const ScaleDeck& scale = deck.scale;
  check_pair(errors, "scale.bar_from", scale.bar_from, "scale.bar_to", scale.bar_to);
  if (is_given(scale.bar_from) != !std::isnan(scale.bar_length)) {
    errors.add(is_given(scale.bar_from) ? "scale.bar_from" : "scale.bar_length",
               "bar_from, bar_to and bar_length belong together");
  }
  const int given = (std::isnan(scale.pixels_per_mm) ? 0 : 1) + (is_given(scale.bar_from) ? 1 : 0) +
                    (std::isnan(scale.plate_width) ? 0 : 1);
  if (given != 1) {
    errors.add("scale", "has " + std::to_string(given) +
                            " of pixels_per_mm, bar_from with bar_to and bar_length, and plate_width; give one");
  }
  check_pair(errors, "pile.base_from", deck.pile.base_from, "pile.base_to", deck.pile.base_to);
  if (is_given(deck.pile.base_from) && deck.pile.base_from[0] == deck.pile.base_to[0]) {
    errors.add("pile.base_to", "stands above or below base_from; the plate's edge is level but for a tilt");
  }
  check_pair(errors, "crop_from", deck.crop_from, "crop_to", deck.crop_to);
  for (std::size_t i = 0; is_given(deck.crop_from) && i < 2; ++i) {
    if (deck.crop_to[i] < deck.crop_from[i] + 16.0) {
      errors.add("crop_to", "must lie at least 16 pixels to the right of crop_from and below it");
      break;
    }
  }
}

}  // namespace

std::string photo_keys() { return key_reference<PhotoDeck>("Keys of a file for repose photo."); }

PhotoDeck read_photo_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  return read_described<PhotoDeck>(text, path, overrides, check);
}

std::optional<double> pixels_per_metre(const ScaleDeck& scale) {
  if (!std::isnan(scale.pixels_per_mm)) return 1e3 * scale.pixels_per_mm;
  if (!is_given(scale.bar_from)) return {};
  return std::hypot(scale.bar_to[0] - scale.bar_from[0], scale.bar_to[1] - scale.bar_from[1]) / scale.bar_length;
}

Thresholds thresholds_of(const PhotoDeck& deck, double otherwise) {
  const double best = std::isnan(deck.threshold) ? otherwise : deck.threshold;
  return {best, std::max(0.05, best - deck.threshold_deviation), std::min(0.95, best + deck.threshold_deviation)};
}

}  // namespace repose::photo
