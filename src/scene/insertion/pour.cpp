#include "scene/insertion/pour.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "scene/insertion/region.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

std::vector<double> due_times(const ParticlesDeck& pour, const std::vector<double>& radius, double density) {
  std::vector<double> due;
  double mass = 0.0;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    mass += sphere_mass(radius[k], density);
    const double time = std::isnan(pour.rate) ? static_cast<double>(k + 1) / pour.particle_rate : mass / pour.rate;
    due.push_back(pour.start_time + time);
  }
  return due;
}

/// Time to move by the region's extent and the largest diameter along the velocity, or along gravity from rest.
double clearing_time(const ParticlesDeck& pour, const Box& box, const Vec3& gravity, double diameter,
                     const std::string& name) {
  const Vec3 way = norm(pour.velocity) > 0.0 ? pour.velocity : gravity;
  if (!(norm(way) > 0.0)) {
    throw DeckError(fmt::format("{}: nothing carries the particles away; give a velocity", name));
  }
  const Vec3 n = (1.0 / norm(way)) * way;
  const Vec3 size = box.max - box.min;
  const bool is_flat = pour.region == RegionShape::disc || pour.region == RegionShape::face;
  const double extent = is_flat ? 0.0 : std::fabs(n.x) * size.x + std::fabs(n.y) * size.y + std::fabs(n.z) * size.z;
  const double length = extent + diameter;
  const double speed = norm(pour.velocity);
  const double pull = std::fmax(0.0, dot(gravity, n));
  // length = speed t + pull t^2 / 2, in the form that holds for pull = 0
  return 2.0 * length / (speed + std::sqrt(speed * speed + 2.0 * pull * length));
}

/// Whether some place was found for the particle that needs the most room.
bool face_has_room(const InsertionFace& face, double radius) {
  for (std::uint32_t k = 0; k < 10000; ++k) {
    if (random_place(face, radius, 0, 0, RandomStream::pour_position, 3 * k)) return true;
  }
  return false;
}

void check_region(const Pour& planned, const DomainDeck& domain, double largest, const std::string& name) {
  const ParticlesDeck& pour = planned.deck;
  const auto& [min, max] = planned.bounds;
  const bool inside = min.x >= domain.min.x && min.y >= domain.min.y && min.z >= domain.min.z &&
                      max.x <= domain.max.x && max.y <= domain.max.y && max.z <= domain.max.z;
  if (!inside) throw DeckError(name + ": the region reaches beyond the [domain]; enlarge the domain");
  const Vec3 size = max - min;
  const double narrowest = pour.region == RegionShape::disc ? 2.0 * pour.radius : std::min({size.x, size.y, size.z});
  if (planned.face ? !face_has_room(*planned.face, 0.5 * largest) : largest > narrowest) {
    throw DeckError(fmt::format("{}: the largest particle, {:.6g} m, does not fit into the region", name, largest));
  }
}

}  // namespace

Pour plan_pour(const Deck& deck, std::size_t block, const std::string& name, const std::vector<Wall>& walls,
               std::vector<double> radius, double density) {
  const ParticlesDeck& p = deck.particles[block];
  const double largest = 2.0 * *std::max_element(radius.begin(), radius.end());
  Pour pour;
  pour.block = name;
  pour.deck = p;
  if (p.region == RegionShape::face) {
    const auto wall = std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.name == p.face; });
    if (wall == walls.end()) throw DeckError(fmt::format("{}: no wall is named \"{}\"", name, p.face));
    pour.face = make_insertion_face(*wall);
  }
  pour.bounds = pour.face ? bounds(*pour.face) : bounds(p);
  check_region(pour, deck.domain, largest, name);
  pour.due_time = due_times(p, radius, density);
  pour.radius = std::move(radius);
  pour.interval = std::isnan(p.interval) ? clearing_time(p, pour.bounds, deck.gravity, largest, name) : p.interval;
  return pour;
}

std::optional<Vec3> random_place(const Pour& pour, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k) {
  return pour.face ? random_place(*pour.face, radius, seed, id, stream, k)
                   : random_place(pour.deck, radius, seed, id, stream, k);
}

}  // namespace repose
