#include "thermal/plane_source/synthetic_transient.h"

#include <cmath>

#include "base/math.h"
#include "base/philox.h"

namespace repose::thermal {
namespace {

/// Standard normal by the transformation of Box and Muller (doi:10.1214/aoms/1177706645).
double normal(std::uint64_t seed, std::uint64_t point) {
  const double u = 1.0 - uniform(seed, point, RandomStream::transient_noise, 0);  // in (0, 1]
  const double v = uniform(seed, point, RandomStream::transient_noise, 1);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * pi * v);
}

}  // namespace

double sample_rise(const SyntheticTransient& s, const SourceFunction& source, double time) {
  const double diffusivity = s.conductivity / s.volumetric_heat;
  const double tau = std::sqrt(time * diffusivity) / s.radius;                      // (5.4, 5.5)
  return s.power / (pi * std::sqrt(pi) * s.radius * s.conductivity) * source(tau);  // (5.3) with pi^(3/2)
}

double contact_rise(const SyntheticTransient& s, double time) {
  const Insulation& slab = s.insulation;
  if (slab.thickness <= 0.0) return 0.0;
  const double flux = s.power / (2.0 * pi * s.radius * s.radius);  // half of the power to each side
  const double fourier = slab.diffusivity * time / (slab.thickness * slab.thickness);
  double sum = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const double odd = 2.0 * n + 1.0;
    const double term = std::exp(-0.25 * pi * pi * odd * odd * fourier) / (odd * odd);
    sum += term;
    if (term < 1e-17) break;
  }
  return flux * slab.thickness / slab.conductivity * (1.0 - 8.0 / (pi * pi) * sum);  // (T.4)
}

bool is_layered(const SyntheticTransient& s) { return !s.layers.empty() || s.heater.thickness > 0.0; }

std::vector<double> spiral_rises(const SyntheticTransient& s, const SourceFunction& source,
                                 const std::vector<double>& times) {
  if (is_layered(s)) {
    const LayeredSource layered({.radius = s.radius,
                                 .rings = source.rings(),
                                 .strip_width = source.least_tau(),
                                 .layers = s.layers,
                                 .conductivity = s.conductivity,
                                 .volumetric_heat = s.volumetric_heat,
                                 .heater = s.heater});
    return layered.rises(times, s.power);
  }
  std::vector<double> rises;
  rises.reserve(times.size());
  for (const double time : times) rises.push_back(sample_rise(s, source, time) + contact_rise(s, time));
  return rises;
}

Transient synthesise(const SyntheticTransient& s, const SourceFunction& source) {
  const double deviation = s.noise * sample_rise(s, source, s.duration);
  std::uint64_t point = 0;
  const auto disturbance = [&](double time) { return s.drift * time + deviation * normal(s.seed, point++); };
  Transient transient;
  for (std::int64_t i = 0; i < s.idle_points; ++i) {
    const double time = s.idle_duration * (static_cast<double>(i) / static_cast<double>(s.idle_points) - 1.0);
    transient.idle_time.push_back(time);
    transient.idle_rise.push_back(disturbance(time));
  }
  for (std::int64_t i = 1; i <= s.points; ++i) {
    const double time = s.duration * static_cast<double>(i) / static_cast<double>(s.points);
    transient.time.push_back(time);
  }
  transient.rise = spiral_rises(s, source, transient.time);
  for (std::size_t i = 0; i < transient.time.size(); ++i) transient.rise[i] += disturbance(transient.time[i]);
  return transient;
}

}  // namespace repose::thermal
