#pragma once

#include "calibration/level_parameters.h"
#include "calibration/replicates.h"

namespace repose {

/// What the levels below say of the points of a level; empty at the lowest.
struct BelowLevel {
  Vector mean;
  Matrix covariance;
  Vector noise;  ///< that of LevelParameters
};

/// Whether the mean of a level is a plane: at the lowest, when its points can bear one. Above it the level below has
/// the slopes, and a plane beside it would leave rho undetermined.
bool has_plane(const Replicates& data, bool is_lowest);

/// Whether the runs of a level tell their scatter themselves; with few second seeds it is taken from the level below.
bool has_own_scatter(const Replicates& data);

constexpr double rho_scatter = 10.0;  ///< of its prior, about 0: keeps it finite where the level below is flat

/// -2 ln of the restricted likelihood of a level's runs given the levels below, less the logarithm of the prior, over
/// (ln lengths, ln added variance, noise); its gradient in `gradient` (C.25). `taken` is what the covariance takes of
/// the level below, rho^2.
double level_deviance(const Replicates& data, const BelowLevel& below, double taken, const Vector& parameters,
                      Vector& gradient);

/// The parameters of the least deviance found from a fixed set of starting points; rho by generalised least squares,
/// taken into the covariance until both agree.
LevelParameters most_likely_level(const Replicates& data, const BelowLevel& below);

}  // namespace repose
