#pragma once

#include <optional>
#include <span>

#include "deck/deck.h"
#include "measurement/sphere.h"

namespace repose {

/// Slope in rad, against the horizontal, of the bed that a discharge leaves in a vessel with a flat floor, rising from
/// the orifice outwards: a straight line through the heights of the rings about the axis that lie between `fit_from`
/// and `fit_to` of the bed's height at the wall (docs/theory.md, "Bed that stays"). Grains that fly do not count, nor
/// does the order. Empty when fewer than three rings have such a height.
std::optional<double> retained_slope(const RetainedSlopeDeck& deck, std::span<const Sphere> grains);

}  // namespace repose
