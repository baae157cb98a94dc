#pragma once

#include <cstdint>
#include <string>

namespace repose {

/// When to look at a state: at a constant interval while a phase goes on.
class PhaseSamples {
 public:
  PhaseSamples(std::string phase, double interval, double dt);

  void phase_begins(const std::string& name, std::int64_t step);
  bool goes_on() const { return goes_on_; }
  bool is_due(std::int64_t step) const { return goes_on_ && step > first_step_ && (step - first_step_) % every_ == 0; }
  std::int64_t first_step() const { return first_step_; }  ///< of the phase

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("first_step", self.first_step_);
    v("goes_on", self.goes_on_);
  }

 private:
  std::string phase_;
  std::int64_t every_;
  std::int64_t first_step_ = 0;
  bool goes_on_ = false;
};

}  // namespace repose
