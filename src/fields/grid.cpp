#include "fields/grid.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"

namespace repose::fields {
namespace {

constexpr double most_cells = 2e7;  // 4 GB of fields

/// Origin, spacing and number of cells in one direction. A number is a double until it is known to be small.
struct Row {
  double origin, spacing, cells;
};

Row row_of_domain(double low, double high, double spacing) {
  const double cells = std::max(1.0, std::rint((high - low) / spacing));
  return {low, (high - low) / cells, cells};
}

/// One cell more at each end than rounding could ask for.
Row row_around(double low, double high, const Resolution& r) {
  const double first = std::floor((low - r.width) / r.spacing) - 1.0;
  const double last = std::ceil((high + r.width) / r.spacing) + 1.0;
  return {first * r.spacing, r.spacing, last - first};
}

}  // namespace

Grid grid_around(const Vec3& low, const Vec3& high, const DomainDeck& domain, const Resolution& resolution,
                 const std::string& file) {
  Grid grid;
  double product = 1.0;
  std::array<double, 3> count{};
  for (std::size_t d = 0; d < 3; ++d) {
    grid.periodic[d] = is_periodic(domain, static_cast<Axis>(d));
    const Row row = grid.periodic[d] ? row_of_domain(triple(domain.min)[d], triple(domain.max)[d], resolution.spacing)
                                     : row_around(triple(low)[d], triple(high)[d], resolution);
    grid.origin[d] = row.origin;
    grid.spacing[d] = row.spacing;
    count[d] = row.cells;
    product *= row.cells;
  }
  if (!(product <= most_cells)) {
    throw DeckError(
        fmt::format("{}: {:.3g} x {:.3g} x {:.3g} cells of {:.3g} m are more than {:.0e}; give a larger "
                    "--spacing",
                    file, count[0], count[1], count[2], resolution.spacing, most_cells));
  }
  for (std::size_t d = 0; d < 3; ++d) grid.cells[d] = static_cast<std::size_t>(count[d]);
  return grid;
}

}  // namespace repose::fields
