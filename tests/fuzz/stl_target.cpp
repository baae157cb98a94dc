// An STL file, up to the wall that it becomes and its use.
#include <cmath>
#include <variant>

#include "scene/walls/wall.h"
#include "target.h"

namespace repose::fuzz {

namespace {

WallDeck mesh_wall() {
  WallDeck deck;
  deck.name = "body";
  deck.type = WallType::mesh;
  deck.file = "body.stl";
  return deck;
}

void check_touches(const Wall& wall, const Vec3& centre) {
  const double d = distance(wall, centre);
  expect(std::isfinite(d), "a distance is finite");
  const double reach = 1.1 * d + 1e-3 + flatness(std::get<Mesh>(wall.shape));  // a touch is that of a patch's plane
  expect(is_within(wall, centre, reach), "what is near is within reach");
  TouchBuffer touches;
  const int found = find_touches(wall, 0, centre, reach, touches);
  constexpr double rounding = 1e-9;  // m; a centre on the surface itself has no normal
  expect(found > 0 || d < rounding, "what is near is touched");
  for (const WallTouch& t : touches.touches()) {
    expect(std::fabs(norm(t.normal) - 1.0) < 1e-12, "a normal has length 1");
  }
}

}  // namespace

bool accepts(std::string_view input) {
  Wall wall;
  if (!is_done([&] { wall = make_wall(mesh_wall(), 0, [&](const std::string&) { return std::string(input); }); }))
    return false;
  for (const Vec3& centre : {Vec3{}, Vec3{0.3, 0.4, 0.1}, Vec3{-2.0, 0.1, 5.0}}) check_touches(wall, centre);
  return true;
}

}  // namespace repose::fuzz
