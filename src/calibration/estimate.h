#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/confidence_interval.h"
#include "calibration/misfit.h"
#include "calibration/posterior.h"

namespace repose {

/// A connected part of the confidence region. Its intervals hold for all parameters together: they are the extent of
/// the region, so each alone covers its parameter at more than the confidence. Of a posterior there is one part, and
/// its intervals are those of each parameter alone.
struct RegionPart {
  std::vector<ConfidenceInterval> intervals;  ///< one per parameter
};

/// Parameters at which the surfaces meet the laboratory: a crossing of its contour lines (or, with more observables
/// than parameters, where they come nearest to one another).
struct CalibratedPoint {
  std::vector<double> values;           ///< in the parameters' units
  double misfit = 0.0;                  ///< T; 0 at a crossing
  std::vector<double> standard_errors;  ///< by linearisation; infinite where the observables do not tell
  Matrix covariance;                    ///< by linearisation, in the parameters' units
  std::size_t part = 0;                 ///< of the region, which this point is in
};

/// The point of the least T in the box, whether or not it is acceptable.
struct NearestPoint {
  std::vector<double> values;
  double misfit = 0.0;
  bool acceptable = false;     ///< T <= limit
  std::vector<double> off_by;  ///< surface less laboratory for each observable, in standard deviations
};

/// What the runs and the laboratory say of the parameters.
struct Estimate {
  double confidence = 0.0;
  double limit = 0.0;                   ///< of T: the quantile of chi-squared at the confidence
  std::vector<CalibratedPoint> points;  ///< none, one or several
  NearestPoint nearest;
  std::vector<RegionPart> parts;  ///< empty: no parameters in the box are acceptable
  /// The greatest half-width of an interval over its parameter's range: the measure at which an adaptive search stops.
  /// What the edge of the box cuts off counts as in `standard_errors`; 0.5 where nothing is known. A search
  /// that stops by it chooses among estimates, and covers somewhat less than its confidence (docs/theory.md).
  std::optional<double> half_width;
  std::string verdict;                 ///< one sentence: how many crossings, and what that means
  std::optional<Posterior> posterior;  ///< the region by samples: with priors, or more than three parameters
};

/// For 1 to 3 parameters and at least as many observables, (C.12) to (C.16); by the posterior, (C.30) to (C.34), for 4
/// to 6 or with a prior that is not uniform, whatever the number of observables. `confidence` between 0 and 1.
/// DeckError otherwise.
Estimate estimate(const Misfit& misfit, double confidence);

/// The same from the runs. `runs` has the parameters of each run.
Estimate estimate(const std::vector<ParameterRange>& ranges, std::span<const std::vector<double>> runs,
                  std::span<const ObservableData> observables, double confidence);

}  // namespace repose
