#include "fields/find_contacts.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "contact/adhesion_range.h"
#include "measurement/contact_forces.h"
#include "neighbours/near_pairs.h"

namespace repose::fields {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

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

/// Across a periodic boundary a pair is seen from both its sides; that of the first counts. Held grains do not feel one
/// another.
std::vector<TouchingPair> touching_pairs(const State& state, double range) {
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
  std::vector<TouchingPair> pairs;
  for (const IndexPair& near : near_pairs(records, all.radius, particles.owned)) {
    const ParticleRecord& first = records[static_cast<std::size_t>(near[0])];
    const ParticleRecord& second = records[static_cast<std::size_t>(near[1])];
    const std::size_t a = all.original[static_cast<std::size_t>(near[0])];
    const std::size_t b = all.original[static_cast<std::size_t>(near[1])];
    const auto is_held = [&](std::size_t i) { return state.materials.is_held(particles.material[i]); };
    if (a >= b || (is_held(a) && is_held(b))) continue;
    const ContactHistory history = remembered(state, a, b);
    const bool touch = norm(first.position - second.position) < first.radius + second.radius;
    if (touch || !is_blank(history))
      pairs.push_back({first, second, particles.material[a], particles.material[b], history});
  }
  return pairs;
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

}  // namespace

ContactForces find_contacts(const State& state, const std::string& file) {
  const double range = adhesion_range(state);
  const std::vector<TouchingPair> pairs = touching_pairs(state, range);
  const std::vector<WallContact> walls = wall_contacts(state, range);
  ContactAlarms alarms;
  const std::vector<Vec3> on_pairs = pair_contact_forces(best_vector_level(), state.materials, pairs, alarms);
  const std::vector<Vec3> on_walls =
      wall_contact_forces(best_vector_level(), state.walls, state.materials, state.particles, walls, alarms);
  if (alarms.out_of_range > 0) {
    throw FileError(fmt::format("{}: a contact force is out of range; its deck is not that of this state", file));
  }
  const auto known = [&](const Vec3& force, const Vec3& branch) {
    return state.remembers ? force : part_along(force, branch);
  };
  ContactForces forces;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Vec3& centre = pairs[k].first.position;
    const Vec3& other = pairs[k].second.position;
    forces.pairs.push_back({centre, other, known(on_pairs[k], centre - other)});
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Vec3& centre = state.particles.record[static_cast<std::size_t>(walls[k].particle)].position;
    const Vec3 branch = walls[k].distance * walls[k].normal;
    forces.walls.push_back({centre, centre - branch, known(on_walls[k], walls[k].normal)});
  }
  return forces;
}

}  // namespace repose::fields
