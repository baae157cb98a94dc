#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "calibration/parameter_range.h"

namespace repose {

/// Morris's design (1991, doi:10.1080/00401706.1991.10484804): `trajectories` walks through a grid of `levels` values
/// of each parameter, each from a point of its own through one step of each parameter in an order of its own. In the
/// parameters' units; parameters + 1 points per trajectory, one after the other. Steps are levels / (2 (levels - 1)) of
/// the range, up or down (C.20). A function of its arguments alone. DeckError when the levels are not an even number.
std::vector<std::vector<double>> morris_design(const std::vector<ParameterRange>& ranges, std::size_t trajectories,
                                               std::size_t levels, std::uint64_t seed);

/// What a parameter does to an observable, in the observable's units over the parameter's whole range (C.21).
struct MorrisEffect {
  double mean = 0.0;                 ///< mu of the elementary effects: with its sign
  double mean_absolute = 0.0;        ///< mu* (Campolongo 2007, doi:10.1016/j.envsoft.2006.10.004): its importance
  double deviation = 0.0;            ///< sigma: how much the effect depends on the other parameters, or is not linear
  double mean_error = 0.0;           ///< standard error of mu
  double mean_absolute_error = 0.0;  ///< of mu*
  double effects = 0.0;              ///< number of elementary effects: both ends had a value
};

/// One per parameter. `points` are those of `morris_design`; `values` has one for each, NaN: none. The scatter of seeds
/// is in sigma and mu* too. NaN where there are too few effects (one for mu, two for the rest).
std::vector<MorrisEffect> morris_effects(const std::vector<ParameterRange>& ranges,
                                         std::span<const std::vector<double>> points, std::span<const double> values);

}  // namespace repose
