#include "measurement/energies.h"

#include <vector>

#include "comm/order_independent_sum.h"
#include "contact/general_law.h"
#include "measurement/touching_pairs.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

double mass_of(const Particles& particles, const MaterialTable& materials, std::size_t i) {
  return sphere_mass(particles.record[i].radius, materials[static_cast<std::size_t>(particles.material[i])].density);
}

double normal_energy(const PairParameters& pair, const ContactGeometry& contact, const ContactStiffness& k,
                     double contact_radius) {
  if (pair.options.normal_law == NormalLaw::jkr) return jkr_energy(pair, contact.radius_eff, contact_radius);
  const double work = pair.options.normal_law == NormalLaw::hooke ? 0.5 : 0.4;
  return work * k.normal * contact.overlap * contact.overlap;
}

double spring_energy(const PairParameters& pair, double overlap, double radius_eff, double mass_eff,
                     const ContactHistory& history) {
  ContactGeometry contact = {};
  contact.overlap = overlap;
  contact.radius_eff = radius_eff;
  contact.mass_eff = mass_eff;
  const double radius = GeneralLaw::contact_radius(pair, contact);
  const ContactStiffness k = GeneralLaw::stiffness(pair, contact, radius);
  const double k_r = GeneralLaw::rolling_stiffness(pair, k, contact);
  return normal_energy(pair, contact, k, radius) + 0.5 * k.tangential * squared_norm(history.spring) +
         (k_r > 0.0 ? 0.5 * squared_norm(history.rolling) / k_r : 0.0);
}

}  // namespace

Energies measure_energies(const Communicator& comm, const Vec3& gravity, const MaterialTable& materials,
                          const Particles& particles, const PairLists& pairs, std::span<const Wall> walls,
                          const WallContacts& wall_contacts) {
  const Vec3& length = particles.periodic.length();
  const Vec3 potential = {length.x > 0.0 ? 0.0 : gravity.x, length.y > 0.0 ? 0.0 : gravity.y,
                          length.z > 0.0 ? 0.0 : gravity.z};
  std::vector<double> translational, rotational, gravitational, elastic;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p) || materials.is_held(particles.material[i])) continue;
    const double mass = mass_of(particles, materials, i);
    translational.push_back(0.5 * mass * squared_norm(p.velocity));
    rotational.push_back(0.5 * sphere_inertia(mass, p.radius) * squared_norm(p.spin));
    gravitational.push_back(-mass * dot(potential, p.position));
  }
  for_each_touching_pair(
      particles, pairs, [&](const PairGroup& g, std::size_t i, std::size_t j, double overlap, std::size_t lane) {
        const double ri = particles.record[i].radius;
        const double rj = particles.record[j].radius;
        const PairParameters& pair =
            materials.pair(static_cast<std::size_t>(g.material_first), static_cast<std::size_t>(g.material_second));
        const double mi = sphere_mass(ri, pair.density_first);
        const double mj = sphere_mass(rj, pair.density_second);
        elastic.push_back(
            spring_energy(pair, overlap, ri * rj / (ri + rj), mi * mj / (mi + mj), lane_history(g, lane)));
      });
  for (const WallContact& c : wall_contacts.contacts(walls, particles)) {
    const auto i = static_cast<std::size_t>(c.particle);
    const auto wall_material = static_cast<std::size_t>(walls[static_cast<std::size_t>(c.wall)].material);
    const PairParameters& pair = materials.pair(static_cast<std::size_t>(particles.material[i]), wall_material);
    if (is_parked(particles.record[i]) || (c.overlap <= 0.0 && !adheres(pair))) continue;
    const double radius = particles.record[i].radius;
    elastic.push_back(spring_energy(pair, c.overlap, radius, sphere_mass(radius, pair.density_first), c.history));
  }
  return {order_independent_sum(comm, translational), order_independent_sum(comm, rotational),
          order_independent_sum(comm, gravitational), order_independent_sum(comm, elastic)};
}

double mean_kinetic_energy(const Communicator& comm, const MaterialTable& materials, const Particles& particles) {
  std::vector<double> energy;
  energy.reserve(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p) || materials.is_held(particles.material[i])) continue;
    energy.push_back(0.5 * mass_of(particles, materials, i) * squared_norm(p.velocity));
  }
  const double total = order_independent_sum(comm, energy);
  const std::int64_t count = comm.sum(static_cast<std::int64_t>(energy.size()));
  return count > 0 ? total / static_cast<double>(count) : 0.0;
}

ContactCount count_contacts(const Communicator& comm, const Particles& particles, const PairLists& pairs,
                            std::span<const Wall> walls, const WallContacts& wall_contacts) {
  std::int64_t here = 0;
  for_each_touching_pair(particles, pairs,
                         [&](const PairGroup&, std::size_t, std::size_t, double, std::size_t) { ++here; });
  return {comm.sum(here), comm.sum(static_cast<std::int64_t>(wall_contacts.contacts(walls, particles).size()))};
}

}  // namespace repose
