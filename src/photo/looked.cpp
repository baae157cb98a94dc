#include "photo/looked.h"

#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "photo/photo_file.h"

namespace repose::photo {

Looked look_at(const PhotoFile& file, const PhotoDeck& deck) {
  Looked looked{read_photo(file.bytes, file.name, deck.channel), deck};
  const auto check = [&](double x, double y) {
    if (x >= 16.0 && y >= 16.0 && x <= static_cast<double>(looked.image.width) &&
        y <= static_cast<double>(looked.image.height)) {
      return;
    }
    throw DeckError(
        fmt::format("{}: has {} x {} pixels, looked at is the part that ends at [{}, {}]; at least 16 each way are "
                    "needed",
                    file.name, looked.image.width, looked.image.height, x, y));
  };
  if (!is_given(deck.crop_from)) {
    check(static_cast<double>(looked.image.width), static_cast<double>(looked.image.height));
    return looked;
  }
  check(deck.crop_to[0], deck.crop_to[1]);
  const auto pixel = [](double v) { return static_cast<std::size_t>(std::floor(v)); };
  looked.image = cropped(looked.image, {pixel(deck.crop_from[0]), pixel(deck.crop_from[1])},
                         {pixel(deck.crop_to[0]), pixel(deck.crop_to[1])});
  for (auto* place : {&looked.deck.pile.base_from, &looked.deck.pile.base_to, &looked.deck.plate.axis}) {
    for (std::size_t i = 0; i < 2; ++i) (*place)[i] -= std::floor(deck.crop_from[i]);
  }
  return looked;
}

}  // namespace repose::photo
