#include "import/wall_sections.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/core.h>

#include "import/mesh_place.h"
#include "import/wall_motions.h"

namespace repose {
namespace {

class WallWriter {
 public:
  WallWriter(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const Extent& domain)
      : deck_(deck), scene_(scene), materials_(materials), domain_(domain) {}

  WallNames write() {
    for (const ScriptWall& wall : scene_.walls) {
      if (!is_ever_there(scene_, wall.from, wall.until)) continue;
      if (!wall.shape.empty()) write_primitive(wall);
      for (const std::string& mesh : wall.meshes) write_mesh_wall(wall, mesh);
    }
    for (const ScriptInsertion& insertion : scene_.insertions) {
      if (insertion.face.empty() || result_.faces.contains(insertion.face)) continue;
      write_face(insertion.face);
    }
    note_motions(scene_);
    return std::move(result_);
  }

 private:
  /// Head of a wall; returns its name.
  std::string begin(const std::string& wanted, const Place& place, const std::string& type, const std::string& material,
                    const ScriptWall* wall) {
    const std::string name = names_.take(wanted);
    deck_.section("[[wall]]", place);
    deck_.key("name", name);
    deck_.key("type", type);
    deck_.key("material", material);
    if (wall == nullptr || wall->from > 0) deck_.key("present", false);
    if (wall != nullptr) result_.present.push_back({name, wall->from, wall->until});
    return name;
  }

  void heat(std::optional<double> temperature) {
    if (!temperature || !scene_.heat) return;
    deck_.section("[wall.heat]");
    deck_.key("type", "temperature");
    deck_.key("temperature", *temperature);
  }

  void write_primitive(const ScriptWall& wall) {
    const std::string& material = materials_.of_wall(wall, wall.type);
    if (wall.shape.ends_with("plane")) {
      begin(wall.name, wall.place, "plane", material, &wall);
      deck_.key("point", wall.point);
      deck_.key("normal", wall.direction);
    } else {
      const double low = dot(domain_.min, wall.direction);
      const double high = dot(domain_.max, wall.direction);
      const double beyond = 0.01 * (high - low);
      begin(wall.name, wall.place, "profile", material, &wall);
      deck_.key("points",
                std::vector<std::array<double, 2>>{{wall.radius, low - beyond}, {wall.radius, high + beyond}});
      deck_.key("axis_origin", wall.point);
      deck_.key("axis_direction", wall.direction);
    }
    for (const MeshMotion& moves : motions_of(wall)) write_motion(moves);
    heat(wall.temperature);
  }

  /// Where the STL file will lie: beside the deck, by its own name.
  std::string mesh_file(const std::string& file) {
    const auto found = result_.mesh_files.find(file);
    if (found != result_.mesh_files.end()) return found->second;
    std::string name = std::filesystem::path(file).filename().string();
    const auto is_taken = [&](const std::string& wanted) {
      return std::any_of(result_.mesh_files.begin(), result_.mesh_files.end(),
                         [&](const auto& entry) { return entry.second == wanted; });
    };
    while (is_taken(name)) name = "other_" + name;
    return result_.mesh_files[file] = name;
  }

  void place_mesh(const ScriptMesh& mesh) {
    deck_.key("file", mesh_file(mesh.file), mesh.file);
    if (mesh.scale != 1.0) deck_.key("scale", mesh.scale);
    const auto [x, y, z, angle] = whole_turn(mesh);
    if (angle != 0.0) {
      deck_.key("rotate_axis", Vec3{x, y, z});
      deck_.key("rotate_angle", angle);
    }
    if (!(mesh.shift == Vec3{})) deck_.key("translate", mesh.shift);
    if (mesh.feature_angle) deck_.key("feature_angle", std::clamp(*mesh.feature_angle, 0.1, 90.0));
  }

  void write_mesh_wall(const ScriptWall& wall, const std::string& name) {
    const ScriptMesh& mesh = scene_.meshes.at(name);
    begin(name, mesh.place, "mesh", materials_.of_wall(wall, mesh.type), &wall);
    place_mesh(mesh);
    for (const MeshMotion& moves : motions_of(scene_, name)) write_motion(moves);
    heat(mesh.temperature);
  }

  void write_face(const std::string& name) {
    const ScriptMesh& mesh = scene_.meshes.at(name);
    result_.faces[name] = begin(name, mesh.place, "mesh", materials_.all().front().name, nullptr);
    place_mesh(mesh);
  }

  void write_motion(const MeshMotion& moves) {
    const MotionDeck& motion = moves.motion;
    deck_.section("[[wall.motion]]", moves.place);
    deck_.key("type", motion.type);
    if (motion.type == MotionType::translation || motion.type == MotionType::conveyor) {
      deck_.key("velocity", motion.velocity);
    }
    if (motion.type == MotionType::oscillation) {
      deck_.key("amplitude", motion.amplitude);
      deck_.key("frequency", motion.frequency);
    }
    if (motion.type == MotionType::rotation) {
      deck_.key("axis_origin", motion.axis_origin);
      deck_.key("axis_direction", motion.axis_direction);
      deck_.key("angular_velocity", motion.angular_velocity);
    }
    const std::size_t end = std::min(moves.until, scene_.runs.size());
    if (moves.from == 0 && end == scene_.runs.size()) return;
    std::vector<std::string> phases;
    for (std::size_t run = moves.from; run < end; ++run) phases.push_back(phase_name(run));
    deck_.key("phases", phases);
  }

  DeckText& deck_;
  ImportedScene& scene_;
  const MaterialsUsed& materials_;
  const Extent& domain_;
  DeckNames names_;
  WallNames result_;
};

}  // namespace

std::string phase_name(std::size_t run) { return fmt::format("run_{}", run + 1); }

WallNames write_walls(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const Extent& domain) {
  return WallWriter(deck, scene, materials, domain).write();
}

}  // namespace repose
