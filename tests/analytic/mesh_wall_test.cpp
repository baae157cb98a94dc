// Balls on walls of triangles against the same walls in closed form.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/walls/wall_shape.h"
#include "support/meshes.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;
constexpr double timestep = 4e-6;

struct WallCase {
  WallDeck wall;
  Triangles triangles;  ///< of a mesh
};

Scene scene_on(const WallCase& wall, const Vec3& gravity, const std::vector<Grain>& balls,
               const Coefficients& coefficients = {}) {
  Deck deck = bare_deck(coefficients, timestep);
  deck.gravity = gravity;
  deck.walls.push_back(wall.wall);
  return Scene(deck, balls, best_vector_level(), {{"body.stl", ascii_stl(wall.triangles)}});
}

/// The greatest distance between the places of the same ball in both scenes over `parts` times 250 steps.
double greatest_difference(Scene a, Scene b, int parts) {
  double greatest = 0.0;
  for (int part = 0; part < parts; ++part) {
    a.run(250);
    b.run(250);
    const std::vector<Grain> in_a = a.grains();
    const std::vector<Grain> in_b = b.grains();
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      greatest = std::fmax(greatest, norm(in_a[i].position - in_b[i].position));
      greatest = std::fmax(greatest, radius * timestep * norm(in_a[i].spin - in_b[i].spin));
    }
  }
  return greatest;
}

/// Balls that set out on the plane z = 0 in many directions, one of them along edges of irregular_square. They slide,
/// roll, and some come to rest.
std::vector<Grain> balls_on_floor() {
  std::vector<Grain> balls;
  for (int k = 0; k < 9; ++k) {
    const double angle = k < 8 ? 2.0 * pi * k / 8.0 + (k == 0 ? 0.0 : 0.1) : 0.0;
    const Vec3 ahead = k < 8 ? Vec3{std::cos(angle), std::sin(angle), 0.0} : Vec3{0.6, 0.8, 0.0};
    const Vec3 start = k < 8 ? 0.005 * ahead : Vec3{};
    const Vec3 spin = {0.0, k % 2 == 0 ? 0.0 : 30.0, k % 3 == 0 ? 20.0 : 0.0};
    balls.push_back({start + Vec3{0.0, 0.0, 0.999 * radius}, (k < 8 ? 0.1 : 0.02) * ahead, spin, radius});
  }
  return balls;
}

TEST(MeshWall, AFinelyMeshedPlaneIsThePlane) {
  const WallCase plane = {floor_at(0.0), {}};
  const WallCase mesh = {mesh_deck(), irregular_square(0.03, 200)};
  const Vec3 gravity = {0.3, 0.1, -9.81};
  EXPECT_LT(
      greatest_difference(scene_on(mesh, gravity, balls_on_floor()), scene_on(plane, gravity, balls_on_floor()), 80),
      1e-9 * radius);
}

TEST(MeshWall, ATurnedMeshedPlaneIsTheTurnedPlane) {
  WallDeck turned_plane = floor_at(0.0);
  turned_plane.normal = {0.0, -0.5, std::sqrt(0.75)};
  WallDeck turned_mesh = mesh_deck();
  turned_mesh.rotate_axis = {2.0, 0.0, 0.0};
  turned_mesh.rotate_angle = 30.0;
  const Vec3 n = turned_plane.normal;
  std::vector<Grain> balls = balls_on_floor();
  for (Grain& ball : balls) {
    ball.position = {ball.position.x, ball.position.y * n.z + ball.position.z * n.y,
                     ball.position.z * n.z - ball.position.y * n.y};
  }
  const Vec3 gravity = {0.0, 4.0, -8.0};
  EXPECT_LT(greatest_difference(scene_on({turned_mesh, irregular_square(0.03, 200)}, gravity, balls),
                                scene_on({turned_plane, {}}, gravity, balls), 60),
            1e-9 * radius);
}

WallCase turned_profile(double r0, double z0, double r1, double z1) {
  WallCase wall;
  wall.wall.name = "profile";
  wall.wall.type = WallType::profile;
  wall.wall.material = "wall";
  wall.wall.points = {{r0, z0}, {r1, z1}};
  return wall;
}

/// What a ball does on a mesh of so many facets, against the exact wall, in radii.
double difference_on(const WallCase& exact, WallCase mesh, double feature_angle, const Vec3& gravity,
                     const Grain& ball) {
  mesh.wall.feature_angle = feature_angle;
  return greatest_difference(scene_on(mesh, gravity, {ball}), scene_on(exact, gravity, {ball}), 60) / radius;
}

/// The difference falls with the number of facets, and would not if each touched facet counted.
template <class MakeMesh>
void expect_convergence(const WallCase& exact, const MakeMesh& mesh, const Vec3& gravity, const Grain& ball) {
  const double coarse = difference_on(exact, mesh(32), 20.0, gravity, ball);
  const double medium = difference_on(exact, mesh(128), 20.0, gravity, ball);
  const double fine = difference_on(exact, mesh(512), 20.0, gravity, ball);
  const double every_facet = difference_on(exact, mesh(512), 0.1, gravity, ball);
  fmt::print("radii off: {:.2g} on 32 facets, {:.2g} on 128, {:.2g} on 512; {:.2g} if each touched facet counts\n",
             coarse, medium, fine, every_facet);
  EXPECT_LT(coarse, 0.5);
  EXPECT_LT(medium, 0.7 * coarse);
  EXPECT_LT(fine, 0.1 * medium);
  EXPECT_LT(fine, 0.005);
  EXPECT_GT(every_facet, 5.0 * fine);
}

// A ball rolls to and fro in a horizontal pipe 2.5 times its size, where it touches several facets at once.
TEST(MeshWall, AMeshedCylinderConvergesToTheCylinder) {
  constexpr double pipe = 2.5 * radius;
  const Grain ball = {{0.0, pipe - 0.9995 * radius, 0.0}, {0.0, 0.0, 0.05}, {}, radius};
  const auto mesh = [&](int facets) { return WallCase{mesh_deck(), frustum(pipe, -0.05, pipe, 0.05, facets, 3)}; };
  expect_convergence(turned_profile(pipe, -0.05, pipe, 0.05), mesh, {-9.81, 0.0, 0.0}, ball);
}

// A ball runs around in a cone and comes down.
TEST(MeshWall, AMeshedConeConvergesToTheCone) {
  const double s = std::sqrt(0.5);
  const Vec3 start = {0.015 - 0.9995 * s * radius, 0.0, 0.015 + 0.9995 * s * radius};
  const Grain ball = {start, {0.0, 0.3, 0.0}, {}, radius};
  const auto mesh = [&](int facets) { return WallCase{mesh_deck(), frustum(0.002, 0.002, 0.03, 0.03, facets, 4)}; };
  expect_convergence(turned_profile(0.002, 0.002, 0.03, 0.03), mesh, {0.0, 0.0, -9.81}, ball);
}

}  // namespace
}  // namespace repose::test
