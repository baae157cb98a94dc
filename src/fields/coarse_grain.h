#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"
#include "fields/grid.h"

namespace repose::fields {

/// A grain as fields see it.
struct Grain {
  Vec3 centre;    ///< m
  Vec3 velocity;  ///< m/s
  double mass;    ///< kg
  double volume;  ///< m3
};

/// A force that acts on a grain at its contact with another or with a wall.
struct ContactForce {
  Vec3 centre;  ///< m, of the grain
  Vec3 other;   ///< m, centre of the other grain (of its image next to this one), or the touched point of the wall
  Vec3 force;   ///< N, on the grain
};

/// All contacts of a state, each once.
struct ContactForces {
  std::vector<ContactForce> pairs;
  std::vector<ContactForce> walls;
};

/// A tensor by rows: xx, xy, xz, yx, ...; xy is the flow of x momentum in the direction y.
using Tensor = std::array<double, 9>;

/// Means over the cells of a grid. Stresses are positive in compression.
struct Fields {
  Grid grid;
  std::vector<double> solid_fraction;
  std::vector<double> mass_density;    ///< kg/m3
  std::vector<Vec3> momentum;          ///< momentum density, kg/(m2 s)
  std::vector<Vec3> velocity;          ///< momentum over mass, m/s; 0 where there is no mass
  std::vector<double> temperature;     ///< granular, m2/s2: a third of the mean squared velocity about that of the cell
  std::vector<Tensor> contact_stress;  ///< Pa
  std::vector<Tensor> kinetic_stress;  ///< Pa
  std::vector<Vec3> wall_force;        ///< of the walls on the grains, N/m3
};

/// Coarse-grained fields with the kernel of half-width `width` m (Goldhirsch 2010, doi:10.1007/s10035-010-0181-z; at
/// walls Weinhart and others 2012, doi:10.1007/s10035-012-0317-4; docs/theory.md, "Coarse-grained fields"). Kernels
/// reach through walls and are never cut there. The same bits in whatever order grains and contacts come, and whichever
/// grain of a pair is named first.
Fields coarse_grain(const Grid& grid, double width, std::vector<Grain> grains, ContactForces contacts);

}  // namespace repose::fields
