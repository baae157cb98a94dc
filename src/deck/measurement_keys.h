#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// The measurements: one is made when the deck has its section.
namespace repose {

struct DischargeDeck {
  bool enabled = false;           ///< true when the deck has the section
  double orifice_height = unset;  ///< z of the orifice plane; below it counts as discharged
  double plugged_share = 0.5;     ///< less than this share of the mass discharged: plugged
};

template <class V>
void describe(V& v, DischargeDeck& d) {
  v("orifice_height", d.orifice_height, Unit::metre, any_value, required,
    "z of the orifice; particles with their centre below it are discharged");
  v("plugged_share", d.plugged_share, Unit::none, from_to(0, 1), optional,
    "less than this share of the mass discharged: plugged, no angle");
}

enum class Camera { orthographic, perspective };
constexpr auto enumerators(Camera) { return std::array<std::string_view, 2>{"orthographic", "perspective"}; }

struct AngleOfReposeDeck {
  bool enabled = false;         ///< true when the deck has the section
  double plate_height = unset;  ///< z of the plate's surface
  double max_height = unset;    ///< z above which grains are no part of the pile; default orifice_height
  Vec3 axis;                    ///< a point on the pile's vertical axis (x and y count)
  double fit_from = 0.2;        ///< lower end of the fitted flank, share of the pile's height
  double fit_to = 0.8;
  std::int64_t azimuths = 36;  ///< number of view directions over half a turn
  Camera camera = Camera::orthographic;
  double camera_distance = unset;  ///< perspective: from the axis
  double camera_height = unset;    ///< perspective: z of the camera
};

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

struct ScatteringDeck {
  bool enabled = false;                                ///< true when the deck has the section
  double plate_height = unset;                         ///< z of the plate's surface
  Vec3 plate_min{unset, unset, unset};                 ///< x and y of the plate's edge; default: the domain's
  Vec3 plate_max{unset, unset, unset};                 ///< as plate_min
  double max_height = unset;                           ///< z above which grains do not count; default orifice_height
  Vec3 axis;                                           ///< a point on the vertical axis of the areas (x and y count)
  double on_plate_gap = 0.25;                          ///< of its diameter: nearer to the plate, a grain lies on it
  double ring_width = unset;                           ///< to find the base; default two median diameters
  double base_share = 0.5;                             ///< of the density under the pile, below which the base ends
  double base_radius = unset;                          ///< from which area 1 is counted; default: as measured
  double area_1_width = unset, area_3_radius = unset;  ///< of the ring next to the base; of the outermost circle
  std::vector<double> area_1_widened, area_3_widened;  ///< others to count with
};

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

struct TiltOnsetDeck {
  bool enabled = false;         ///< true when the deck has the section
  std::int64_t particle = 0;    ///< id
  std::string against;          ///< material of what it rests on
  double displacement = unset;  ///< that is motion; default 0.001 of its radius
  bool extrapolate = true;      ///< repeats the run at half the rate of tilt and extrapolates to none
};

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

struct SurfaceAngleDeck {
  bool enabled = false;  ///< true when the deck has the section
  Vec3 axis_origin;
  Vec3 axis_direction{0.0, 1.0, 0.0};
  double radius = unset;    ///< of the drum
  double from = 0.0;        ///< time of the first sample
  double interval = 0.01;   ///< time between samples
  double half_width = 0.5;  ///< of the fitted part about the drum's axis, share of its radius
};

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

struct BulkDensityDeck {
  bool enabled = false;  ///< true when the deck has the section
  Vec3 min{unset, unset, unset};
  Vec3 max{unset, unset, unset};
  double surface_gap = unset;  ///< default: three mean diameters
};

template <class V>
void describe(V& v, BulkDensityDeck& b) {
  v("min", b.min, Unit::metre, any_value, required, "lower corner of the box, clear of walls and floor");
  v("max", b.max, Unit::metre, any_value, required,
    "upper corner, clear of walls; where the bed ends lower, the box ends below its surface");
  v("surface_gap", b.surface_gap, Unit::metre, at_least(0), optional_else("three mean diameters"),
    "least distance of the box from the bed's surface");
}

struct RetainedSlopeDeck {
  bool enabled = false;           ///< true when the deck has the section
  double orifice_height = unset;  ///< z of the floor
  Vec3 axis;                      ///< a point on the vessel's vertical axis (x and y count)
  double radius = unset;          ///< of the vessel
  double fit_from = 0.2;          ///< lower end of the fitted part, share of the bed's height at the wall
  double fit_to = 0.8;
};

template <class V>
void describe(V& v, RetainedSlopeDeck& r) {
  v("orifice_height", r.orifice_height, Unit::metre, any_value, required, "z of the vessel's flat floor");
  v("axis", r.axis, Unit::metre, any_value, optional, "a point on the vessel's vertical axis; its z does not matter");
  v("radius", r.radius, Unit::metre, above(0), required, "inner radius of the vessel");
  v("fit_from", r.fit_from, Unit::none, from_to_below(0, 1), optional,
    "lower end of the fit, share of the bed's height at the wall");
  v("fit_to", r.fit_to, Unit::none, above_to(0, 1), optional, "upper end of the fit, above fit_from");
}

enum class ShearType { translation, rotation };
constexpr auto enumerators(ShearType) { return std::array<std::string_view, 2>{"translation", "rotation"}; }

struct ShearDeck {
  bool enabled = false;  ///< true when the deck has the section
  ShearType type = ShearType::translation;
  std::vector<std::string> walls;      ///< one half of the cell
  Vec3 direction;                      ///< translation: in which the halves move past each other
  double area = unset;                 ///< translation: of the plane between them
  Vec3 axis_origin;                    ///< rotation
  Vec3 axis_direction{0.0, 0.0, 1.0};  ///< rotation
  double inner_radius = 0.0;           ///< rotation: of the ring
  double outer_radius = unset;         ///< rotation
  double plane_height = unset;         ///< z of the plane between the halves
  std::string phase;                   ///< in which they move
  double from = 0.0;                   ///< time since the phase began from which on the stresses are steady
  double interval = 1e-3;              ///< between samples
};

template <class V>
void describe(V& v, ShearDeck& s) {
  v("type", s.type, Unit::none, any_value, optional, "translation: a box; rotation: a ring");
  const bool turns = s.type == ShearType::rotation;
  const Presence needed_along = required.when(!turns, "type = translation");
  const Presence optional_about = optional.when(turns, "type = rotation");
  v("walls", s.walls, Unit::none, any_value, required, "names of the walls of one half, whose loads give the stresses");
  v("direction", s.direction, Unit::none, any_value, needed_along,
    "horizontal, in which the halves move past each other, of any length");
  v("area", s.area, Unit::area, above(0), needed_along, "of the plane between the halves");
  v("axis_origin", s.axis_origin, Unit::metre, any_value, optional_about, "point of the axis of the ring");
  v("axis_direction", s.axis_direction, Unit::none, any_value, optional_about, "direction of the axis, of any length");
  v("inner_radius", s.inner_radius, Unit::metre, at_least(0), optional_about, "inner radius of the ring");
  v("outer_radius", s.outer_radius, Unit::metre, above(0), required.when(turns, "type = rotation"),
    "outer radius of the ring");
  v("plane_height", s.plane_height, Unit::metre, any_value, required,
    "z of the plane between the halves; the weight of the grains between it and the walls counts");
  v("phase", s.phase, Unit::none, any_value, required, "phase in which the halves move past each other");
  v("from", s.from, Unit::second, at_least(0), optional,
    "time since the phase began from which on the stresses count as steady");
  v("interval", s.interval, Unit::second, above(0), optional, "time between samples");
}

struct CompressionDeck {
  bool enabled = false;  ///< true when the deck has the section
  std::string lid;       ///< wall with a servo
  double area = unset;
  double height = unset;  ///< of the bed's room when the lid is where it is in the deck
  std::string load_phase, unload_phase;
  double interval = 1e-3;  ///< between samples
};

template <class V>
void describe(V& v, CompressionDeck& c) {
  v("lid", c.lid, Unit::none, any_value, required, "name of the wall with a [wall.servo] that presses on the bed");
  v("area", c.area, Unit::area, above(0), required, "of the bed's cross-section");
  v("height", c.height, Unit::metre, above(0), required,
    "from the floor to the lid where it is in the deck, along the lid's direction");
  v("load_phase", c.load_phase, Unit::none, any_value, required, "phase at whose end the bed is loaded most");
  v("unload_phase", c.unload_phase, Unit::none, any_value, required, "phase after it, in which the lid goes back");
  v("interval", c.interval, Unit::second, above(0), optional, "time between samples");
}

struct FlowEnergyDeck {
  bool enabled = false;            ///< true when the deck has the section
  std::vector<std::string> walls;  ///< of the blade
  std::string phase;               ///< in which its work is summed
  double interval = 1e-4;          ///< between samples
};

template <class V>
void describe(V& v, FlowEnergyDeck& f) {
  v("walls", f.walls, Unit::none, any_value, required, "names of the walls of the blade");
  v("phase", f.phase, Unit::none, any_value, required, "phase in which the blade's work on the grains is summed");
  v("interval", f.interval, Unit::second, above(0), optional, "time between samples");
}

/// The sections below [measurement.
struct MeasurementDecks {
  DischargeDeck discharge;
  AngleOfReposeDeck angle_of_repose;
  ScatteringDeck scattering;
  TiltOnsetDeck tilt_onset;
  SurfaceAngleDeck surface_angle;
  BulkDensityDeck bulk_density;
  RetainedSlopeDeck retained_slope;
  ShearDeck shear;
  CompressionDeck compression;
  FlowEnergyDeck flow_energy;
};

template <class V>
void describe_measurements(V& v, MeasurementDecks& d) {
  v.section("discharge", d.discharge, optional, "measure the mass that leaves an orifice");
  v.section("angle_of_repose", d.angle_of_repose, optional, "measure the slope of the pile from its side view");
  v.section("scattering", d.scattering, optional, "count the grains that lie around the pile, seen from above");
  v.section("tilt_onset", d.tilt_onset, optional, "measure the tilt at which a particle begins to move");
  v.section("surface_angle", d.surface_angle, optional, "measure the slope of the bed in a rotating drum");
  v.section("bulk_density", d.bulk_density, optional, "measure the density of the settled bed before it is let out");
  v.section("retained_slope", d.retained_slope, optional, "measure the slope of the bed that stays in the vessel");
  v.section("shear", d.shear, optional, "measure the stresses in the plane of a shear cell, and their ratio");
  v.section("compression", d.compression, optional, "measure porosity and modulus of a bed under a lid");
  v.section("flow_energy", d.flow_energy, optional, "measure the work of a blade on the grains");
}

}  // namespace repose
