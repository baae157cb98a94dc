#include "run/measurements/phase_samples.h"

#include <algorithm>
#include <utility>

#include "integration/time_step.h"

namespace repose {

PhaseSamples::PhaseSamples(std::string phase, double interval, double dt)
    : phase_(std::move(phase)), every_(std::max<std::int64_t>(1, steps_for(interval, dt))) {}

void PhaseSamples::phase_begins(const std::string& name, std::int64_t step) {
  goes_on_ = name == phase_;
  if (goes_on_) first_step_ = step;
}

}  // namespace repose
