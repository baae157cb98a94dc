#include "scene/walls/periodic_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/key.h"

namespace repose {
namespace {

constexpr double most_samples = 128.0;  // in each direction of a boundary

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  const Wall* wall = nullptr;
};

Nearest nearest_wall(std::span<const Wall> walls, const Vec3& x) {
  Nearest nearest;
  for (const Wall& wall : walls) {
    const double d = distance(wall, x);
    if (d < nearest.distance) nearest = {d, &wall};
  }
  return nearest;
}

void check_place(const DomainDeck& domain, Axis across, std::span<const Wall> walls, double reach, Vec3 x) {
  double Vec3::*a = component(across);
  x.*a = domain.min.*a;
  const Nearest low = nearest_wall(walls, x);
  x.*a = domain.max.*a;
  const Nearest high = nearest_wall(walls, x);
  const Nearest& nearer = low.distance < high.distance ? low : high;
  if (nearer.distance >= reach || std::fabs(low.distance - high.distance) < 1e-6 * reach) return;
  throw DeckError(
      fmt::format("wall \"{}\" is within a particle's radius of the periodic boundary across {} at ({:.4g}, {:.4g}, "
                  "{:.4g}), but not as near on the other side; let the wall go on there, or keep it away",
                  nearer.wall->name, enumerators(Axis{})[static_cast<std::size_t>(across)], x.x, x.y, x.z));
}

}  // namespace

void check_walls_meet(const DomainDeck& domain, std::span<const Wall> walls, double reach) {
  if (walls.empty() || !(reach > 0.0)) return;
  for (const Axis across : domain.periodic) {
    const auto after = [&](int k) { return static_cast<Axis>((static_cast<int>(across) + k) % 3); };
    double Vec3::*u = component(after(1));
    double Vec3::*v = component(after(2));
    const Vec3 size = domain.max - domain.min;
    const double in_u = std::clamp(std::ceil(2.0 * size.*u / reach), 1.0, most_samples);
    const double in_v = std::clamp(std::ceil(2.0 * size.*v / reach), 1.0, most_samples);
    for (double i = 0.5; i < in_u; ++i) {
      for (double j = 0.5; j < in_v; ++j) {
        Vec3 x;
        x.*u = domain.min.*u + i / in_u * size.*u;
        x.*v = domain.min.*v + j / in_v * size.*v;
        check_place(domain, across, walls, reach, x);
      }
    }
  }
}

}  // namespace repose
