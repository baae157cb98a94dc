#pragma once

#include <cstdint>
#include <vector>

#include "thermal/plane_source/layered_source.h"
#include "thermal/plane_source/source_function.h"
#include "thermal/plane_source/transient.h"

namespace repose::thermal {

/// The insulation between the spiral and the sample, on each side, as an addition to the sample's rise.
struct Insulation {
  double thickness = 0.0;     ///< m; 0: none
  double conductivity = 0.0;  ///< W/(m K)
  double diffusivity = 0.0;   ///< m2/s
};

/// A measurement to be made up.
struct SyntheticTransient {
  double radius = 0.0;           ///< of the sensor, m
  double power = 0.0;            ///< W
  double conductivity = 0.0;     ///< of the sample, W/(m K)
  double volumetric_heat = 0.0;  ///< of the sample, J/(m3 K)
  double duration = 0.0;         ///< s
  std::int64_t points = 200;     ///< evenly spaced, the last at the end
  Insulation insulation;
  std::vector<Layer> layers = {};  ///< instead of insulation: with the sample they are one problem of conduction
  Heater heater = {};
  double noise = 0.0;           ///< standard deviation over the sample's rise at the end
  double drift = 0.0;           ///< K/s, before and after time 0
  double idle_duration = 40.0;  ///< s recorded before time 0
  std::int64_t idle_points = 40;
  std::uint64_t seed = 1;
};

/// Rise of the sample at the sensor in K after `time` in s (thesis 5.3, corrected).
double sample_rise(const SyntheticTransient& s, const SourceFunction& source, double time);

/// Rise of the spiral over the sample in K after `time` in s: a slab with a constant flux into one face and the other
/// face at zero (T.4; Carslaw and Jaeger, Conduction of Heat in Solids, 2nd edition 1959, section 3.8).
double contact_rise(const SyntheticTransient& s, double time);

/// Whether the spiral lies in layers or stores heat: then its rise is that of a LayeredSource.
bool is_layered(const SyntheticTransient& s);

/// Rise of the spiral in K after each of the ascending `times` in s.
std::vector<double> spiral_rises(const SyntheticTransient& s, const SourceFunction& source,
                                 const std::vector<double>& times);

/// The record. The noise is Gaussian and a function of (seed, point) alone.
Transient synthesise(const SyntheticTransient& s, const SourceFunction& source);

}  // namespace repose::thermal
