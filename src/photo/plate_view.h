#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measurement/scattering.h"
#include "photo/grain_patches.h"
#include "photo/grain_peaks.h"
#include "photo/image.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// Grains counted in a part of the plate, with what makes the count uncertain.
struct CountedArea {
  int number = 1;     ///< 1, 2 or 3
  double from = 0.0;  ///< distance from the axis, m
  std::optional<double> to;
  double count = 0.0;
  double chance = 0.0;     ///< root of the count, as in scattering()
  double threshold = 0.0;  ///< what the threshold's deviation makes of the count
  double scale = 0.0;      ///< and what the scale's does
};

/// Grains on a plate as one photograph from above shows them. Lengths in m.
struct PlateView {
  std::optional<double> measured_base_radius;
  double base_radius = 0.0;
  std::vector<CountedArea> areas;  ///< 1, 2 (unless 1 reaches 3) and 3
  double grain_diameter = 0.0;     ///< as seen: of the circle with the mean area of single grains
  double single = 0.0;             ///< grains beside the pile that stand alone
  double merged = 0.0;             ///< grains that touch others or the pile, beyond its base
  double doubtful = 0.0;           ///< by how many the areas of the clumps say more or fewer
  double specks = 0.0;             ///< too small for a grain: not counted
  double speck_grains = 0.0;       ///< their area, in grains
  double seen_share = 1.0;         ///< of the plate beyond the outermost circle that the picture shows
  double pixels_per_metre = 0.0;
  Pixel axis;  ///< px
  double contrast = 0.0;
  double noise = 0.0;
  bool is_light = true;
  GrainPatches grains;  ///< at the deck's threshold
  std::vector<GrainPeak> peaks;
};

/// Finds the grains of a picture from above and counts them in the areas of `scattering` as scattering() counts those
/// of a run: single grains by their centres, those in clumps and at the foot of the pile by their peaks
/// (grain_peaks.h). The base ends where the grains that are seen on an area fall below base_share of a layer at rest
/// (see docs/theory.md). `name` is for messages. DeckError, with the setting that would help, when there are no grains
/// or none alone, two piles, a pile cut off at the edge, grains of less than four pixels or out of focus, too many in
/// clumps, or when the picture ends before the outermost area.
PlateView measure_plate(const Image& image, const PhotoDeck& deck, const ScatteringDeck& scattering,
                        const std::string& name);

}  // namespace repose::photo
