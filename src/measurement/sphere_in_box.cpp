#include "measurement/sphere_in_box.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace repose {
namespace {

/// Angle of the arc, on the circle of radius `rho`, that is beyond both p and q along axes at right angles.
double arc_angle(double rho, double p, double q) {
  return std::acos(std::min(p / rho, 1.0)) - std::asin(std::min(q / rho, 1.0));
}

/// Part of the circle beyond p and q.
double corner_of_disc(double rho, double p, double q) {
  const double p_end = std::sqrt(std::max(rho * rho - q * q, 0.0));
  const double q_end = std::sqrt(std::max(rho * rho - p * p, 0.0));
  return 0.5 * (rho * rho * arc_angle(rho, p, q) - p * (q_end - q) - q * (p_end - p));
}

/// Volume of the unit sphere beyond three planes across the axes, none of which is before its centre: by the divergence
/// theorem from the areas of its faces, the curved one by Gauss and Bonnet (V.1).
double corner_of_ball(const std::array<double, 3>& at) {
  const auto& [a, b, c] = at;
  if (a * a + b * b + c * c >= 1.0) return 0.0;
  double patch = -pi;
  double faces = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double here = at[k], p = at[(k + 1) % 3], q = at[(k + 2) % 3];
    const double rho = std::sqrt(1.0 - here * here);
    patch += std::acos(std::min(p * q / std::sqrt((1.0 - p * p) * (1.0 - q * q)), 1.0)) - here * arc_angle(rho, p, q);
    faces += here * corner_of_disc(rho, p, q);
  }
  return (patch - faces) / 3.0;
}

/// The same wherever the planes are: what is beyond a plane before the centre is the whole less its mirror image.
double beyond(std::array<double, 3> at, std::size_t axis = 0) {
  if (axis == at.size()) return corner_of_ball(at);
  if (at[axis] >= 0.0) return beyond(at, axis + 1);
  std::array<double, 3> middle = at;
  middle[axis] = 0.0;
  at[axis] = -at[axis];
  return 2.0 * beyond(middle, axis + 1) - beyond(at, axis + 1);
}

}  // namespace

double volume_in_box(const Sphere& sphere, const Vec3& min, const Vec3& max) {
  const auto in_radii = [&](double coordinate, double centre) {
    return std::clamp((coordinate - centre) / sphere.radius, -1.0, 1.0);
  };
  const Vec3& o = sphere.centre;
  const std::array<std::array<double, 2>, 3> faces = {{{in_radii(min.x, o.x), in_radii(max.x, o.x)},
                                                       {in_radii(min.y, o.y), in_radii(max.y, o.y)},
                                                       {in_radii(min.z, o.z), in_radii(max.z, o.z)}}};
  const auto is_inside = [](const std::array<double, 2>& f) { return f[0] == -1.0 && f[1] == 1.0; };
  if (std::all_of(faces.begin(), faces.end(), is_inside)) return volume(sphere);
  double sum = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const unsigned x = corner & 1U, y = (corner >> 1U) & 1U, z = corner >> 2U;
    const double sign = (x + y + z) % 2 == 0 ? 1.0 : -1.0;
    sum += sign * beyond({faces[0][x], faces[1][y], faces[2][z]});
  }
  return std::max(sum, 0.0) * (sphere.radius * sphere.radius * sphere.radius);
}

}  // namespace repose
