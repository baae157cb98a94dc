#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "base/vec3.h"
#include "deck/deck.h"

namespace repose::fields {

using Triple = std::array<double, 3>;  ///< of x, y and z

inline Triple triple(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Equal cells beside one another; x runs fastest.
struct Grid {
  Triple origin{};   ///< m, the lowest corner
  Triple spacing{};  ///< m, of the cells
  std::array<std::size_t, 3> cells{};
  std::array<bool, 3> periodic{};  ///< in such a direction the cells are those of the domain, which repeats itself

  std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
  double cell_volume() const { return spacing[0] * spacing[1] * spacing[2]; }  ///< m3
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const { return (z * cells[1] + y) * cells[0] + x; }
};

/// How fine fields are.
struct Resolution {
  double width = 0.0;    ///< m, half-width of the kernel
  double spacing = 0.0;  ///< m, of the cells
};

/// The grid that holds all kernels about points from `low` to `high`; its cells begin at multiples of the spacing, so
/// that those of several states coincide. In a periodic direction it is the domain, whose cells are as near the spacing
/// as a whole number of them allows. DeckError, beginning with `file`, where it would have too many cells.
Grid grid_around(const Vec3& low, const Vec3& high, const DomainDeck& domain, const Resolution& resolution,
                 const std::string& file);

}  // namespace repose::fields
