#include "import/wall_motions.h"

#include <algorithm>

#include <fmt/core.h>

#include "scene/walls/motion.h"

namespace repose {
namespace {

bool turns(const MotionDeck& motion) { return motion.type == MotionType::rotation; }

bool are_parallel(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) <= 1e-9 * norm(a) * norm(b); }

/// Whether the axis of a turn is that of another, or the way of a translation or an oscillation is along it.
bool is_along(const MotionDeck& motion, const MotionDeck& turn) {
  if (!turns(motion)) return are_parallel(motion.velocity + motion.amplitude, turn.axis_direction);
  return are_parallel(motion.axis_direction, turn.axis_direction) &&
         are_parallel(motion.axis_origin - turn.axis_origin, turn.axis_direction);
}

bool commute(const MotionDeck& a, const MotionDeck& b) {
  return turns(a) ? is_along(b, a) : !turns(b) || is_along(a, b);
}

/// In LIGGGHTS the first motion carries the reference point of the second along, but not its direction.
bool is_carried(const MeshMotion& first, const MeshMotion& second) {
  if (first.from != second.from) return false;
  if (!turns(first.motion)) return true;
  return turns(second.motion) && are_parallel(first.motion.axis_direction, second.motion.axis_direction);
}

bool overlap(const ImportedScene& scene, const MeshMotion& a, const MeshMotion& b) {
  return a.mesh == b.mesh && is_ever_there(scene, std::max(a.from, b.from), std::min(a.until, b.until));
}

double speed_of(const std::vector<MeshMotion>& motions, const Extent& box) {
  std::vector<MotionDeck> all;
  for (const MeshMotion& moves : motions) all.push_back(moves.motion);
  return greatest_speed(all, {.min = box.min, .max = box.max});
}

}  // namespace

bool is_ever_there(const ImportedScene& scene, std::size_t from, std::size_t until) {
  return from < std::min(until, scene.runs.size());
}

std::vector<MeshMotion> motions_of(const ScriptWall& primitive) {
  if (!primitive.shear) return {};
  return {MeshMotion{.place = primitive.place, .name = primitive.name, .motion = *primitive.shear}};
}

std::vector<MeshMotion> motions_of(const ImportedScene& scene, const std::string& mesh) {
  std::vector<MeshMotion> motions;
  // Of those that begin together the later one is within the earlier one; what begins later acts on where it came to.
  for (auto moves = scene.motions.rbegin(); moves != scene.motions.rend(); ++moves) {
    if (moves->mesh == mesh && is_ever_there(scene, moves->from, moves->until)) motions.push_back(*moves);
  }
  std::stable_sort(motions.begin(), motions.end(),
                   [](const MeshMotion& a, const MeshMotion& b) { return a.from < b.from; });
  const ScriptMesh& moved = scene.meshes.at(mesh);
  if (moved.surface_motion) {
    motions.insert(motions.begin(), MeshMotion{.place = moved.place, .mesh = mesh, .motion = *moved.surface_motion});
  }
  return motions;
}

void note_motions(ImportedScene& scene) {
  for (auto second = scene.motions.begin(); second != scene.motions.end(); ++second) {
    const std::string name = "fix " + second->name;
    if (!scene.has_wall_of(second->mesh)) {
      scene.needless.push_back({second->place, name, fmt::format("mesh {} is no wall", second->mesh)});
      continue;
    }
    for (auto first = scene.motions.begin(); first != second; ++first) {
      if (!overlap(scene, *first, *second) || commute(first->motion, second->motion) || is_carried(*first, *second))
        continue;
      scene.missing.push_back({second->place, name + " move/mesh",
                               fmt::format("LIGGGHTS puts it and fix {} together as a deck cannot say", first->name)});
    }
  }
}

double greatest_wall_speed(const ImportedScene& scene) {
  double speed = 0.0;
  for (const ScriptWall& wall : scene.walls) {
    speed = std::max(speed, speed_of(motions_of(wall), *scene.box));
    for (const std::string& mesh : wall.meshes) speed = std::max(speed, speed_of(motions_of(scene, mesh), *scene.box));
  }
  return speed;
}

}  // namespace repose
