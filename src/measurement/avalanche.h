#pragma once

#include "base/math.h"

namespace repose {

/// Looks for the first avalanche on the surface of a bed that becomes steeper: that its slope falls.
class Avalanche {
 public:
  static constexpr double fall = 2.0 * degree;  ///< rad, of the slope: more than single grains that give way

  /// To be called at regular intervals with the slope of the surface and the tilt of the vessel, both in rad from the
  /// horizontal and positive where it tilts to. Does nothing once an avalanche has been seen.
  void add(double slope, double tilt) {
    if (seen_) return;
    if (slope > slope_) {
      slope_ = slope;
      tilt_ = tilt;
    }
    seen_ = slope < slope_ - fall;
  }

  bool seen() const { return seen_; }
  double slope() const { return slope_; }  ///< rad, the greatest, before the avalanche
  double tilt() const { return tilt_; }    ///< rad, at that time

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("slope", self.slope_);
    v("tilt", self.tilt_);
    v("seen", self.seen_);
  }

 private:
  double slope_ = -0.5 * pi;
  double tilt_ = 0.0;
  bool seen_ = false;
};

}  // namespace repose
