#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace repose::thermal {

using Point = std::array<double, 3>;  ///< x, y, z in m

/// A grain as heat sees it.
struct Grain {
  Point centre;
  double radius = 0.0;       ///< m
  std::size_t material = 0;  ///< index of the deck
};

/// The directions in which grains have images, and their distances in m; 0: none.
struct Periods {
  Point length = {0.0, 0.0, 0.0};
};

/// Two grains that are close enough to conduct.
struct Link {
  std::size_t first = 0;
  std::size_t second = 0;
  Point difference;       ///< from the first's centre to that of the nearest image of the second, m
  double distance = 0.0;  ///< of the centres, m
};

/// All pairs whose surfaces are apart by at most `max_gap` times their mean radius, each once, by cells. In a periodic
/// direction the domain must be at least three of the largest reaches long, else DeckError: a grain would meet two
/// images of another.
std::vector<Link> links_of(const std::vector<Grain>& grains, const Periods& periods, double max_gap);

}  // namespace repose::thermal
