#pragma once

#include <optional>
#include <string>

#include "photo/subject.h"

namespace repose::photo {

/// The levelled picture and where the pile stands in it.
struct Level {
  Image excess;
  double tilt = 0.0;
  double base_row = 0.0;
  std::optional<double> plate_pixels;  ///< width of the plate, where it is seen
};

/// Finds the line on which the pile stands, or takes it from the deck, and levels the picture by it. DeckError when
/// nothing stands out, or when much of it lies below a line that was found or that line is steep; `name` is for
/// messages.
Level find_level(const Subject& subject, const PhotoDeck& deck, const std::string& name);

/// A threshold for what certainly stands out, to find where the pile is.
double rough_threshold(const Subject& subject);

/// DeckError: no pile, because of `what`.
[[noreturn]] void no_pile(const std::string& name, const std::string& what);

}  // namespace repose::photo
