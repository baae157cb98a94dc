#pragma once

#include <vector>

#include "calibration/descend.h"
#include "calibration/lattice.h"

namespace repose {

/// Residuals at the nodes of a lattice.
struct LatticeResiduals {
  BoxLattice lattice;
  Matrix residuals;  ///< one column per node
  Vector squares;    ///< T at each node
};

LatticeResiduals evaluate(const Residuals& residuals, const BoxLattice& lattice);

/// The same over the whole box of 1 to 3 parameters, as close as an estimate looks at it.
LatticeResiduals evaluate_over_box(const Residuals& residuals, Index parameters);

/// All local minima of T in the unit box that a lattice over it lets see, the least first: those below nodes that are
/// lower than their neighbours, and those below cells in which each residual changes its sign. Two that are nearer
/// than 0.001 of the box are one.
std::vector<LeastSquares> local_minima(const Residuals& residuals, const LatticeResiduals& over_box);

}  // namespace repose
