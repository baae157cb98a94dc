#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/linear_algebra.h"

namespace repose {

/// A measured curve: at each x, which rises, the mean and the deviation (above 0) of one measurement. Deviations at two
/// places have the correlation exp(-distance / correlation_length).
struct MeasuredCurve {
  Vector x, y, deviation;
  double correlation_length = 0.0;  ///< in the unit of x; 0: deviations are independent
};

/// The curve of a run at the x of the measured one.
struct CurveRun {
  std::size_t point = 0;  ///< runs of a level with the same number differ by their seeds alone
  std::size_t level = 0;  ///< of the model, the last one counts
  Vector y;
};

/// What the curves of runs differ by most: the principal components of the curves over the laboratory's deviations, and
/// in the space of these the combinations in which the laboratory's errors are independent with variance 1, most
/// telling first. So each is an observable of its own, and neighbouring points do not count as independent (Higdon et
/// al. 2008, doi:10.1198/016214507000000888; docs/theory.md, "Curves").
class CurveComponents {
 public:
  /// As few components as leave out no more than 1 % of the variance between the points beside what the seeds explain,
  /// but `least` to `most` where the curves have so many. DeckError when all curves of the last level are the same or
  /// there is none, with `name` in it.
  CurveComponents(const std::string& name, MeasuredCurve curve, std::span<const CurveRun> runs, Index least,
                  Index most);

  Index count() const { return weights_.cols(); }
  /// What a curve has of each component, in standard deviations of one measurement (K.4).
  Vector scores(const Vector& y) const { return weights_.transpose() * (y.cwiseQuotient(curve_.deviation) - centre_); }
  Vector laboratory() const { return scores(curve_.y); }
  /// The curve with these scores and nothing else (K.5).
  Vector curve(const Vector& scores) const { return (centre_ + shapes_ * scores).cwiseProduct(curve_.deviation); }
  /// Standard deviation of each score when the curve is off by this deviation at each x, with the laboratory's
  /// correlation (K.6).
  Vector deviation_of(const Vector& deviation) const;
  /// The share of the variance between the points that no component has.
  double left_out() const { return left_out_; }
  /// Root mean square of what of the laboratory's curve no component has, over its deviation.
  double laboratory_rest() const;

 private:
  MeasuredCurve curve_;
  Matrix correlation_;  ///< of the laboratory's deviations (K.1)
  // Over the deviations:
  Vector centre_;
  Matrix weights_;  ///< columns: what each score takes of a curve
  Matrix shapes_;   ///< columns: the curve that a score of 1 is
  double left_out_ = 0.0;
};

}  // namespace repose
