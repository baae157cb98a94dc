#pragma once

#include "deck/schema_types.h"

/// Schema of the scene: materials, walls and particles.
namespace repose {

template <class V>
void describe(V& v, MaterialDeck& m) {
  v("name", m.name, Unit::none, any_value, required, "name, used once: a letter, then letters, digits, _ or -");
  v("youngs_modulus", m.youngs_modulus, Unit::pascal, above(0), required, "Young's modulus");
  v("poisson_ratio", m.poisson_ratio, Unit::none, from_to_below(0, 0.5), required, "Poisson's ratio");
  v("density", m.density, Unit::density, above(0), required, "density of the solid");
}

template <class V>
void describe(V& v, PairDeck& p) {
  v("materials", p.materials, Unit::none, any_value, required, "the two materials, which may be the same");
  v("restitution", p.restitution, Unit::none, from_to(0, 1), required, "coefficient of restitution");
  v("sliding_friction", p.sliding_friction, Unit::none, at_least(0), required, "Coulomb's coefficient of friction");
  v("rolling_friction", p.rolling_friction, Unit::none, at_least(0), required,
    "coefficient of rolling friction (EPSD2)");
  v("hooke_stiffness", p.hooke_stiffness, Unit::stiffness, above(0), optional_else("none; normal_law = hooke needs it"),
    "normal stiffness of normal_law = hooke");
  v("hooke_tangential_ratio", p.hooke_tangential_ratio, Unit::none, above_to(0, 10), optional,
    "tangential over normal stiffness of normal_law = hooke");
}

template <class V>
void describe(V& v, ContactDeck& c) {
  v("normal_law", c.normal_law, Unit::none, any_value, optional, "hertz: from the elastic constants; hooke: linear");
  v("attraction", c.attraction, Unit::none, any_value, optional,
    "whether the dashpot may pull as the surfaces part; false: damped anew to the same restitution");
  v("tangential_spring", c.tangential_spring, Unit::none, any_value, optional,
    "how the spring follows the normal: by its projection, or rotated with its length kept");
  v("rolling_history", c.rolling_history, Unit::none, any_value, optional,
    "how the rolling moment follows the normal: not, or rotated with its length kept");
}

template <class V>
void describe(V& v, MotionDeck& m) {
  v("type", m.type, Unit::none, any_value, required, "translation, oscillation or rotation");
  const bool is_translation = m.type == MotionType::translation;
  const bool is_oscillation = m.type == MotionType::oscillation;
  const bool is_rotation = m.type == MotionType::rotation;
  v("velocity", m.velocity, Unit::speed, any_value, required.when(is_translation, "type = translation"), "velocity");
  v("amplitude", m.amplitude, Unit::metre, any_value, required.when(is_oscillation, "type = oscillation"),
    "displacement = amplitude x sin(2 pi frequency t)");
  v("frequency", m.frequency, Unit::hertz, above(0), required.when(is_oscillation, "type = oscillation"),
    "oscillations per second");
  v("axis_origin", m.axis_origin, Unit::metre, any_value, optional.when(is_rotation, "type = rotation"),
    "point of the axis");
  v("axis_direction", m.axis_direction, Unit::none, any_value, optional.when(is_rotation, "type = rotation"),
    "direction of the axis, of any length");
  v("angular_velocity", m.angular_velocity, Unit::angular_speed, any_value,
    required.when(is_rotation, "type = rotation"), "about the axis by the right-hand rule");
  v("phases", m.phases, Unit::none, any_value, optional, "phases in which it moves; none named: all");
}

template <class V>
void describe_mesh(V& v, WallDeck& w) {
  const bool is_mesh = w.type == WallType::mesh;
  v("file", w.file, Unit::none, any_value, required.when(is_mesh, "type = mesh"),
    "path from the deck's folder to an STL file, binary or ASCII");
  v("scale", w.scale, Unit::none, above(0), optional.when(is_mesh, "type = mesh"),
    "metres per unit of the file, such as 0.001 for mm");
  v("rotate_axis", w.rotate_axis, Unit::none, any_value, optional.when(is_mesh, "type = mesh"),
    "axis through the file's origin, of any length");
  v("rotate_angle", w.rotate_angle, Unit::none, from_to(-360, 360), optional.when(is_mesh, "type = mesh"),
    "angle around it by the right-hand rule, in degrees");
  v("translate", w.translate, Unit::metre, any_value, optional.when(is_mesh, "type = mesh"),
    "displacement, after scale and rotation");
  v("feature_angle", w.feature_angle, Unit::none, from_to(0.1, 90), optional.when(is_mesh, "type = mesh"),
    "facets that turn by less, in degrees, are one smooth surface, touched once");
}

template <class V>
void describe(V& v, WallDeck& w) {
  v("name", w.name, Unit::none, any_value, required, "name, used once");
  v("type", w.type, Unit::none, any_value, required,
    "profile: a polyline turned around an axis; plane: without bounds; mesh: triangles from an STL file");
  const bool is_profile = w.type == WallType::profile;
  const bool is_plane = w.type == WallType::plane;
  const bool is_disc = w.type == WallType::disc;
  const bool is_rectangle = w.type == WallType::rectangle;
  v("material", w.material, Unit::none, any_value, required, "name of its material");
  v("present", w.present, Unit::none, any_value, optional, "false: a phase adds it");
  v("points", w.points, Unit::metre, any_value, required.when(is_profile, "type = profile"),
    "polyline: r >= 0 from the axis, z along it");
  v("axis_origin", w.axis_origin, Unit::metre, any_value, optional.when(is_profile, "type = profile"),
    "point of the axis where z = 0");
  v("axis_direction", w.axis_direction, Unit::none, any_value, optional.when(is_profile, "type = profile"),
    "direction of z, of any length");
  v("point", w.point, Unit::metre, any_value, required.when(is_plane, "type = plane"), "a point of the plane");
  v("normal", w.normal, Unit::none, any_value, optional.when(is_plane || is_disc, "type = plane, disc"),
    "normal, of any length");
  v("centre", w.centre, Unit::metre, any_value, required.when(is_disc, "type = disc"), "centre");
  v("radius", w.radius, Unit::metre, above(0), required.when(is_disc, "type = disc"), "radius");
  v("corner", w.corner, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"), "a corner");
  v("edge_u", w.edge_u, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"),
    "edge from the corner");
  v("edge_v", w.edge_v, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"),
    "other edge from the corner, perpendicular to edge_u");
  describe_mesh(v, w);
  v.sections("motion", w.motions, optional, "moves the wall; several are applied one after the other");
}

}  // namespace repose
