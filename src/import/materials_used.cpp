#include "import/materials_used.h"

#include <algorithm>

#include <fmt/core.h>

namespace repose {
namespace {

constexpr double density_of_walls = 1000.0;  // kg/m3; walls do not move by forces

void check_type(int type, const ImportedScene& scene, const Place& place) {
  if (type > scene.types) refuse(place, fmt::format("type {}, but the box has {}", type, scene.types));
}

/// A part that is off in one of two models is that of the other.
void unite_part(std::string& part, const std::string& other, const Place& place, const char* name) {
  if (other == "off" || other == part) return;
  if (part != "off")
    refuse(place, fmt::format("{} \"{}\" beside \"{}\": all contacts follow one law", name, other, part));
  part = other;
}

}  // namespace

MaterialsUsed::MaterialsUsed(const ImportedScene& scene) : pair_(*scene.model), model_(*scene.model) {
  for (const ScriptInsertion& insertion : scene.insertions) {
    for (const std::string& name : scene.distributions.at(insertion.distribution).templates) {
      const ParticleTemplate& made = scene.templates.at(name);
      check_type(made.type, scene, made.place);
      add_grains(made.type, made.density, made.place);
    }
  }
  for (const Grain& grain : scene.grains) {
    check_type(grain.type, scene, scene.grain_origins.front().place);
    add_grains(grain.type, grain.density, scene.grain_origins.front().place);
  }
  for (const ScriptWall& wall : scene.walls) {
    unite(wall.model);
    if (!wall.shape.empty()) check_type(wall.type, scene, wall.place);
    if (!wall.shape.empty()) add_wall(wall, wall.type);
    for (const std::string& mesh : wall.meshes) {
      check_type(scene.meshes.at(mesh).type, scene, scene.meshes.at(mesh).place);
      add_wall(wall, scene.meshes.at(mesh).type);
    }
  }
}

void MaterialsUsed::unite(const ScriptModel& other) {
  const bool is_same = other.normal == model_.normal && other.tangential_damping == model_.tangential_damping &&
                       other.limit_force == model_.limit_force && other.kt_to_kn_user == model_.kt_to_kn_user &&
                       other.tangential_reduce == model_.tangential_reduce;
  if (!is_same)
    refuse(other.place,
           fmt::format("a wall with another model than {}: all contacts follow one law", text(model_.place)));
  unite_part(model_.tangential, other.tangential, other.place, "tangential");
  unite_part(model_.rolling, other.rolling, other.place, "rolling_friction");
  unite_part(model_.cohesion, other.cohesion, other.place, "cohesion");
}

void MaterialsUsed::add_grains(int type, double density, const Place& place) {
  int others = 0;
  for (const MaterialUsed& material : materials_) {
    if (material.type != type) continue;
    if (material.density == density) return;
    ++others;
  }
  const std::string name = others == 0 ? fmt::format("type{}", type) : fmt::format("type{}_{}", type, others + 1);
  materials_.push_back({.name = name, .type = type, .density = density, .place = place});
}

const MaterialUsed* MaterialsUsed::find_wall(const ScriptWall& wall, int type) const {
  const bool slides = wall.model.tangential != "off";
  const bool coheres = wall.model.cohesion != "off";
  const bool rolls = wall.model.rolling != "off";
  const bool is_as_grains = slides == (pair_.tangential != "off") && coheres == (pair_.cohesion != "off") &&
                            rolls == (pair_.rolling != "off");
  for (const MaterialUsed& material : materials_) {
    if (material.type != type) continue;
    if (material.is_of_grains && is_as_grains) return &material;
    if (!material.is_of_grains && material.slides == slides && material.coheres == coheres && material.rolls == rolls)
      return &material;
  }
  return nullptr;
}

void MaterialsUsed::add_wall(const ScriptWall& wall, int type) {
  if (find_wall(wall, type) != nullptr) return;
  const auto is_named = [&](const std::string& name) {
    return std::any_of(materials_.begin(), materials_.end(), [&](const MaterialUsed& m) { return m.name == name; });
  };
  std::string name = fmt::format("type{}", type);
  if (is_named(name)) name += "_wall";
  const std::string stem = name;
  for (int k = 2; is_named(name); ++k) name = fmt::format("{}_{}", stem, k);
  materials_.push_back({.name = name,
                        .type = type,
                        .density = density_of_walls,
                        .is_of_grains = false,
                        .slides = wall.model.tangential != "off",
                        .coheres = wall.model.cohesion != "off",
                        .rolls = wall.model.rolling != "off",
                        .place = wall.place});
}

const std::string& MaterialsUsed::of_grains(int type, double density) const {
  return std::find_if(materials_.begin(), materials_.end(),
                      [&](const MaterialUsed& m) { return m.is_of_grains && m.type == type && m.density == density; })
      ->name;
}

const std::string& MaterialsUsed::of_wall(const ScriptWall& wall, int type) const {
  return find_wall(wall, type)->name;
}

}  // namespace repose
