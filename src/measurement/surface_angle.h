#pragma once

#include <optional>
#include <span>

#include "deck/deck.h"
#include "measurement/sphere.h"

namespace repose {

/// Slope in rad of the free surface of a bed in a drum, against the horizontal and across the drum's axis: a straight
/// line through the highest points of the grains in columns two mean diameters wide, within half_width x radius of the
/// axis. Grains that fly (no part of the largest cluster of touching ones) do not count. The sign says which side is
/// higher: positive, where the surface rises along axis x up. Empty when fewer than four columns hold grains,
/// or when gravity has no part across the axis.
std::optional<double> surface_angle(const SurfaceAngleDeck& deck, const Vec3& gravity, std::span<const Sphere> grains);

}  // namespace repose
