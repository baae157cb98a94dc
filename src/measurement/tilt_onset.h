#pragma once

#include <optional>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "scene/particles/particles.h"

namespace repose {

/// Looks for the tilt at which a particle begins to move: when it is further from where it was at the start of the tilt
/// than its contacts give way elastically.
class TiltOnset {
 public:
  explicit TiltOnset(const TiltOnsetDeck& deck) : deck_(deck) {}

  /// Collective. To be called at regular intervals while the apparatus tilts, the first time at its start; `tilt` in
  /// rad. Does nothing once the onset is known.
  void sample(const Communicator& comm, const Particles& particles, double tilt);

  /// In rad, between two samples by interpolation; empty before.
  std::optional<double> onset() const { return onset_; }
  /// Of the particle, once it has been seen: its material, and whether its rotation is blocked.
  std::size_t material() const { return material_; }
  bool cannot_turn() const { return cannot_turn_; }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("start", self.start_);
    v("material", self.material_);
    v("cannot_turn", self.cannot_turn_);
    v("bound", self.bound_);
    v("last_tilt", self.last_tilt_);
    v("last_way", self.last_way_);
    v("onset", self.onset_);
  }

 private:
  TiltOnsetDeck deck_;
  std::optional<Vec3> start_;
  std::size_t material_ = 0;
  bool cannot_turn_ = false;
  double bound_ = 0.0;      ///< m
  double last_tilt_ = 0.0;  ///< of the last sample
  double last_way_ = 0.0;   ///< m
  std::optional<double> onset_;
};

/// The onset in rad at a rate of tilt of zero, from those at a rate and at `slower` times this rate: behind the onset
/// the way grows as the third power of time, so that a given way is seen later by an angle that goes with the rate to
/// the power 2/3.
double extrapolated_onset(double at_rate, double at_slower_rate, double slower);

}  // namespace repose
