#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "deck/heat_keys.h"
#include "deck/key.h"
#include "deck/servo_keys.h"

/// Walls and motions.
namespace repose {

enum class MotionType { translation, oscillation, rotation, conveyor };
constexpr auto enumerators(MotionType) {
  return std::array<std::string_view, 4>{"translation", "oscillation", "rotation", "conveyor"};
}

/// A prescribed motion of a wall or of a block of particles. It advances during its phases only.
struct MotionDeck {
  MotionType type = MotionType::translation;
  Vec3 velocity;                       ///< translation, conveyor
  Vec3 amplitude;                      ///< oscillation: displacement amplitude x sin(2 pi frequency t)
  double frequency = unset;            ///< oscillation
  Vec3 axis_origin;                    ///< rotation
  Vec3 axis_direction{0.0, 0.0, 1.0};  ///< rotation
  double angular_velocity = unset;     ///< rotation, by the right-hand rule
  std::vector<std::string> phases;     ///< empty: all
};

template <class V>
void describe(V& v, MotionDeck& m) {
  v("type", m.type, Unit::none, any_value, required,
    "translation, oscillation, rotation; conveyor: the surface runs along itself and the wall stays");
  const bool has_velocity = m.type == MotionType::translation || m.type == MotionType::conveyor;
  const bool is_oscillation = m.type == MotionType::oscillation;
  const bool is_rotation = m.type == MotionType::rotation;
  v("velocity", m.velocity, Unit::speed, any_value, required.when(has_velocity, "type = translation, conveyor"),
    "velocity; of a conveyor, each face runs at this speed along the velocity's projection on it");
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

enum class WallType { profile, plane, disc, rectangle, mesh };
constexpr auto enumerators(WallType) {
  return std::array<std::string_view, 5>{"profile", "plane", "disc", "rectangle", "mesh"};
}

struct WallDeck {
  std::string name;
  WallType type = WallType::plane;
  std::string material;
  bool present = true;                        ///< false: a phase adds it
  std::string moves_with;                     ///< the wall whose motions and servo move this one, too; empty: none
  std::vector<std::array<double, 2>> points;  ///< profile: (r, z) along the polyline
  Vec3 axis_origin{0.0, 0.0, 0.0};            ///< profile: where z = 0
  Vec3 axis_direction{0.0, 0.0, 1.0};         ///< profile
  Vec3 point;                                 ///< plane
  Vec3 normal{0.0, 0.0, 1.0};                 ///< plane, disc
  Vec3 centre;                                ///< disc
  double radius = unset;                      ///< disc
  Vec3 corner;                                ///< rectangle
  Vec3 edge_u;                                ///< rectangle: from the corner
  Vec3 edge_v;                                ///< rectangle: from the corner, perpendicular to edge_u
  std::string file;                           ///< mesh: path relative to the deck
  double scale = 1.0;                         ///< mesh: m per unit of length of the file
  Vec3 rotate_axis{0.0, 0.0, 1.0};            ///< mesh: through the origin of the file
  double rotate_angle = 0.0;                  ///< mesh: degrees
  Vec3 translate;                             ///< mesh: after scale and rotation
  double feature_angle = 20.0;                ///< mesh: degrees; facets that turn by less are one smooth surface
  std::vector<MotionDeck> motions;            ///< [[wall.motion]], the first one applied first
  ServoDeck servo = {};                       ///< [wall.servo]
  WallHeatDeck heat = {};                     ///< [wall.heat]
};

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
  v("moves_with", w.moves_with, Unit::none, any_value, optional_else("none"),
    "name of a wall whose [[wall.motion]] and [wall.servo] move this one, too, as one rigid body");
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
  v.section("servo", w.servo, optional,
            "moves the wall so that it presses with a given force, or turns with a given torque");
  v.section("heat", w.heat, optional, "what heat the wall gives the grains; without it the wall keeps all heat in");
}

}  // namespace repose
