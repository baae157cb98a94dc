#include "measurement/wall_resistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "comm/order_independent_sum.h"
#include "measurement/force_sum.h"

namespace repose {
namespace {

/// What touches a wall: contacts that name the particles by their places among those that touch it.
struct Touching {
  const Wall* wall;
  BigVector<ParticleRecord> records;
  std::vector<WallContact> contacts;
  std::vector<std::vector<std::int32_t>> of_material;  ///< contacts by material of the particle
};

Touching touching(const Wall& wall, std::vector<WallContact> contacts, const Particles& particles,
                  std::size_t materials) {
  Touching all{&wall, {}, std::move(contacts), std::vector<std::vector<std::int32_t>>(materials)};
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

/// A body that advances at `speed` (m/s, or rad/s) along or about `axis` for `time` (s).
struct Advance {
  const ServoAxis& axis;
  double speed;
  double time;
  double nearest;  ///< share of the radius at which a centre is kept from the wall
};

/// Appends the load along or about the axis on each particle that touches a wall of the body, after its advance past
/// particles that stay.
void add_loads_after(const Advance& advance, VectorLevel level, const MaterialTable& materials,
                     const Touching& touching, std::vector<double>& loads) {
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  const double way = advance.speed * advance.time;
  std::vector<WallContact> contacts = touching.contacts;
  for (WallContact& contact : contacts) {
    if (way == 0.0) break;
    const ParticleRecord& p = touching.records[static_cast<std::size_t>(contact.particle)];
    const double approach = way * dot(advance.axis.motion(1.0).at(p.position), contact.normal);
    contact.distance = std::max(contact.distance - approach, advance.nearest * p.radius);
  }
  SurfaceMotion surface = touching.wall->placement.motion;
  const SurfaceMotion added = advance.axis.motion(advance.speed);
  surface.velocity += added.velocity;
  surface.angular_velocity += added.angular_velocity;
  BigVector<ForceSum> sums(touching.records.size());
  for (std::size_t m = 0; m < touching.of_material.size(); ++m) {
    WallLaw law = wall_law(materials, static_cast<std::int32_t>(m), *touching.wall, advance.time, no_bound);
    law.surface = &surface;
    evaluate_walls(level, law, contacts, touching.of_material[m], touching.records.data(), sums.data());
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const ParticleRecord& p = touching.records[i];
    loads.push_back(advance.axis.load(p.position, force_of(sums[i], p), torque_of(sums[i], p)));
  }
}

}  // namespace

WallResistance measure_resistance(const Communicator& comm, VectorLevel level, const PressingWall& pressing,
                                  std::span<const Wall> walls, const MaterialTable& materials,
                                  const Particles& particles, const WallContacts& wall_contacts) {
  const auto leader = static_cast<std::size_t>(pressing.wall);
  const ServoAxis& axis = walls[leader].servo->axis();
  const double speed = walls[leader].servo->max_speed();
  const double nearest = 1.0 - std::min(0.5, 2.0 * pressing.max_overlap);  // deeper, the force is out of its range
  std::vector<Touching> grains;
  for (const std::size_t w : body_of(walls, leader)) {
    grains.push_back(touching(walls[w], wall_contacts.contacts_with(static_cast<std::int32_t>(w), walls, particles),
                              particles, materials.size()));
  }
  const auto after = [&](double at_speed, double time) {
    std::vector<double> loads;
    for (const Touching& one : grains) add_loads_after({axis, at_speed, time, nearest}, level, materials, one, loads);
    return loads;
  };
  const std::vector<double> now = after(0.0, moment);
  const std::vector<double> standing = after(0.0, pressing.interval);  // springs go on by the grains' motion
  std::vector<double> growth = after(speed, pressing.interval);
  for (std::size_t k = 0; k < growth.size(); ++k) growth[k] -= standing[k];
  return {order_independent_sum(comm, now), std::fabs(order_independent_sum(comm, growth)) / speed};
}

}  // namespace repose
