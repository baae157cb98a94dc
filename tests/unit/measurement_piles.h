#pragma once

#include <functional>
#include <vector>

#include "measurement/sphere.h"

/// Piles whose silhouette is known, and what may lie and fly about them.
namespace repose::test {

inline constexpr double diameter = 0.44e-3;  // CarboHSP 40/70

/// A heap on z = 0 bounded by z = height - slope(x) r: a close-packed core under a skin of grains that touch this
/// surface from inside, in rings at contact distance along the slope and along the ring. Core and skin overlap.
std::vector<Sphere> heap(double height, const std::function<double(double)>& slope, double skin_diameter = diameter);

/// heap with the same angle (degrees) on all sides.
std::vector<Sphere> cone(double height, double angle_deg, double skin_diameter = diameter);

/// A heap without a skin: the grains of a close-packed lattice, turned at random, whose centres lie within the cone.
std::vector<Sphere> rough_cone(double height, double angle_deg, unsigned seed);

/// `count` grains on the surface of a cone, half within it, at random and as many on each part of its area.
void strew(std::vector<Sphere>& grains, int count, double height, double angle_deg, unsigned seed);

/// `count` single grains on the plate, between the given distances from the axis.
void add_strays(std::vector<Sphere>& grains, int count, double from, double to, unsigned seed);

/// `count` single grains at random heights up to `height`, more than two diameters from each of the others.
void add_airborne(std::vector<Sphere>& grains, int count, double height, double radius, unsigned seed);

}  // namespace repose::test
