#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "deck/deck.h"
#include "photo/observable_text.h"
#include "photo/photo_deck.h"
#include "pictures/canvas.h"

/// From files to figures: what `repose photo pile` and `repose photo plate` do.
namespace repose::photo {

using Json = nlohmann::ordered_json;

struct PhotoFile {
  std::string name;
  std::string bytes;
};

struct PhotoResult {
  std::string text;               ///< what the user sees
  Json json;                      ///< every figure
  std::vector<Picture> pictures;  ///< of each photograph what was found in it
  std::vector<MeasuredFigure> figures;
};

/// Measures the pile of each photograph as measurement.angle_of_repose of `base` says. DeckError when the base has no
/// such section, and as measure_pile.
PhotoResult measure_piles(const std::vector<PhotoFile>& photographs, const PhotoDeck& deck, const Deck& base);

/// Counts the grains of each photograph as measurement.scattering of `base` says. DeckError likewise.
PhotoResult measure_plates(const std::vector<PhotoFile>& photographs, const PhotoDeck& deck, const Deck& base);

}  // namespace repose::photo
