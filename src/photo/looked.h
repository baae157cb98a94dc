#pragma once

#include "photo/image.h"
#include "photo/photo_deck.h"
#include "photo/photo_tool.h"

namespace repose::photo {

/// The part of a photograph that the deck looks at, and the deck with its places in px of that part.
struct Looked {
  Image image;
  PhotoDeck deck;
};

/// DeckError when the part lies beyond the picture, or the picture has less than 16 pixels in a direction.
Looked look_at(const PhotoFile& file, const PhotoDeck& deck);

}  // namespace repose::photo
