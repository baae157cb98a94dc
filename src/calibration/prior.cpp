#include "calibration/prior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/distributions.h"
#include "calibration/parameter_range.h"

namespace repose {
namespace {

/// A normal distribution of the value or of its logarithm (C.30).
struct NormalPart {
  double middle;
  double deviation;
};

NormalPart normal_part(const Prior& prior) {
  if (prior.kind == PriorKind::normal) return {prior.mean, prior.deviation};
  const double ratio = prior.deviation / prior.mean;
  const double variance = std::log1p(ratio * ratio);
  return {std::log(prior.mean) - 0.5 * variance, std::sqrt(variance)};
}

double share_below(const Prior& prior, double value) {
  const NormalPart part = normal_part(prior);
  if (prior.kind == PriorKind::normal) return normal_below((value - part.middle) / part.deviation);
  return value > 0.0 ? normal_below((std::log(value) - part.middle) / part.deviation) : 0.0;
}

}  // namespace

double off_prior(const ParameterRange& range, double value) {
  const Prior& prior = range.prior;
  if (prior.kind == PriorKind::uniform) return 0.0;
  const NormalPart part = normal_part(prior);
  return ((prior.kind == PriorKind::normal ? value : std::log(value)) - part.middle) / part.deviation;
}

double log_prior(const ParameterRange& range, double value) {
  if (range.prior.kind == PriorKind::lognormal && !(value > 0.0)) return -std::numeric_limits<double>::infinity();
  const double off = off_prior(range, value);
  return -0.5 * off * off - (range.prior.kind == PriorKind::lognormal ? std::log(value) : 0.0);
}

double prior_quantile(const ParameterRange& range, double share) {
  const Prior& prior = range.prior;
  if (prior.kind == PriorKind::uniform) return range.lower + share * (range.upper - range.lower);
  const double below = share_below(prior, range.lower);
  const double whole = below + share * (share_below(prior, range.upper) - below);
  if (!(whole > 0.0)) return range.lower;
  if (!(whole < 1.0)) return range.upper;
  const NormalPart part = normal_part(prior);
  const double normal = part.middle + part.deviation * normal_quantile(whole);
  return std::clamp(prior.kind == PriorKind::normal ? normal : std::exp(normal), range.lower, range.upper);
}

double prior_in_range(const ParameterRange& range) {
  if (range.prior.kind == PriorKind::uniform) return 1.0;
  return share_below(range.prior, range.upper) - share_below(range.prior, range.lower);
}

double prior_deviation(const ParameterRange& range) {
  constexpr int parts = 20000;  // of equal shares
  double sum = 0.0;
  double squares = 0.0;
  const double origin = prior_quantile(range, 0.5);
  for (int i = 0; i < parts; ++i) {
    const double off = prior_quantile(range, (i + 0.5) / parts) - origin;
    sum += off / parts;
    squares += off * off / parts;
  }
  return std::sqrt(squares - sum * sum);
}

}  // namespace repose
