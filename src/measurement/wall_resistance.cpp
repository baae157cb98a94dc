#include "measurement/wall_resistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "comm/order_independent_sum.h"

namespace repose {
namespace {

/// What touches a wall: contacts that name the particles by their places among those that touch it.
struct Touching {
  BigVector<ParticleRecord> records;
  std::vector<WallContact> contacts;
  std::vector<std::vector<std::int32_t>> of_material;  ///< contacts by material of the particle
};

Touching touching(std::vector<WallContact> contacts, const Particles& particles, std::size_t materials) {
  Touching all{{}, std::move(contacts), std::vector<std::vector<std::int32_t>>(materials)};
  std::int32_t before = -1;
  for (std::size_t k = 0; k < all.contacts.size(); ++k) {
    const std::int32_t particle = std::exchange(all.contacts[k].particle, 0);
    const auto i = static_cast<std::size_t>(particle);
    if (particle != before) all.records.push_back(particles.record[i]);
    before = particle;
    all.contacts[k].particle = static_cast<std::int32_t>(all.records.size()) - 1;
    all.of_material[static_cast<std::size_t>(particles.material[i])].push_back(static_cast<std::int32_t>(k));
  }
  return all;
}

/// A wall that advances at `speed` (m/s) along `axis` for `time` (s).
struct Advance {
  Vec3 axis;
  double speed = 0.0;
  double time = 0.0;
};

/// N along the axis on each particle, after the wall's advance past particles that stay.
std::vector<double> forces_after(const Advance& advance, VectorLevel level, const Wall& wall,
                                 const MaterialTable& materials, const Touching& touching) {
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  constexpr double nearest = 0.5;  // share of the radius at which a centre is kept from the wall
  const double way = advance.speed * advance.time;
  std::vector<WallContact> contacts = touching.contacts;
  for (WallContact& contact : contacts) {
    if (way == 0.0) break;
    const double radius = touching.records[static_cast<std::size_t>(contact.particle)].radius;
    contact.distance = std::max(contact.distance - way * dot(advance.axis, contact.normal), nearest * radius);
  }
  SurfaceMotion surface = wall.placement.motion;
  surface.velocity += advance.speed * advance.axis;
  BigVector<ForceSum> sums(touching.records.size());
  for (std::size_t m = 0; m < touching.of_material.size(); ++m) {
    WallLaw law = wall_law(materials, static_cast<std::int32_t>(m), wall, advance.time, no_bound);
    law.surface = &surface;
    evaluate_walls(level, law, contacts, touching.of_material[m], touching.records.data(), sums.data());
  }
  std::vector<double> forces;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto component = [&](int k) {
      return static_cast<double>(sums[i].force[k]) / touching.records[i].force_scale;
    };
    forces.push_back(dot(advance.axis, {component(0), component(1), component(2)}));
  }
  return forces;
}

}  // namespace

WallResistance measure_resistance(const Communicator& comm, VectorLevel level, const PressingWall& pressing,
                                  std::span<const Wall> walls, const MaterialTable& materials,
                                  const Particles& particles, const WallContacts& wall_contacts) {
  const Wall& wall = walls[static_cast<std::size_t>(pressing.wall)];
  const Vec3& axis = wall.servo->direction();
  const double speed = wall.servo->max_speed();
  const Touching grains =
      touching(wall_contacts.contacts_with(pressing.wall, walls, particles), particles, materials.size());
  const auto after = [&](const Advance& advance) { return forces_after(advance, level, wall, materials, grains); };
  const std::vector<double> now = after({axis});
  const std::vector<double> standing = after({axis, 0.0, pressing.interval});  // springs go on by the grains' motion
  std::vector<double> growth = after({axis, speed, pressing.interval});
  for (std::size_t k = 0; k < growth.size(); ++k) growth[k] -= standing[k];
  return {order_independent_sum(comm, now), std::fabs(order_independent_sum(comm, growth)) / speed};
}

}  // namespace repose
