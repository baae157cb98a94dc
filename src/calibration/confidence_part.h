#pragma once

#include <vector>

#include "calibration/descend.h"
#include "calibration/lattice.h"
#include "calibration/local_minima.h"

namespace repose {

/// A connected part of the region T <= limit in the unit box.
struct ConfidencePart {
  Vector seed;                               ///< a point of it
  Vector lower, upper;                       ///< its extent in each parameter (C.15)
  std::vector<bool> open_below, open_above;  ///< it meets the edge of the box there, and goes on beyond
  BoxLattice lattice;                        ///< over its extent, and
  std::vector<char> inside;                  ///< which of its nodes belong to the part

  bool contains(const Vector& point) const;
};

/// The part about `seed`, where T <= limit. Lattices over ever smaller windows find what is connected; the ends are
/// then found along the least T of all other parameters, within 1e-3 of the extent.
ConfidencePart confidence_part(const Residuals& residuals, const LatticeResiduals& over_box, const Vector& seed,
                               double limit);

/// Whether `point`, where T <= limit, is in the part: a band thinner than a cell breaks into pieces on a lattice. It is
/// when a walk along one of the parameters, at the least T of the others, leads there from the seed within the region.
bool leads_to(const Residuals& residuals, const ConfidencePart& part, const Vector& point, double limit);

/// Whether two parts reach as far, within a cell of their lattices.
bool have_same_extent(const ConfidencePart& a, const ConfidencePart& b);

}  // namespace repose
