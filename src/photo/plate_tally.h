#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "deck/deck.h"
#include "photo/grain_patches.h"
#include "photo/grain_peaks.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// Where the plate is in the picture.
struct Frame {
  Pixel axis;
  double scale = 1.0;                                    ///< px/m
  double left = 0.0, right = 0.0, up = 0.0, down = 0.0;  ///< the plate's edges from the axis, m

  double distance(double x, double y) const { return std::hypot(x - axis.x, y - axis.y) / scale; }
  bool holds(double x, double y) const {
    const double u = (x - axis.x) / scale;
    const double v = (axis.y - y) / scale;
    return u >= left && u <= right && v >= down && v <= up;
  }
};

/// Areas 1, 2 and 3 as in scattering(): from, to.
struct Bounds {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

/// Of a base of this radius (m): areas 1, 2 unless 1 reaches 3, and 3.
std::vector<Bounds> bounds_of(double base, const ScatteringDeck& scattering);

/// Base and counts at one threshold and scale.
struct Tally {
  std::optional<double> base;
  std::vector<GrainPeak> peaks;
  std::vector<double> counts;
};

/// The base by coverage (plate_view.h), and the grains in the areas about it or about the radius that the deck gives.
/// `smoothed` is what smoothed_for makes of the picture and these grains.
Tally tally(const Image& smoothed, const GrainPatches& grains, const Frame& frame, const PhotoDeck& deck,
            const ScatteringDeck& scattering);

/// What grains look like: as shaded as they are, their patches are smaller or larger than they.
double seen_diameter(const GrainPatches& grains, double scale);

}  // namespace repose::photo
