#include "measurement/discharge.h"

#include <algorithm>
#include <cstddef>

namespace repose {
namespace {

constexpr double rate_from = 0.2;  // of the mass that came out
constexpr double rate_to = 0.8;
constexpr double least_share = 0.01;  // of the total mass, for a rate

/// When the mass first reached `mass`, which the last sample of a rising record has.
double time_of(const std::vector<DischargeSample>& rising, double mass) {
  const auto after = std::find_if(rising.begin() + 1, rising.end(), [&](const auto& s) { return s.mass >= mass; });
  const DischargeSample& a = *(after - 1);
  const DischargeSample& b = *after;
  return a.time + (mass - a.mass) / (b.mass - a.mass) * (b.time - a.time);
}

/// The samples with the greatest mass so far in place of their own.
std::vector<DischargeSample> rising_samples(std::vector<DischargeSample> samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) samples[i].mass = std::max(samples[i].mass, samples[i - 1].mass);
  return samples;
}

std::optional<double> rate_of(const std::vector<DischargeSample>& rising) {
  const double before = rising.front().mass;
  const double out = rising.back().mass - before;
  const double low = before + rate_from * out;
  const double high = before + rate_to * out;
  const auto between = std::count_if(rising.begin(), rising.end(),
                                     [&](const DischargeSample& s) { return s.mass >= low && s.mass <= high; });
  if (between < 2) return std::nullopt;
  return (high - low) / (time_of(rising, high) - time_of(rising, low));
}

}  // namespace

void DischargeRecord::add(double time, double mass) {
  const std::size_t n = samples_.size();
  if (n >= 2 && samples_[n - 1].mass == mass && samples_[n - 2].mass == mass) {
    samples_[n - 1].time = time;
  } else {
    samples_.push_back({time, mass});
  }
}

Discharge DischargeRecord::result(double total_mass, double plugged_share) const {
  if (samples_.empty()) return {.mass = 0.0, .retained_mass = total_mass, .time = {}, .rate = {}, .plugged = false};
  const std::vector<DischargeSample> rising = rising_samples(samples_);
  std::size_t last = 0;
  for (std::size_t i = 1; i < rising.size(); ++i) {
    if (rising[i].mass > rising[i - 1].mass) last = i;
  }
  const double mass = samples_.back().mass;
  const bool flowing = last > 0 && last + 1 == rising.size();
  Discharge result{.mass = mass,
                   .retained_mass = total_mass - mass,
                   .time = {},
                   .rate = {},
                   .plugged = mass < plugged_share * total_mass && !flowing};
  if (last > 0) {
    result.time = rising[last].time - rising.front().time;
    if (rising.back().mass - rising.front().mass >= least_share * total_mass) result.rate = rate_of(rising);
  }
  return result;
}

}  // namespace repose
