#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/misfit.h"

namespace repose {

/// Where one parameter may lie, in its units, within its range.
struct ConfidenceInterval {
  double lower = 0.0;
  double upper = 0.0;
  bool open_below = false;  ///< it ends at the range's lower end only because nothing beyond was looked at
  bool open_above = false;
};

/// A connected part of the confidence region. Its intervals hold for all parameters together: they are the extent of
/// the region, so each alone covers its parameter at more than the confidence.
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
  std::string verdict;  ///< one sentence: how many crossings, and what that means
};

/// For 1 to 3 parameters and at least as many observables; `confidence` between 0 and 1. DeckError otherwise.
/// (C.12) to (C.16).
Estimate estimate(const Misfit& misfit, double confidence);

/// The same from the runs. `runs` has the parameters of each run.
Estimate estimate(const std::vector<ParameterRange>& ranges, std::span<const std::vector<double>> runs,
                  std::span<const ObservableData> observables, double confidence);

}  // namespace repose
