#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "measurement/sphere.h"

namespace repose {

/// A horizontal view of the pile. At azimuth 0 the camera looks along +y and sees +x to the right; the azimuth (rad)
/// turns both about the vertical through `axis`, counter-clockwise seen from above. Lengths in m.
struct View {
  Vec3 axis{};  ///< x and y count
  double azimuth = 0.0;
  double camera_distance = std::numeric_limits<double>::infinity();  ///< from the axis; infinite: orthographic
  double camera_height = 0.0;                                        ///< z of the camera; counts at a finite distance
};

/// A grain in the image plane, which is the vertical plane through the axis: lengths there are true lengths.
struct Disc {
  double u = 0.0;  ///< to the right of the axis
  double z = 0.0;
  double radius = 0.0;
  double nearness = 0.0;  ///< distance of the grain's centre from the image plane, towards the camera
};

/// The grains as `view` sees them. A pinhole enlarges a grain by camera_distance / (distance along the view); that its
/// image is a slightly stretched disc (by less than (u / camera_distance)^2) is neglected.
/// DeckError when the camera stands in or before a grain.
std::vector<Disc> project(std::span<const Sphere> grains, const View& view);

/// The outline of the discs as rows of an image: the horizontal extent of all discs at each height.
struct Silhouette {
  double base = 0.0;  ///< z of the lower edge of row 0
  double row_height = 0.0;
  double top = 0.0;                 ///< z of the highest point
  std::vector<double> left, right;  ///< u; NaN where a row meets no disc

  double row_z(std::size_t row) const { return base + (static_cast<double>(row) + 0.5) * row_height; }
};

/// Rows of `row_height` (m, positive) from `base` to the top of the discs; what lies lower is not seen.
Silhouette silhouette(std::span<const Disc> discs, double base, double row_height);

}  // namespace repose
