#pragma once

#include "deck/schema_types.h"

/// Schema of the measurements. A measurement is made when the deck has its section.
namespace repose {

template <class V>
void describe(V& v, DischargeDeck& d) {
  v("orifice_height", d.orifice_height, Unit::metre, any_value, required,
    "z of the orifice; particles with their centre below it are discharged");
  v("plugged_share", d.plugged_share, Unit::none, from_to(0, 1), optional,
    "less than this share of the mass discharged: plugged, no angle");
}

template <class V>
void describe(V& v, AngleOfReposeDeck& a) {
  v("plate_height", a.plate_height, Unit::metre, any_value, required, "z of the surface that carries the pile");
  v("max_height", a.max_height, Unit::metre, any_value, optional_else("orifice_height, or the domain's top"),
    "z above which particles are no part of the pile");
  v("axis", a.axis, Unit::metre, any_value, optional, "a point on the pile's vertical axis; its z does not matter");
  v("fit_from", a.fit_from, Unit::none, from_to_below(0, 1), optional,
    "lower end of the fit, share of the pile's height");
  v("fit_to", a.fit_to, Unit::none, above_to(0, 1), optional, "upper end of the fit, above fit_from");
  v("azimuths", a.azimuths, Unit::none, from_to(1, 3600), optional, "number of view directions over half a turn");
  v("camera", a.camera, Unit::none, any_value, optional, "projection of the side view");
  const bool is_perspective = a.camera == Camera::perspective;
  v("camera_distance", a.camera_distance, Unit::metre, above(0), required.when(is_perspective, "camera = perspective"),
    "distance of the camera from the axis");
  v("camera_height", a.camera_height, Unit::metre, any_value,
    optional_else("plate_height").when(is_perspective, "camera = perspective"), "z of the camera");
}

template <class V>
void describe(V& v, ScatteringDeck& s) {
  v("plate_height", s.plate_height, Unit::metre, any_value, required, "z of the plate's surface");
  v("plate_min", s.plate_min, Unit::metre, any_value, optional_else("the domain's min"),
    "the plate's edge; its z does not matter");
  v("plate_max", s.plate_max, Unit::metre, any_value, optional_else("the domain's max"),
    "the plate's edge; its z does not matter");
  v("max_height", s.max_height, Unit::metre, any_value, optional_else("orifice_height, or the domain's top"),
    "z above which particles do not count");
  v("axis", s.axis, Unit::metre, any_value, optional,
    "a point on the vertical axis of the areas; its z does not matter");
  v("on_plate_gap", s.on_plate_gap, Unit::none, above_to(0, 1), optional,
    "share of its diameter: a particle whose lowest point is nearer to the plate lies on it");
  v("ring_width", s.ring_width, Unit::metre, above(0), optional_else("two median diameters"),
    "width of the rings in which the particles that lie on the plate are counted to find the base");
  v("base_share", s.base_share, Unit::none, Range{.min = 0, .max = 1, .excludes_min = true, .excludes_max = true},
    optional, "the base ends where their number density falls below this share of that under the pile");
  v("base_radius", s.base_radius, Unit::metre, above(0), optional_else("as measured"),
    "radius from which area 1 is counted");
  v("area_1_width", s.area_1_width, Unit::metre, above(0), required, "width of area 1, the ring next to the base");
  v("area_3_radius", s.area_3_radius, Unit::metre, above(0), required,
    "radius of the outermost circle; area 3 is from there to the plate's edge");
  v("area_1_widened", s.area_1_widened, Unit::metre, above(0), optional, "other widths of area 1 to count with");
  v("area_3_widened", s.area_3_widened, Unit::metre, above(0), optional,
    "other radii of the outermost circle to count with");
}

template <class V>
void describe(V& v, TiltOnsetDeck& t) {
  v("particle", t.particle, Unit::none, at_least(0), optional, "its id: particles are numbered as the deck lists them");
  v("against", t.against, Unit::none, any_value, required,
    "material of what it rests on, whose friction the onset is compared with");
  v("displacement", t.displacement, Unit::metre, above(0), optional_else("0.001 of its radius"),
    "way that counts as motion, beyond what the contacts give way elastically");
  v("extrapolate", t.extrapolate, Unit::none, any_value, optional,
    "repeat the run at half the rate of tilt and extrapolate to a rate of zero");
}

template <class V>
void describe(V& v, SurfaceAngleDeck& s) {
  v("axis_origin", s.axis_origin, Unit::metre, any_value, optional, "a point of the drum's axis");
  v("axis_direction", s.axis_direction, Unit::none, any_value, optional, "direction of the drum's axis, of any length");
  v("radius", s.radius, Unit::metre, above(0), required, "radius of the drum");
  v("from", s.from, Unit::second, at_least(0), optional, "time of the first sample");
  v("interval", s.interval, Unit::second, above(0), optional, "time between samples");
  v("half_width", s.half_width, Unit::none, above_to(0, 1), optional,
    "half width of the fitted part of the surface about the axis, share of the radius");
}

}  // namespace repose
