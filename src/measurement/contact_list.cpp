#include "measurement/contact_list.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "comm/buffer.h"
#include "measurement/contact_forces.h"
#include "measurement/touching_pairs.h"

namespace repose {
namespace {

struct Moving {
  std::int64_t id;
  Vec3 velocity;
  Vec3 spin;
};
using MovingOf = std::unordered_map<std::int64_t, Moving>;

/// Collective. How the particles with these ids move, whoever owns them: ghosts still have the velocities of half a
/// step ago.
MovingOf ask_owners(const Communicator& comm, const Particles& particles, std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<char> question;
  PackBuffer(question).put_all(std::span<const std::int64_t>(ids));
  std::unordered_map<std::int64_t, std::size_t> owned;
  for (std::size_t i = 0; i < particles.owned; ++i) owned[particles.id[i]] = i;
  std::vector<std::vector<char>> answers;
  for (const std::vector<char>& asked :
       comm.exchange(std::vector<std::vector<char>>(static_cast<std::size_t>(comm.size()), question))) {
    PackBuffer answer(answers.emplace_back());
    for (UnpackBuffer buffer(asked); !buffer.at_end();) {
      const auto id = buffer.get<std::int64_t>();
      const auto found = owned.find(id);
      if (found == owned.end()) continue;
      const ParticleRecord& p = particles.record[found->second];
      answer.put(Moving{id, p.velocity, p.spin});
    }
  }
  MovingOf moving;
  for (const std::vector<char>& bytes : comm.exchange(answers)) {
    for (UnpackBuffer buffer(bytes); !buffer.at_end();) {
      const auto one = buffer.get<Moving>();
      moving[one.id] = one;
    }
  }
  return moving;
}

void set_forces(ListedContact& contact, const Vec3& force, const Vec3& direction) {
  contact.normal_force = part_along(force, direction);
  contact.tangential_force = force - contact.normal_force;
}

void list_pairs(const Communicator& comm, VectorLevel level, const MaterialTable& materials, const Particles& particles,
                const PairLists& pairs, std::vector<ListedContact>& contacts) {
  std::vector<TouchingPair> touching;
  std::vector<std::int64_t> ghosts;
  const std::size_t begin = contacts.size();
  for_each_touching_pair(particles, pairs,
                         [&](const PairGroup& group, std::size_t i, std::size_t j, double, std::size_t lane) {
                           touching.push_back({particles.record[i], particles.record[j], group.material_first,
                                               group.material_second, lane_history(group, lane)});
                           const Vec3 into_domain = particles.position(i) - particles.record[i].position;
                           contacts.push_back({particles.id[i], particles.id[j], -1, -1, particles.position(i),
                                               particles.record[j].position + into_domain, Vec3{}, Vec3{}});
                           if (j >= particles.owned) ghosts.push_back(particles.id[j]);
                         });
  const MovingOf moving = ask_owners(comm, particles, ghosts);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const auto found = moving.find(contacts[begin + k].second);
    if (found == moving.end()) continue;
    touching[k].second.velocity = found->second.velocity;
    touching[k].second.spin = found->second.spin;
  }
  ContactAlarms alarms;  // the step's own evaluation has been looked at
  const std::vector<Vec3> forces = pair_contact_forces(level, materials, touching, alarms);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    set_forces(contacts[begin + k], forces[k], touching[k].first.position - touching[k].second.position);
  }
}

void list_wall_contacts(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials,
                        const Particles& particles, const WallContacts& wall_contacts,
                        std::vector<ListedContact>& contacts) {
  const std::vector<WallContact> touching = wall_contacts.contacts(walls, particles);
  ContactAlarms alarms;
  const std::vector<Vec3> forces = wall_contact_forces(level, walls, materials, particles, touching, alarms);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const WallContact& c = touching[k];
    const auto i = static_cast<std::size_t>(c.particle);
    contacts.push_back({particles.id[i], -1, c.wall, c.feature, particles.position(i),
                        particles.position(i) - c.distance * c.normal, Vec3{}, Vec3{}});
    set_forces(contacts.back(), forces[k], c.normal);
  }
}

/// Collective. Those of all ranks, on rank 0.
std::vector<ListedContact> gathered(const Communicator& comm, const std::vector<ListedContact>& contacts) {
  std::vector<std::vector<char>> send(static_cast<std::size_t>(comm.size()));
  PackBuffer(send[0]).put_all(std::span<const ListedContact>(contacts));
  std::vector<ListedContact> all;
  for (const std::vector<char>& bytes : comm.exchange(send)) {
    for (UnpackBuffer buffer(bytes); !buffer.at_end();) all.push_back(buffer.get<ListedContact>());
  }
  return all;
}

}  // namespace

std::vector<ListedContact> list_contacts(const Communicator& comm, VectorLevel level, std::span<const Wall> walls,
                                         const MaterialTable& materials, const Particles& particles,
                                         const PairLists& pairs, const WallContacts& wall_contacts) {
  std::vector<ListedContact> here;
  list_pairs(comm, level, materials, particles, pairs, here);
  list_wall_contacts(level, walls, materials, particles, wall_contacts, here);
  std::vector<ListedContact> all = gathered(comm, here);
  const auto key = [](const ListedContact& c) { return std::tie(c.first, c.second, c.wall, c.feature); };
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return all;
}

}  // namespace repose
