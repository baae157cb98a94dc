#pragma once

#include "thermal/plane_source/synthetic_transient.h"
#include "thermal/plane_source/tps_criteria.h"

/// The two samples of thesis section 5.2.1 as they are measured.
namespace repose::thermal {

struct Sample {
  SyntheticTransient measurement;
  TpsLimits limits;
};

/// Stainless steel, Table 5.1: 13.55 W/(m K), 470 J/(kg K); 7900 kg/m3, that of type 304. 5 s are 0.43 of the
/// characteristic time of the 6.5 mm sensor.
inline Sample steel() {
  Sample s;
  s.measurement = {.radius = 6.5e-3,
                   .power = 2.5,
                   .conductivity = 13.55,
                   .volumetric_heat = 7900.0 * 470.0,
                   .duration = 5.0,
                   .insulation = {},
                   .noise = 1e-4};
  s.limits.available_depth = 20e-3;
  return s;
}

/// A bed of CarboHSP, Table 5.2: 0.21 W/(m K), 734.46 J/(kg K), 2115 kg/m3. 320 s are 0.53 of the characteristic time
/// of the 9 mm sensor.
inline Sample grains() {
  Sample s;
  s.measurement = {.radius = 9e-3,
                   .power = 0.08,
                   .conductivity = 0.21,
                   .volumetric_heat = 2115.0 * 734.46,
                   .duration = 320.0,
                   .insulation = {},
                   .noise = 1e-4};
  s.limits.available_depth = 20e-3;
  return s;
}

/// 60 um of kapton (thesis section 5.2.1): 0.12 W/(m K), 1420 kg/m3 and 1090 J/(kg K) (DuPont Kapton HN data sheet).
inline Insulation kapton() {
  return {.thickness = 60e-6, .conductivity = 0.12, .diffusivity = 0.12 / (1420.0 * 1090.0)};
}

/// The sample with kapton between spiral and sample; on steel with less power, as the contact adds more than the
/// sample.
inline Sample with_contact(Sample s) {
  s.measurement.insulation = kapton();
  if (s.measurement.conductivity > 1.0) s.measurement.power = 1.8;
  return s;
}

inline TpsSetup setup_of(const SyntheticTransient& s) { return {.radius = s.radius, .power = s.power}; }

}  // namespace repose::thermal
