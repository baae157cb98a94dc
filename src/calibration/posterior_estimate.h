#pragma once

#include <span>

#include "calibration/estimate.h"

namespace repose {

constexpr std::size_t most_parameters = 6;

/// Whether the region is found by sampling: more than three parameters, or a prior that is not uniform.
bool takes_posterior(std::span<const ParameterRange> ranges);

/// The estimate of 1 to 6 parameters by their posterior. The point is that of the least sum of T and priors
/// (C.35). DeckError for more parameters or a confidence that is not between 0 and 1.
Estimate posterior_estimate(const Misfit& misfit, double confidence);

}  // namespace repose
