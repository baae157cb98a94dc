#pragma once

#include <array>

#include "import/imported_scene.h"

namespace repose {

/// Scales a mesh about the origin.
void scale_mesh(ScriptMesh& mesh, double factor);
/// Turns a mesh about an axis through the origin by the right-hand rule.
void turn_mesh(ScriptMesh& mesh, const Vec3& axis, double degrees);
/// All turns of a mesh as one: axis (of any length) and degrees from -360 to 360.
std::array<double, 4> whole_turn(const ScriptMesh& mesh);

}  // namespace repose
