#include "scene/insertion/insertion_face.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/core.h>

#include "base/error.h"
#include "scene/insertion/region.h"

namespace repose {
namespace {

constexpr double flat_share = 1e-6;  // relative: files have single precision

InsertionFace face_of_mesh(const TriangleMesh& mesh) {
  InsertionFace face;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    face.triangles.push_back(mesh.corners(t));
    const auto& triangle = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.around.row(triangle.link[k]).size() != 1) continue;
      face.rims.push_back({mesh.vertices[triangle.vertex[k]], mesh.vertices[triangle.vertex[(k + 1) % 3]]});
    }
  }
  return face;
}

InsertionFace face_of_rectangle(const Rectangle& r) {
  const Vec3 u = r.length_u * r.u;
  const Vec3 v = r.length_v * r.v;
  const std::array<Vec3, 4> corner = {r.corner, r.corner + u, r.corner + u + v, r.corner + v};
  InsertionFace face;
  face.triangles = {{corner[0], corner[1], corner[2]}, {corner[0], corner[2], corner[3]}};
  for (std::size_t k = 0; k < 4; ++k) face.rims.push_back({corner[k], corner[(k + 1) % 4]});
  return face;
}

/// Distance in m of the corner that is farthest from the plane of the largest triangle.
double unevenness(const InsertionFace& face) {
  const auto largest =
      std::max_element(face.triangles.begin(), face.triangles.end(),
                       [](const Corners& a, const Corners& b) { return norm(area_vector(a)) < norm(area_vector(b)); });
  const Vec3 normal = (1.0 / norm(area_vector(*largest))) * area_vector(*largest);
  double farthest = 0.0;
  for (const Corners& triangle : face.triangles) {
    for (const Vec3& corner : triangle) {
      farthest = std::max(farthest, std::fabs(dot(corner - (*largest)[0], normal)));
    }
  }
  return farthest;
}

}  // namespace

InsertionFace make_insertion_face(const Wall& wall) {
  const auto* mesh = std::get_if<Mesh>(&wall.shape);
  const auto* rectangle = std::get_if<Rectangle>(&wall.shape);
  if (mesh == nullptr && rectangle == nullptr) {
    throw DeckError(fmt::format("wall \"{}\" is the face of a pour; that must be a mesh or a rectangle", wall.name));
  }
  InsertionFace face = mesh != nullptr ? face_of_mesh(mesh->surface) : face_of_rectangle(*rectangle);
  const auto [min, max] = bounds(face);
  const double uneven = unevenness(face);
  if (uneven > flat_share * norm(max - min)) {
    throw DeckError(
        fmt::format("wall \"{}\" is the face of a pour, but not flat: corners are up to {:.3g} m beside its "
                    "plane; give a flat one",
                    wall.name, uneven));
  }
  double area = 0.0;
  for (const Corners& triangle : face.triangles) {
    area += 0.5 * norm(area_vector(triangle));
    face.area_up_to.push_back(area);
  }
  return face;
}

Box bounds(const InsertionFace& face) {
  Box box = {face.triangles[0][0], face.triangles[0][0]};
  for (const Corners& triangle : face.triangles) {
    for (const Vec3& c : triangle) {
      box.min = {std::min(box.min.x, c.x), std::min(box.min.y, c.y), std::min(box.min.z, c.z)};
      box.max = {std::max(box.max.x, c.x), std::max(box.max.y, c.y), std::max(box.max.z, c.z)};
    }
  }
  return box;
}

std::optional<Vec3> random_place(const InsertionFace& face, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k) {
  const auto share = [&](std::uint32_t n) { return uniform(seed, static_cast<std::uint64_t>(id), stream, k + n); };
  const auto chosen =
      std::upper_bound(face.area_up_to.begin(), face.area_up_to.end() - 1, share(0) * face.area_up_to.back()) -
      face.area_up_to.begin();
  const Corners& corner = face.triangles[static_cast<std::size_t>(chosen)];
  const double u = share(1);
  const double v = share(2);
  const bool beyond = u + v > 1.0;  // in the other half of the parallelogram
  const Vec3 place =
      corner[0] + (beyond ? 1.0 - u : u) * (corner[1] - corner[0]) + (beyond ? 1.0 - v : v) * (corner[2] - corner[0]);
  const double room = radius * (1.0 - fit_rounding);
  const bool fits = std::none_of(face.rims.begin(), face.rims.end(), [&](const std::array<Vec3, 2>& rim) {
    const Vec3 nearest = rim[0] + nearest_along(rim[0], rim[1], place) * (rim[1] - rim[0]);
    return squared_norm(place - nearest) < room * room;
  });
  if (!fits) return {};
  return place;
}

}  // namespace repose
