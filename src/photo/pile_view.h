#pragma once

#include <string>

#include "measurement/angle_of_repose.h"
#include "photo/image.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// A pile as one photograph from the side shows it. u and z in m, from the pile's axis and the plate.
struct PileView {
  Silhouette outline;
  FlankView fit;
  double height = 0.0;            ///< m
  double base_width = 0.0;        ///< between the fitted lines at the plate, m
  double threshold_deg = 0.0;     ///< what the threshold's deviation makes of the mean angle, degrees
  double threshold_height = 0.0;  ///< and of the height, m
  double pixels_per_metre = 0.0;
  double tilt = 0.0;         ///< of the camera, rad; positive: the plate descends to the right
  double axis_column = 0.0;  ///< in the levelled picture, px
  double base_row = 0.0;     ///< where z is 0
  double blur = 0.0;         ///< width of the outline's edge from 10 to 90 % of the contrast, px
  double contrast = 0.0;
  double noise = 0.0;
  bool is_light = true;
  bool plate_is_seen = false;
};

/// Finds the pile, its base line and its outline, and fits its flanks as those of a simulated pile
/// (measurement/angle_of_repose.h). `parameters` are those of the base deck, for the share of the flanks and the
/// camera. `name` is for messages. DeckError when there is no pile, or two, when it is cut off at the edge, out of
/// focus or no heap: with the setting that would help.
PileView measure_pile(const Image& image, const PhotoDeck& deck, const AngleOfReposeParameters& parameters,
                      const std::string& name);

}  // namespace repose::photo
