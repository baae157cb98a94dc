#pragma once

#include <span>

#include "deck/deck.h"
#include "measurement/sphere.h"
#include "photo/image.h"

namespace repose::photo {

/// Simulated grains as a photograph would show them from the side, by the camera of measurement.angle_of_repose at
/// azimuth 0: light grains before a dark background, lit from the left and the front, without noise. Those below the
/// plate or above max_height are left out. DeckError when there are none or the picture had more than 400 million
/// pixels.
Image rendered_pile(std::span<const Sphere> grains, const AngleOfReposeDeck& deck, double pixels_per_mm);

/// The same from above, as measurement.scattering sees them: x to the right, y upwards, the axis in the middle.
Image rendered_plate(std::span<const Sphere> grains, const ScatteringDeck& deck, double pixels_per_mm);

}  // namespace repose::photo
