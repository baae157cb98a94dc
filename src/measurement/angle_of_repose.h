#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "deck/deck.h"
#include "measurement/silhouette.h"
#include "measurement/sphere.h"

namespace repose {

/// How the angle of repose is read off a pile. Lengths in m.
struct AngleOfReposeParameters {
  double plate_height = 0.0;  ///< z of the plate
  Vec3 axis{};                ///< a point on the pile's vertical axis; x and y count
  double fit_from = 0.2;      ///< the fitted part of each flank, as shares of the silhouette's height above the plate
  double fit_to = 0.8;
  std::size_t azimuths = 36;  ///< number of views, spread evenly over half a turn
  double camera_distance = std::numeric_limits<double>::infinity();  ///< from the axis; infinite: orthographic
  double camera_height = 0.0;                                        ///< z; counts at a finite distance
};

/// Those of a deck's section.
AngleOfReposeParameters parameters_of(const AngleOfReposeDeck& deck);

/// The view of their camera at this azimuth (rad).
View view_at(const AngleOfReposeParameters& parameters, double azimuth);

/// u = u_mid + slope (z - z_mid), m; the angle is the one between the line and the plate, inside the pile (degrees).
struct FlankLine {
  double z_mid = 0.0;
  double u_mid = 0.0;
  double slope = 0.0;
  double angle_deg = 0.0;

  double u(double z) const { return u_mid + slope * (z - z_mid); }
};

/// One view: the lines fitted between the heights z_from and z_to (m).
struct FlankView {
  double azimuth = 0.0;  ///< rad, see View
  double z_from = 0.0;
  double z_to = 0.0;
  FlankLine left, right;

  double mean_deg() const { return 0.5 * (left.angle_deg + right.angle_deg); }
};

/// The lines of one outline, between fit_from and fit_to of its height above its base. DeckError when these enclose
/// fewer than two image rows.
FlankView fit_flanks(const Silhouette& outline, double fit_from, double fit_to);

struct AngleOfRepose {
  double mean_deg = 0.0;  ///< of left and right
  double left_deg = 0.0;  ///< mean over the views; left is the half of the pile with x below the axis
  double right_deg = 0.0;
  double stderr_deg = 0.0;         ///< of mean_deg; NaN with a single view
  double independent_views = 0.0;  ///< the number of views that stderr_deg reckons with, at most the number taken

  double pile_height = 0.0;  ///< highest point above the plate, m
  double pile_volume = 0.0;  ///< of the grains without voids, m^3
  std::size_t pile_grains = 0;

  std::vector<FlankView> views;
  Silhouette silhouette;  ///< of the first view, which is at azimuth 0
};

/// The angle of repose of `pile` (find_pile) by the method of the thesis, section 3.3.1: a line is fitted to each flank
/// of the side silhouette, left and right angle are averaged, and so are the views. Empty when the pile is.
///
/// Least squares of u over z: the height of an image row is exact, all roughness is in u, and so the slope is unbiased;
/// fitted the other way round or orthogonally, the roughness of the outline would tilt the line. The outline lies
/// inside the envelope of the pile by a share of a diameter, nearly the same at all heights, which moves the line and
/// leaves its slope. Nearly: towards the tip fewer grains compete for the outline, so that a rough pile of eleven
/// diameters looks flatter than the cone around it by 0.1 to 0.5 degree (0.1 at 34 diameters).
///
/// Neighbouring views see many of the same grains. The standard error therefore counts the independent views: the
/// number of views over 1 + 2 sum rho_k, rho_k the autocorrelation of the views' angles (periodic, over the leading
/// positive k). DeckError when the fitted heights enclose fewer than two image rows or the camera stands in the pile.
std::optional<AngleOfRepose> angle_of_repose(std::span<const Sphere> pile, const AngleOfReposeParameters& parameters);

}  // namespace repose
