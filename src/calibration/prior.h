#pragma once

namespace repose {

enum class PriorKind { uniform, normal, lognormal };

/// What is known of a parameter before any run, such as a coefficient that was measured elsewhere. The range of the
/// parameter cuts it off.
struct Prior {
  PriorKind kind = PriorKind::uniform;
  double mean = 0.0;  ///< of the parameter itself, in its unit, before the range cuts; nothing for `uniform`
  double deviation = 0.0;
};

struct ParameterRange;

/// ln of its density at a value within the range, up to a constant; -infinity where there is none.
double log_prior(const ParameterRange& range, double value);

/// How far a value is from the middle of the prior, in its standard deviations (those of the logarithm for
/// `lognormal`); 0 for `uniform`.
double off_prior(const ParameterRange& range, double value);

/// The value in the range below which this share (0 to 1) of what the range leaves of the prior lies.
double prior_quantile(const ParameterRange& range, double share);

/// The share of the whole prior that lies in the range.
double prior_in_range(const ParameterRange& range);

/// The standard deviation of what the range leaves of the prior.
double prior_deviation(const ParameterRange& range);

}  // namespace repose
