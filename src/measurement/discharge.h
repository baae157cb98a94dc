#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace repose {

/// The mass below the orifice plane, those grains included that have left the domain below it: s, kg.
struct DischargeSample {
  double time = 0.0;
  double mass = 0.0;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("time", self.time);
    v("mass", self.mass);
  }
};

struct Discharge {
  double mass = 0.0;           ///< below the orifice plane at the end, kg
  double retained_mass = 0.0;  ///< still above it, kg
  std::optional<double> time;  ///< from the opening to the last increase, s; empty when nothing came out
  std::optional<double> rate;  ///< kg/s, see DischargeRecord::result
  bool plugged = false;
};

/// What has come through the orifice since it opened. The samples are all its state: a record made from them goes on
/// as the one they were taken from.
class DischargeRecord {
 public:
  explicit DischargeRecord(std::vector<DischargeSample> samples = {}) : samples_(std::move(samples)) {}

  /// To be called first at the opening, then at rising times; the resolution of the results is that of the calls.
  /// Of a stretch without change only the ends are kept.
  void add(double time, double mass);
  const std::vector<DischargeSample>& samples() const { return samples_; }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("samples", self.samples_);
  }

  /// The figures of the discharge once the flow has stopped; `total_mass` (kg) is that of all grains.
  ///
  /// The last increase is the last time that more mass than ever before was below: a grain that hops at the orifice
  /// does not count. The rate is that between 20 and 80 % of what came out after the opening, which leaves out the
  /// start and the trickle at the end; the times of both are interpolated between samples. It is empty when less than 1
  /// % of the total came out, or when it came so suddenly that no two samples lie between 20 and 80 %. Plugged means
  /// that less than `plugged_share` of the total mass is below and no more came with the last sample.
  Discharge result(double total_mass, double plugged_share) const;

 private:
  std::vector<DischargeSample> samples_;
};

}  // namespace repose
