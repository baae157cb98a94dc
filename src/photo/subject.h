#pragma once

#include "photo/image.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// What stands out from a plain background: `excess` is how much lighter a pixel is than the background there, or how
/// much darker where the grains are dark: positive at the grains.
struct Subject {
  Image excess;
  double noise = 0.0;     ///< standard deviation of the background
  double contrast = 0.0;  ///< median excess of what stands out
  bool is_light = true;
};

/// Where the background of a picture is looked for.
enum class Ground { above, around };

/// Fits the background, whose brightness is a polynomial of second degree in x and y, to most pixels of the picture
/// (`around`), or to its upper and outer part (`above`: what lies below may be a plate), and takes it away. DeckError
/// when nothing stands out, or not by deck.least_contrast and five times the noise; `name` is for messages.
Subject find_subject(const Image& image, const PhotoDeck& deck, Ground ground, const std::string& name);

}  // namespace repose::photo
