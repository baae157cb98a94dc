#include <cmath>

#include <fmt/core.h>

#include "base/math.h"
#include "import/mesh_place.h"
#include "import/translate.h"

namespace repose {
namespace {

Vec3 axis(Words& words) {
  const Vec3 direction = words.vector("the axis");
  const double length = norm(direction);  // within what unit_vector.h takes
  if (!(length > 1e-150 && length < 1e150)) words.fail("the axis has no direction");
  return direction;
}

MotionDeck conveyor(const Vec3& velocity) {
  MotionDeck motion;
  motion.type = MotionType::conveyor;
  motion.velocity = velocity;
  return motion;
}

/// A rotation about its axis, still without a speed.
MotionDeck rotation(Words& words, const ScriptUnits& units) {
  MotionDeck motion;
  motion.type = MotionType::rotation;
  words.expect("origin");
  motion.axis_origin = units.length * words.vector("the origin of the axis");
  words.expect("axis");
  motion.axis_direction = axis(words);
  return motion;
}

MotionDeck surface_turn(Words& words, const ScriptUnits& units) {
  MotionDeck motion = rotation(words, units);
  words.expect("omega");
  motion.angular_velocity = words.number("the angular velocity") / units.time;
  return motion;
}

double temperature(Words& words) {
  const double kelvin = words.number("the temperature");
  if (!(kelvin > 0.0)) words.fail("a temperature is above 0");
  return kelvin;
}

/// Keys of fix mesh/surface that change nothing here, with the number of their values.
const std::map<std::string, int>& needless_keys() {
  static const std::map<std::string, int> keys = {
      {"verbose", 1},          {"heal", 1},
      {"precision", 1},        {"min_feature_length", 1},
      {"stress", 1},           {"curvature_tolerant", 1},
      {"mass_temperature", 1}, {"element_exclusion_list", 2},
      {"reference_point", 3},
  };
  return keys;
}

void read_mesh_key(const std::string& key, ScriptMesh& mesh, Translation& to, Words& words) {
  const ScriptUnits& units = to.scene.units;
  if (key == "type") {
    mesh.type = words.type();
  } else if (key == "scale") {
    scale_mesh(mesh, words.number("the scale"));
    if (!(mesh.scale > 0.0)) words.fail("a mesh is scaled by a number above 0");
  } else if (key == "move") {
    mesh.shift += units.length * words.vector("the displacement");
  } else if (key == "rotate") {
    words.expect("axis");
    const Vec3 direction = axis(words);
    words.expect("angle");
    turn_mesh(mesh, direction, words.number("the angle"));
  } else if (key == "surface_vel") {
    mesh.surface_motion = conveyor(units.speed() * words.vector("the velocity of the surface"));
  } else if (key == "surface_ang_vel") {
    mesh.surface_motion = surface_turn(words, units);
    note_missing(to.scene, words.command(), "LIGGGHTS gives the surface a velocity and leaves the mesh; here it turns");
  } else if (key == "temperature") {
    mesh.temperature = temperature(words);
  } else if (key == "curvature") {
    mesh.feature_angle = words.number("the angle");
  } else if (key == "wear") {
    if (words.word("the wear model") != "off") note_missing(to.scene, words.command(), "walls do not wear");
  } else if (!words.skip_needless(key, needless_keys())) {
    words.fail(fmt::format("fix mesh/surface: \"{}\" has no counterpart", key));
  }
}

/// fix mesh/surface file FILE ...
void mesh(Translation& to, Words& words) {
  const std::string name = words.command().words[1];
  refuse_second(to.scene, name, words);
  if (!words.take("file")) words.fail("fix mesh/surface: only meshes from a file have a counterpart");
  ScriptMesh mesh{.place = words.place(), .file = words.word("the file of the mesh")};
  if (!mesh.file.ends_with(".stl") && !mesh.file.ends_with(".STL")) {
    words.fail(fmt::format("mesh \"{}\": only STL files are read; convert it", mesh.file));
  }
  mesh.scale = to.scene.units.length;
  while (!words.at_end()) {
    const std::string key = words.word("a key");
    read_mesh_key(key, mesh, to, words);
  }
  to.scene.meshes[name] = mesh;
}

Vec3 unit_along(char axis) { return {axis == 'x' ? 1.0 : 0.0, axis == 'y' ? 1.0 : 0.0, axis == 'z' ? 1.0 : 0.0}; }

void plane(ScriptWall& wall, Words& words, const ScriptUnits& units) {
  wall.point = words.number("the place of the wall") * units.length * wall.direction;
}

/// Of a ycylinder LIGGGHTS counts z first, then x (primitive_wall_definitions.h).
void cylinder(ScriptWall& wall, Words& words, const ScriptUnits& units) {
  wall.radius = words.number("the radius of the wall") * units.length;
  if (!(wall.radius > 0.0)) words.fail("a cylinder has a radius above 0");
  const double c1 = words.number("the place of the wall") * units.length;
  const double c2 = words.number("the place of the wall") * units.length;
  wall.point = wall.shape[0] == 'x' ? Vec3{0.0, c1, c2} : wall.shape[0] == 'y' ? Vec3{c2, 0.0, c1} : Vec3{c1, c2, 0.0};
}

void primitive(ScriptWall& wall, Words& words, const ScriptUnits& units) {
  words.expect("type");
  wall.type = words.type();
  wall.shape = words.word("the shape of the wall");
  const bool is_plane = wall.shape == "xplane" || wall.shape == "yplane" || wall.shape == "zplane";
  if (!is_plane && wall.shape != "xcylinder" && wall.shape != "ycylinder" && wall.shape != "zcylinder") {
    words.fail(fmt::format("a wall that is a \"{}\"; planes and cylinders across x, y and z are known", wall.shape));
  }
  wall.direction = unit_along(wall.shape[0]);
  (is_plane ? plane : cylinder)(wall, words, units);
}

void meshes_of_wall(ScriptWall& wall, Translation& to, Words& words) {
  words.expect("n_meshes");
  const std::int64_t count = words.integer("the number of meshes");
  words.expect("meshes");
  for (std::int64_t k = 0; k < count; ++k) {
    const std::string& name = words.word("a mesh");
    find_item(to.scene.meshes, name, words, "mesh");
    wall.meshes.push_back(name);
  }
}

/// Along a wall; across the axis of a cylinder about that, where LIGGGHTS takes the speed as rad/s (fix_wall_gran.cpp).
MotionDeck shear(const ScriptWall& wall, Words& words, const ScriptUnits& units) {
  if (wall.shape.empty()) words.fail("shear is that of a primitive; a mesh has surface_vel");
  const std::string& along = words.word("the direction of the shear");
  const double speed = words.number("the velocity of the shear");
  if (along != "x" && along != "y" && along != "z") {
    words.fail(fmt::format("shear along \"{}\"; x, y and z are known", along));
  }
  if (wall.shape.ends_with("plane") || wall.shape[0] == along[0]) {
    return conveyor(speed * units.speed() * unit_along(along[0]));
  }
  if (wall.shape[0] == 'y') words.fail("a ycylinder does not spin in LIGGGHTS 3.8: its shear mixes x and z");
  MotionDeck motion;
  motion.type = MotionType::rotation;
  motion.axis_origin = wall.point;
  motion.axis_direction = wall.direction;
  motion.angular_velocity = speed / units.time;
  return motion;
}

void read_wall_key(const std::string& key, ScriptWall& wall, Translation& to, Words& words) {
  if (key == "shear") {
    wall.shear = shear(wall, words, to.scene.units);
  } else if (key == "temperature") {
    wall.temperature = temperature(words);
  } else if (key.starts_with("store_force")) {
    words.word(key);
  } else if (key == "contact_area" && words.take("overlap")) {
    // as heat.conductance has it
  } else if (const std::vector<std::string> rest = words.rest(); true) {
    note_missing(to.scene, words.command(), fmt::format("\"{}\" of a wall", key));
  }
}

/// fix wall/gran model ... primitive ... | mesh ...: the settings of the model follow the geometry.
void wall(Translation& to, Words& words) {
  ScriptWall wall{.place = words.place(), .name = words.command().words[1], .model = read_model(words)};
  wall.from = to.scene.runs.size();
  if (words.take("primitive")) {
    primitive(wall, words, to.scene.units);
  } else if (words.take("mesh")) {
    meshes_of_wall(wall, to, words);
  } else {
    words.fail("a wall is a primitive or a mesh");
  }
  while (!words.at_end()) {
    if (read_setting(words, wall.model)) continue;
    const std::string key = words.word("a key");
    read_wall_key(key, wall, to, words);
  }
  to.scene.walls.push_back(std::move(wall));
}

/// `per_period` over a period in s.
double over_period(double per_period, Words& words, const ScriptUnits& units) {
  words.expect("period");
  const double rate = per_period / (words.number("the period") * units.time);
  if (!std::isfinite(rate)) words.fail("a period is above 0");
  return rate;
}

MotionDeck motion(const std::string& style, Words& words, const ScriptUnits& units) {
  MotionDeck motion;
  if (style == "linear") {
    motion.velocity = units.speed() * words.vector("the velocity");
  } else if (style == "wiggle") {
    motion.type = MotionType::oscillation;
    words.expect("amplitude");
    motion.amplitude = units.length * words.vector("the amplitude");
    motion.frequency = over_period(1.0, words, units);
  } else {
    motion = rotation(words, units);
    motion.angular_velocity = over_period(2.0 * pi, words, units);
  }
  return motion;
}

/// fix move/mesh mesh NAME linear|wiggle|rotate ...
void move_mesh(Translation& to, Words& words) {
  words.expect("mesh");
  MeshMotion moves{.place = words.place(), .name = words.command().words[1], .mesh = words.word("the mesh")};
  find_item(to.scene.meshes, moves.mesh, words, "mesh");
  const std::string style = words.word("the motion");
  if (style != "linear" && style != "wiggle" && style != "rotate") {
    return note_missing(to.scene, words.command(),
                        fmt::format("motion {}; linear, wiggle and rotate have a counterpart", style));
  }
  moves.motion = motion(style, words, to.scene.units);
  moves.from = to.scene.runs.size();
  to.scene.motions.push_back(std::move(moves));
}

}  // namespace

const Translations& wall_fixes() {
  static const Translations fixes = {{"mesh/surface", mesh}, {"wall/gran", wall}, {"move/mesh", move_mesh}};
  return fixes;
}

}  // namespace repose
