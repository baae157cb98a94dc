#include "import/wall_sections.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/core.h>

#include "import/mesh_place.h"

namespace repose {
namespace {

const Vec3 unit_x{1.0, 0.0, 0.0};
const Vec3 unit_y{0.0, 1.0, 0.0};
const Vec3 unit_z{0.0, 0.0, 1.0};

class WallWriter {
 public:
  WallWriter(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const Extent& domain)
      : deck_(deck), scene_(scene), materials_(materials), domain_(domain) {}

  WallNames write() {
    for (const ScriptWall& wall : scene_.walls) {
      if (!is_ever_there(wall.from, wall.until)) continue;
      if (!wall.shape.empty()) write_primitive(wall);
      for (const std::string& mesh : wall.meshes) write_mesh_wall(wall, mesh);
    }
    for (const ScriptInsertion& insertion : scene_.insertions) {
      if (insertion.face.empty() || result_.faces.contains(insertion.face)) continue;
      write_face(insertion.face);
    }
    note_motions_of_no_wall();
    return std::move(result_);
  }

 private:
  bool is_ever_there(std::size_t from, std::size_t until) const { return from < std::min(until, scene_.runs.size()); }

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

  void conveyor(const Vec3& velocity) {
    deck_.section("[[wall.motion]]");
    deck_.key("type", "conveyor");
    deck_.key("velocity", velocity);
  }

  void heat(std::optional<double> temperature) {
    if (!temperature || !scene_.heat) return;
    deck_.section("[wall.heat]");
    deck_.key("type", "temperature");
    deck_.key("temperature", *temperature);
  }

  void write_primitive(const ScriptWall& wall) {
    const std::string& material = materials_.of_wall(wall, wall.type);
    const char axis = wall.shape[0];
    const Vec3& direction = axis == 'x' ? unit_x : axis == 'y' ? unit_y : unit_z;
    if (wall.shape.ends_with("plane")) {
      begin(wall.name, wall.place, "plane", material, &wall);
      deck_.key("point", wall.numbers[0] * direction);
      deck_.key("normal", direction);
    } else {
      const auto [radius, c1, c2] = wall.numbers;
      const double low = dot(domain_.min, direction);
      const double high = dot(domain_.max, direction);
      const Vec3 origin = axis == 'x' ? Vec3{0.0, c1, c2} : axis == 'y' ? Vec3{c1, 0.0, c2} : Vec3{c1, c2, 0.0};
      const double beyond = 0.01 * (high - low);
      begin(wall.name, wall.place, "profile", material, &wall);
      deck_.key("points", std::vector<std::array<double, 2>>{{radius, low - beyond}, {radius, high + beyond}});
      deck_.key("axis_origin", origin);
      deck_.key("axis_direction", direction);
    }
    if (wall.surface_velocity) conveyor(*wall.surface_velocity);
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
    if (mesh.surface_velocity) conveyor(*mesh.surface_velocity);
    if (mesh.surface_turn) write_motion(*mesh.surface_turn, mesh.place, 0, never_removed);
    for (const MeshMotion& moves : scene_.motions) {
      if (moves.mesh == name && is_ever_there(moves.from, moves.until)) {
        write_motion(moves.motion, moves.place, moves.from, moves.until);
      }
    }
    heat(mesh.temperature);
  }

  void write_face(const std::string& name) {
    const ScriptMesh& mesh = scene_.meshes.at(name);
    result_.faces[name] = begin(name, mesh.place, "mesh", materials_.all().front().name, nullptr);
    place_mesh(mesh);
  }

  void write_motion(const MotionDeck& motion, const Place& place, std::size_t from, std::size_t until) {
    deck_.section("[[wall.motion]]", place);
    deck_.key("type", motion.type);
    if (motion.type == MotionType::translation) deck_.key("velocity", motion.velocity);
    if (motion.type == MotionType::oscillation) {
      deck_.key("amplitude", motion.amplitude);
      deck_.key("frequency", motion.frequency);
    }
    if (motion.type == MotionType::rotation) {
      deck_.key("axis_origin", motion.axis_origin);
      deck_.key("axis_direction", motion.axis_direction);
      deck_.key("angular_velocity", motion.angular_velocity);
    }
    const std::size_t end = std::min(until, scene_.runs.size());
    if (from == 0 && end == scene_.runs.size()) return;
    std::vector<std::string> phases;
    for (std::size_t run = from; run < end; ++run) phases.push_back(phase_name(run));
    deck_.key("phases", phases);
  }

  void note_motions_of_no_wall() {
    for (const MeshMotion& moves : scene_.motions) {
      if (!scene_.has_wall_of(moves.mesh)) {
        scene_.needless.push_back({moves.place, "fix " + moves.name, fmt::format("mesh {} is no wall", moves.mesh)});
      }
    }
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
