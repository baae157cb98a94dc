#include "measurement/contact_forces.h"

#include <array>
#include <limits>
#include <map>

#include "contact/pair_loop.h"
#include "measurement/force_sum.h"
#include "neighbours/pair_lists.h"

namespace repose {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// s; see `moment`, but so short that the forces on a particle add up to that of the run to the last digits.
constexpr double instant = 1e-16;

/// Which contacts follow the same law, by two indices that say which.
using OfLaw = std::map<std::array<std::int32_t, 2>, std::vector<std::int32_t>>;

/// Those of one law.
void evaluate(VectorLevel level, const PairParameters& law, std::span<const TouchingPair> pairs,
              std::span<const std::int32_t> chosen, std::vector<Vec3>& forces, ContactAlarms& alarms) {
  Particles copies;
  for (const std::int32_t k : chosen) {
    copies.record.push_back(pairs[static_cast<std::size_t>(k)].first);
    copies.record.push_back(pairs[static_cast<std::size_t>(k)].second);
  }
  const auto dummy = static_cast<std::int32_t>(copies.record.size());
  add_lane_dummies(copies);
  std::vector<ContactBlock> blocks(blocks_for(chosen.size()));
  for (std::size_t lane = 0; lane < block_lanes * blocks.size(); ++lane) {
    ContactBlock& block = blocks[lane / block_lanes];
    const std::size_t slot = lane % block_lanes;
    const bool is_used = lane < chosen.size();
    block.first[slot] = is_used ? static_cast<std::int32_t>(2 * lane) : dummy;
    block.second[slot] = block.first[slot] + 1;
    set_history(block, slot, is_used ? pairs[static_cast<std::size_t>(chosen[lane])].history : ContactHistory{});
  }
  alarms += evaluate_pairs(level, blocks, law, instant, no_bound, copies.record.data(), copies.sum.data());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    forces[static_cast<std::size_t>(chosen[k])] = force_of(copies.sum[2 * k], copies.record[2 * k]);
  }
}

}  // namespace

std::vector<Vec3> pair_contact_forces(VectorLevel level, const MaterialTable& materials,
                                      std::span<const TouchingPair> pairs, ContactAlarms& alarms) {
  OfLaw of_law;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    of_law[{pairs[k].material_first, pairs[k].material_second}].push_back(static_cast<std::int32_t>(k));
  }
  std::vector<Vec3> forces(pairs.size());
  for (const auto& [of, chosen] : of_law) {
    const PairParameters& law = materials.pair(static_cast<std::size_t>(of[0]), static_cast<std::size_t>(of[1]));
    evaluate(level, law, pairs, chosen, forces, alarms);
  }
  return forces;
}

std::vector<Vec3> wall_contact_forces(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials,
                                      const Particles& particles, std::vector<WallContact> contacts,
                                      ContactAlarms& alarms) {
  BigVector<ParticleRecord> records;
  OfLaw of_law;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts[k].particle);
    records.push_back(particles.record[i]);
    records.back().position = particles.position(i);
    of_law[{particles.material[i], contacts[k].wall}].push_back(static_cast<std::int32_t>(k));
    contacts[k].particle = static_cast<std::int32_t>(k);
  }
  BigVector<ForceSum> sums(records.size());
  for (const auto& [of, chosen] : of_law) {
    const WallLaw law = wall_law(materials, of[0], walls[static_cast<std::size_t>(of[1])], instant, no_bound);
    alarms += evaluate_walls(level, law, contacts, chosen, records.data(), sums.data());
  }
  std::vector<Vec3> forces;
  for (std::size_t k = 0; k < contacts.size(); ++k) forces.push_back(force_of(sums[k], records[k]));
  return forces;
}

}  // namespace repose
