#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measurement/sphere.h"

namespace repose {

/// The grains of the largest cluster of touching ones (clusters.h, at a gap of 0.05): a bed without what flies.
std::vector<Sphere> largest_cluster(std::span<const Sphere> grains);

/// In m; the same in any order of the grains, of which there is at least one.
double mean_diameter(std::span<const Sphere> grains);

/// The straight line nearest to points (least squares), which are added one by one.
class StraightLine {
 public:
  void add(double x, double y);
  std::size_t count() const { return static_cast<std::size_t>(n_); }
  /// For at least two points that differ in x.
  double slope() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

}  // namespace repose
