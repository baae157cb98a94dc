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

/// The same of a bed at rest, where it does not change as grains lose and find contacts: all grains count, and only
/// columns that are wholly within half_width x radius.
std::optional<double> surface_angle_at_rest(const SurfaceAngleDeck& deck, const Vec3& gravity,
                                            std::span<const Sphere> bed);

}  // namespace repose
