#pragma once

#include <string>
#include <vector>

#include "import/imported_scene.h"

namespace repose {

/// Whether there is a run between these.
bool is_ever_there(const ImportedScene& scene, std::size_t from, std::size_t until);

/// The motions of a primitive, and of a mesh, as a deck has them: the first is applied first.
std::vector<MeshMotion> motions_of(const ScriptWall& primitive);
std::vector<MeshMotion> motions_of(const ImportedScene& scene, const std::string& mesh);

/// Notes motions of a mesh that LIGGGHTS puts together as a deck cannot say, and those of meshes that are no walls.
void note_motions(ImportedScene& scene);

/// The greatest speed in m/s that a wall has within the box.
double greatest_wall_speed(const ImportedScene& scene);

}  // namespace repose
