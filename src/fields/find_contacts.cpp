#include "fields/find_contacts.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/core.h>

#include "base/error.h"
#include "contact/adhesion_range.h"
#include "contact/pair_loop.h"
#include "contact/wall_contacts.h"
#include "neighbours/near_pairs.h"
#include "neighbours/pair_lists.h"

namespace repose::fields {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// Two grains that touch, or that hold together: the first has the lower id.
struct Pair {
  std::size_t first, second;  ///< rows of the state's particles
  Vec3 first_at, second_at;   ///< m, next to each other
  ContactHistory history;
};

/// m: how far apart surfaces that have touched may hold together in this state.
double adhesion_range(const State& state) {
  double smallest = no_bound;
  double largest = 0.0;
  for (const ParticleRecord& p : state.particles.record) {
    smallest = std::min(smallest, p.radius);
    largest = std::max(largest, p.radius);
  }
  return longest_holding_distance(state.materials, smallest, largest);
}

ContactHistory remembered(const State& state, std::size_t first, std::size_t second) {
  for (const PairMemory& m : state.memory.pairs.row(first)) {
    if (m.partner == state.particles.id[second]) return m.history;
  }
  return {};
}

/// Across a periodic boundary a pair is seen from both its sides; that of the first counts.
std::vector<Pair> touching_pairs(const State& state, double range) {
  const Particles& particles = state.particles;
  std::vector<Vec3> position;
  std::vector<double> reach;
  for (const ParticleRecord& p : particles.record) {
    position.push_back(p.position);
    reach.push_back(p.radius + range);
  }
  const SpheresWithImages all = with_images(particles.periodic, position, reach);
  std::vector<ParticleRecord> records;
  for (std::size_t k = 0; k < all.position.size(); ++k) {
    records.push_back(particles.record[all.original[k]]);
    records.back().position = all.position[k];
  }
  std::vector<Pair> pairs;
  for (const IndexPair& near : near_pairs(records, all.radius, particles.owned)) {
    const auto a = static_cast<std::size_t>(near[0]);
    const auto b = static_cast<std::size_t>(near[1]);
    if (all.original[a] >= all.original[b]) continue;
    const Pair pair = {all.original[a], all.original[b], all.position[a], all.position[b],
                       remembered(state, all.original[a], all.original[b])};
    const double touching = records[a].radius + records[b].radius;
    if (norm(pair.first_at - pair.second_at) < touching || !is_blank(pair.history)) pairs.push_back(pair);
  }
  return pairs;
}

Vec3 force_of(const ForceSum& sum, const ParticleRecord& p) {
  return {static_cast<double>(sum.force[0]) / p.force_scale, static_cast<double>(sum.force[1]) / p.force_scale,
          static_cast<double>(sum.force[2]) / p.force_scale};
}

Vec3 normal_part(const Vec3& force, const Vec3& branch) { return (dot(force, branch) / squared_norm(branch)) * branch; }

void check(const ContactAlarms& alarms, const std::string& file) {
  if (alarms.out_of_range > 0) {
    throw FileError(fmt::format("{}: a contact force is out of range; its deck is not that of this state", file));
  }
}

/// The forces of pairs of two materials. Each pair has copies of its grains for itself, so that the loop over contacts
/// of the simulation, which adds up the forces on a grain, gives the force of each contact.
void evaluate(const State& state, const std::vector<Pair>& pairs, const std::string& file,
              std::vector<ContactForce>& forces) {
  Particles copies;
  std::vector<ContactBlock> blocks((pairs.size() + block_lanes - 1) / block_lanes);
  for (const Pair& pair : pairs) {
    copies.record.push_back(state.particles.record[pair.first]);
    copies.record.back().position = pair.first_at;
    copies.record.push_back(state.particles.record[pair.second]);
    copies.record.back().position = pair.second_at;
  }
  const auto dummy = static_cast<std::int32_t>(copies.record.size());
  add_lane_dummies(copies);
  for (std::size_t lane = 0; lane < block_lanes * blocks.size(); ++lane) {
    ContactBlock& block = blocks[lane / block_lanes];
    const std::size_t slot = lane % block_lanes;
    const bool is_used = lane < pairs.size();
    block.first[slot] = is_used ? static_cast<std::int32_t>(2 * lane) : dummy;
    block.second[slot] = block.first[slot] + 1;
    set_history(block, slot, is_used ? pairs[lane].history : ContactHistory{});
  }
  const auto material = [&](std::size_t i) { return static_cast<std::size_t>(state.particles.material[i]); };
  const PairParameters& law = state.materials.pair(material(pairs[0].first), material(pairs[0].second));
  check(evaluate_pairs(best_vector_level(), blocks, {}, law, 0.0, no_bound, copies.record.data(), copies.sum.data()),
        file);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Vec3 force = force_of(copies.sum[2 * k], copies.record[2 * k]);
    const Vec3 branch = pairs[k].first_at - pairs[k].second_at;
    forces.push_back({pairs[k].first_at, pairs[k].second_at, state.remembers ? force : normal_part(force, branch)});
  }
}

std::vector<ContactForce> pair_forces(const State& state, double range, const std::string& file) {
  std::map<std::array<std::int32_t, 2>, std::vector<Pair>> of_materials;
  for (const Pair& pair : touching_pairs(state, range)) {
    of_materials[{state.particles.material[pair.first], state.particles.material[pair.second]}].push_back(pair);
  }
  std::vector<ContactForce> forces;
  for (const auto& [materials, pairs] : of_materials) {
    if (!state.materials.is_held(materials[0]) || !state.materials.is_held(materials[1]))
      evaluate(state, pairs, file, forces);
  }
  return forces;
}

std::vector<WallContact> wall_contacts(const State& state, double range) {
  Particles particles = state.particles;
  std::vector<double> reach;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const bool is_held = state.materials.is_held(particles.material[i]);  // held grains feel no walls
    reach.push_back(is_held ? -no_bound : particles.record[i].radius + range);
  }
  WallContacts contacts;
  contacts.build(particles, state.walls, reach, state.memory.walls);
  contacts.select_near(particles, state.walls, {.share = 0.0, .horizon = 0.0, .adhesion_range = range});
  contacts.evaluate(best_vector_level(), state.walls, state.materials, 0.0, no_bound, particles);
  return contacts.contacts(state.walls, particles);
}

std::vector<ContactForce> wall_forces(const State& state, double range, const std::string& file) {
  std::vector<WallContact> contacts = wall_contacts(state, range);
  BigVector<ParticleRecord> records;
  std::map<std::array<std::int32_t, 2>, std::vector<std::int32_t>> of_law;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts[k].particle);
    records.push_back(state.particles.record[i]);
    of_law[{state.particles.material[i], contacts[k].wall}].push_back(static_cast<std::int32_t>(k));
    contacts[k].particle = static_cast<std::int32_t>(k);
  }
  BigVector<ForceSum> sums(records.size());
  for (const auto& [of, chosen] : of_law) {
    const WallLaw law = wall_law(state.materials, of[0], state.walls[static_cast<std::size_t>(of[1])], 0.0, no_bound);
    check(evaluate_walls(best_vector_level(), law, contacts, chosen, records.data(), sums.data()), file);
  }
  std::vector<ContactForce> forces;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3 branch = contacts[k].distance * contacts[k].normal;
    const Vec3 force = force_of(sums[k], records[k]);
    forces.push_back({records[k].position, records[k].position - branch,
                      state.remembers ? force : normal_part(force, contacts[k].normal)});
  }
  return forces;
}

}  // namespace

ContactForces find_contacts(const State& state, const std::string& file) {
  const double range = adhesion_range(state);
  return {pair_forces(state, range, file), wall_forces(state, range, file)};
}

}  // namespace repose::fields
