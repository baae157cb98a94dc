#include "import/mesh_place.h"

#include <cmath>

#include "base/math.h"

namespace repose {
namespace {

/// A turn: cosine of half its angle, and the axis times the sine.
struct Quaternion {
  double w = 1.0;
  Vec3 v;
};

Quaternion quaternion(const std::array<double, 4>& turn) {
  const Vec3 axis = {turn[0], turn[1], turn[2]};
  const double half = 0.5 * turn[3] * degree;
  return {std::cos(half), (std::sin(half) / norm(axis)) * axis};
}

/// First b, then a.
Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

Vec3 turned(const Vec3& x, const Quaternion& q) {
  const Vec3 t = 2.0 * cross(q.v, x);
  return x + q.w * t + cross(q.v, t);
}

}  // namespace

void scale_mesh(ScriptMesh& mesh, double factor) {
  mesh.scale *= factor;
  mesh.shift = factor * mesh.shift;
}

void turn_mesh(ScriptMesh& mesh, const Vec3& axis, double degrees) {
  const std::array<double, 4> turn = {axis.x, axis.y, axis.z, std::fmod(degrees, 360.0)};
  mesh.turns.push_back(turn);
  mesh.shift = turned(mesh.shift, quaternion(turn));
}

std::array<double, 4> whole_turn(const ScriptMesh& mesh) {
  if (mesh.turns.size() == 1) return mesh.turns[0];
  Quaternion whole;
  for (const auto& turn : mesh.turns) whole = quaternion(turn) * whole;
  const double sine = norm(whole.v);
  if (!(sine > 0.0)) return {0.0, 0.0, 1.0, 0.0};
  return {whole.v.x / sine, whole.v.y / sine, whole.v.z / sine, 2.0 * std::atan2(sine, whole.w) / degree};
}

}  // namespace repose
