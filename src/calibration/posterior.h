#pragma once

#include <vector>

#include "calibration/confidence_interval.h"
#include "calibration/misfit.h"
#include "calibration/sample_density.h"

namespace repose {

/// What is known of one parameter after the runs, whatever the others are. In its unit.
struct Marginal {
  double mean = 0.0;
  double deviation = 0.0;
  double median = 0.0;
  ConfidenceInterval interval;   ///< what is left out lies to equal shares on either side
  double prior_deviation = 0.0;  ///< of what the range leaves of the prior
  double off_prior = 0.0;        ///< of the mean from the middle of the prior, in its deviations; 0: uniform
  bool determined = true;        ///< false: much as the prior, so that the observables do not tell
  bool separate = false;         ///< the interval has stretches of a twentieth of the range or more with nothing in it
};

/// What runs, laboratory and priors say of the parameters, by samples of their joint density.
struct Posterior {
  Matrix samples;      ///< a row each, in the parameters' units
  Vector log_density;  ///< of each, up to a constant
  double confidence = 0.0;
  double limit = 0.0;  ///< of ln density: the region of the highest density has what is above
  std::vector<Marginal> marginals;
  Matrix covariance;        ///< in the parameters' units
  Matrix correlations;      ///< of each pair of parameters
  Index stages = 0;         ///< of the sampling
  double acceptance = 0.0;  ///< of its moves

  /// Whether a point is in the region of the highest density.
  bool covers(double log_density_there) const { return log_density_there >= limit; }
};

/// ln of the density of the parameters at a point of the unit box, up to a constant: prior times likelihood (C.32).
double log_posterior(const Misfit& misfit, const Vector& point);

/// Samples the posterior over the ranges (C.33), (C.34). `confidence` between 0 and 1.
Posterior posterior_of(const Misfit& misfit, double confidence, const SamplePlan& plan = {});

}  // namespace repose
