#include "fields/coarse_grain.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fields/kernel.h"

namespace repose::fields {
namespace {

auto key(const Vec3& v) { return std::tie(v.x, v.y, v.z); }
auto key(const Grain& g) { return std::tuple_cat(key(g.centre), key(g.velocity), std::tie(g.mass, g.volume)); }
auto key(const ContactForce& c) { return std::tuple_cat(key(c.centre), key(c.other), key(c.force)); }

/// The order of the sums must not be that of the input.
template <class T>
void sort(std::vector<T>& items) {
  std::sort(items.begin(), items.end(), [](const T& a, const T& b) { return key(a) < key(b); });
}

void name_the_lower_first(std::vector<ContactForce>& pairs) {
  for (ContactForce& c : pairs) {
    if (key(c.other) < key(c.centre)) c = {c.other, c.centre, -c.force};
  }
}

/// What cells of a row hold of a kernel: those from `first` on, which may lie outside the grid, to be wrapped or cut.
struct RowShares {
  std::ptrdiff_t first = 0;
  std::vector<double> share;
};

/// The cells that a kernel reaches. Its shares are products of those in the three directions: integrals of the kernel
/// over the cells, whose sum is 1.
class Deposit {
 public:
  Deposit(const Grid& grid, double width) : grid_(grid), width_(width) {}

  /// Calls visit(cell, share) for all cells that the kernel about `x` reaches.
  template <class Visit>
  void around(const Vec3& x, Visit&& visit) {
    const Triple at = triple(x);
    for (std::size_t d = 0; d < 3; ++d) fill(d, at[d]);
    for (std::size_t k = 0; k < row_[2].share.size(); ++k) {
      for (std::size_t j = 0; j < row_[1].share.size(); ++j) {
        const double share = row_[2].share[k] * row_[1].share[j];
        if (share == 0.0) continue;
        for (std::size_t i = 0; i < row_[0].share.size(); ++i) {
          if (row_[0].share[i] == 0.0) continue;
          const std::ptrdiff_t cell[3] = {place(0, i), place(1, j), place(2, k)};
          if (cell[0] < 0 || cell[1] < 0 || cell[2] < 0) continue;
          visit(grid_.index(static_cast<std::size_t>(cell[0]), static_cast<std::size_t>(cell[1]),
                            static_cast<std::size_t>(cell[2])),
                share * row_[0].share[i]);
        }
      }
    }
  }

  /// The same for the kernel's mean along the way from `from` to `to`, by Gauss and Legendre's rule of three points on
  /// pieces of at most half a knot interval: the pointwise error is below 1e-5 of the maximum, the sum of shares is
  /// exact. On a way of no length it is the kernel there.
  template <class Visit>
  void along(const Vec3& from, const Vec3& to, Visit&& visit) {
    constexpr std::array<double, 3> weight = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const double half_span = 0.5 * std::sqrt(0.6);
    const std::array<double, 3> place = {0.5 - half_span, 0.5, 0.5 + half_span};
    const Vec3 way = to - from;
    const double pieces = std::max(1.0, std::ceil(4.0 * norm(way) / width_));
    for (double piece = 0.0; piece < pieces; piece += 1.0) {
      for (std::size_t g = 0; g < place.size(); ++g) {
        around(from + ((piece + place[g]) / pieces) * way,
               [&](std::size_t cell, double share) { visit(cell, weight[g] / pieces * share); });
      }
    }
  }

 private:
  void fill(std::size_t d, double x) {
    RowShares& row = row_[d];
    const double spacing = grid_.spacing[d];
    const double from = std::floor((x - width_ - grid_.origin[d]) / spacing);
    const double to = std::floor((x + width_ - grid_.origin[d]) / spacing);
    row.first = static_cast<std::ptrdiff_t>(from);
    row.share.clear();
    double below = 0.0;  // of the whole kernel: rounding at its ends must not lose a share
    for (double cell = from; cell <= to; cell += 1.0) {
      const double up_to = cell == to ? 1.0 : kernel_below(grid_.origin[d] + (cell + 1.0) * spacing - x, width_);
      row.share.push_back(up_to - below);
      below = up_to;
    }
  }

  /// The cell of the grid, or -1.
  std::ptrdiff_t place(std::size_t d, std::size_t k) const {
    const auto count = static_cast<std::ptrdiff_t>(grid_.cells[d]);
    const std::ptrdiff_t cell = row_[d].first + static_cast<std::ptrdiff_t>(k);
    if (grid_.periodic[d]) return ((cell % count) + count) % count;
    return cell < count ? std::max<std::ptrdiff_t>(cell, -1) : -1;
  }

  const Grid& grid_;
  double width_;
  std::array<RowShares, 3> row_;
};

/// Adds factor * a b^T.
void add_product(Tensor& tensor, double factor, const Vec3& a, const Vec3& b) {
  const Triple left = triple(factor * a);
  const Triple right = triple(b);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) tensor[3 * i + j] += left[i] * right[j];
  }
}

/// Volume, mass and momentum.
void add_masses(const std::vector<Grain>& grains, double width, Fields& f) {
  const double volume = f.grid.cell_volume();
  Deposit deposit(f.grid, width);
  for (const Grain& g : grains) {
    deposit.around(g.centre, [&](std::size_t cell, double share) {
      f.solid_fraction[cell] += share * (g.volume / volume);
      f.mass_density[cell] += share * (g.mass / volume);
      f.momentum[cell] += (share * (g.mass / volume)) * g.velocity;
    });
  }
  for (std::size_t cell = 0; cell < f.grid.size(); ++cell) {
    if (f.mass_density[cell] > 0.0) f.velocity[cell] = (1.0 / f.mass_density[cell]) * f.momentum[cell];
  }
}

/// The kinetic part of the stress, with velocities about that of the cell: a sum of squares, which no rounding makes
/// negative.
void add_fluctuations(const std::vector<Grain>& grains, double width, Fields& f) {
  const double volume = f.grid.cell_volume();
  Deposit deposit(f.grid, width);
  for (const Grain& g : grains) {
    deposit.around(g.centre, [&](std::size_t cell, double share) {
      const Vec3 fluctuation = g.velocity - f.velocity[cell];
      add_product(f.kinetic_stress[cell], share * (g.mass / volume), fluctuation, fluctuation);
    });
  }
  for (std::size_t cell = 0; cell < f.grid.size(); ++cell) {
    const Tensor& s = f.kinetic_stress[cell];
    if (f.mass_density[cell] > 0.0) f.temperature[cell] = (s[0] + s[4] + s[8]) / (3.0 * f.mass_density[cell]);
  }
}

/// The contact part of the stress: force and branch, along the branch. At a wall the branch ends at the touched
/// point, where the wall's force is.
void add_contacts(const ContactForces& contacts, double width, Fields& f) {
  const double volume = f.grid.cell_volume();
  Deposit deposit(f.grid, width);
  for (const auto* list : {&contacts.pairs, &contacts.walls}) {
    for (const ContactForce& c : *list) {
      Tensor product{};
      add_product(product, 1.0 / volume, c.force, c.centre - c.other);
      deposit.along(c.other, c.centre, [&](std::size_t cell, double share) {
        for (std::size_t k = 0; k < product.size(); ++k) f.contact_stress[cell][k] += share * product[k];
      });
    }
  }
  for (const ContactForce& c : contacts.walls) {
    deposit.around(c.other, [&](std::size_t cell, double share) { f.wall_force[cell] += (share / volume) * c.force; });
  }
}

}  // namespace

Fields coarse_grain(const Grid& grid, double width, std::vector<Grain> grains, ContactForces contacts) {
  name_the_lower_first(contacts.pairs);
  sort(grains);
  sort(contacts.pairs);
  sort(contacts.walls);
  const std::size_t n = grid.size();
  Fields f = {.grid = grid,
              .solid_fraction = std::vector<double>(n),
              .mass_density = std::vector<double>(n),
              .momentum = std::vector<Vec3>(n),
              .velocity = std::vector<Vec3>(n),
              .temperature = std::vector<double>(n),
              .contact_stress = std::vector<Tensor>(n),
              .kinetic_stress = std::vector<Tensor>(n),
              .wall_force = std::vector<Vec3>(n)};
  add_masses(grains, width, f);
  add_fluctuations(grains, width, f);
  add_contacts(contacts, width, f);
  return f;
}

}  // namespace repose::fields
