#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/philox.h"
#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// Relative: a sphere that just fits does, and a region that is an exact multiple of a spacing is filled to its ends.
inline constexpr double fit_rounding = 1e-9;

struct Box {
  Vec3 min;
  Vec3 max;
};

/// The box around the region of a block.
Box bounds(const ParticlesDeck& region);

/// Volume of the region in m^3; of a disc its area in m^2.
double region_size(const ParticlesDeck& region);

/// Whether a sphere stays inside a cylinder or cone frustum across its side wherever it is moved by up to `shift` (m)
/// along each axis; `tolerance` (m) is for rounding. Floor and top are not asked.
bool inside_side(const ParticlesDeck& frustum, const Vec3& centre, double radius, double shift, double tolerance);

/// Whether a sphere lies in a cylinder, cone frustum or box.
bool holds_sphere(const ParticlesDeck& region, const Vec3& centre, double radius);

/// A random place for a sphere in a region, where it may meet others and walls; a disc holds its centre and the circle
/// it cuts. Nothing when the numbers k, k+1, k+2 of the particle in the stream give a point where it does not lie in
/// the region.
std::optional<Vec3> random_place(const ParticlesDeck& region, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k);

/// Whether a sphere reaches into no present wall.
bool clear_of_walls(const Vec3& centre, double radius, const std::vector<Wall>& walls);

}  // namespace repose
