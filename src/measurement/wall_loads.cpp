#include "measurement/wall_loads.h"

#include <array>
#include <limits>

#include "comm/order_independent_sum.h"
#include "measurement/force_sum.h"

namespace repose {
namespace {

/// Components of force and torque, one entry per particle each.
using Contributions = std::array<std::vector<double>, 6>;

/// What the wall does to each particle is in its sum; the particle does the opposite to the wall.
void add_reaction(const ParticleRecord& p, const Vec3& position, const ForceSum& sum, Contributions& load) {
  const Vec3 force = -force_of(sum, p);
  const Vec3 torque = cross(position, force) - torque_of(sum, p);
  const std::array<double, 6> components = {force.x, force.y, force.z, torque.x, torque.y, torque.z};
  for (std::size_t k = 0; k < components.size(); ++k) load[k].push_back(components[k]);
}

/// The contacts with wall `w`, by material of the particle.
std::vector<std::vector<std::int32_t>> contacts_with(std::int32_t w, std::span<const WallContact> contacts,
                                                     const Particles& particles, std::size_t materials) {
  std::vector<std::vector<std::int32_t>> chosen(materials);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (contacts[k].wall != w) continue;
    const std::int32_t material = particles.material[static_cast<std::size_t>(contacts[k].particle)];
    chosen[static_cast<std::size_t>(material)].push_back(static_cast<std::int32_t>(k));
  }
  return chosen;
}

}  // namespace

std::vector<WallLoad> measure_wall_loads(const Communicator& comm, VectorLevel level, std::span<const Wall> walls,
                                         const MaterialTable& materials, const Particles& particles,
                                         const WallContacts& wall_contacts) {
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  std::vector<WallContact> contacts = wall_contacts.contacts(walls, particles);
  BigVector<ForceSum> sums(particles.record.size());
  std::vector<WallLoad> loads;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    Contributions load;
    const auto chosen = contacts_with(static_cast<std::int32_t>(w), contacts, particles, materials.size());
    for (std::size_t m = 0; m < chosen.size(); ++m) {
      const WallLaw law = wall_law(materials, static_cast<std::int32_t>(m), walls[w], moment, no_bound);
      evaluate_walls(level, law, contacts, chosen[m], particles.record.data(), sums.data());
      for (const std::int32_t k : chosen[m]) {
        const auto i = static_cast<std::size_t>(contacts[static_cast<std::size_t>(k)].particle);
        add_reaction(particles.record[i], particles.position(i), sums[i], load);
        sums[i] = {};  // a particle with two contacts has given both
      }
    }
    std::array<double, 6> total;
    for (std::size_t k = 0; k < total.size(); ++k) total[k] = order_independent_sum(comm, load[k]);
    loads.push_back({{total[0], total[1], total[2]}, {total[3], total[4], total[5]}});
  }
  return loads;
}

}  // namespace repose
