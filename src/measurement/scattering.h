#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deck/deck.h"
#include "measurement/sphere.h"

namespace repose {

/// The grains in a part of the plate.
struct AreaCount {
  double from = 0.0;         ///< distance from the axis, m
  std::optional<double> to;  ///< m; empty: to the plate's edge
  std::int64_t count = 0;
  double error = 0.0;  ///< of the count
};

/// What lies around a pile, seen from above (thesis, section 3.6).
struct Scattering {
  std::optional<double> measured_base_radius;  ///< m; empty when there is no pile
  double base_radius = 0.0;                    ///< m, from which the areas are counted
  AreaCount area_1;                            ///< the ring next to the base
  std::optional<AreaCount> area_2;             ///< between the others; empty when area 1 reaches area 3
  AreaCount area_3;                            ///< from the outermost circle to the plate's edge
  std::vector<AreaCount> area_1_widened;
  std::vector<AreaCount> area_3_widened;  ///< at most to the base
  std::int64_t off_plate = 0;             ///< grains beside the plate or below it, and those that have left the domain
};

/// Where the dense part about an axis ends, in the unit of ring_width: between the middle of the outermost ring whose
/// density is at least `least` and that of the next, interpolated. `densities` are those of rings of this width from
/// the axis on; the last is that of a ring with nothing in it. Empty when no ring is as dense.
std::optional<double> end_of_dense_part(std::span<const double> densities, double ring_width, double least);

/// The radius in m of the base of the pile among `grains`, from the number density of the grains that lie on the plate
/// in rings about the axis: it ends where the density falls below base_share of that under the pile, interpolated
/// between the outermost ring that is as dense and the next. The density under the pile is what the densest rings that
/// hold a quarter of these grains have at least. Empty when there is no pile (find_pile).
std::optional<double> base_radius(const ScatteringDeck& deck, std::span<const Sphere> grains);

/// Counts the grains in the areas of `deck`: those with their centre over the plate, between its height and max_height.
/// The counting error is the root of the count (Poisson), 1 for none. Neither base nor counts depend on the order of
/// the grains. `left_domain` grains are not among them any more. Empty without a base; DeckError when the base reaches
/// the outermost circle.
std::optional<Scattering> scattering(const ScatteringDeck& deck, std::span<const Sphere> grains,
                                     std::int64_t left_domain);

}  // namespace repose
