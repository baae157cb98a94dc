#pragma once

#include "contact/lanes.h"
// The laws find the arithmetic of lanes, which lanes.h declares.
#include "contact/general_law.h"
#include "contact/thesis_law.h"

namespace repose {

/// What the passes of the contact law hand on, by column.
struct LaneLaw {
  alignas(64) double contact_radius[block_lanes], spring[3][block_lanes], spring_length[block_lanes];
  alignas(64) double normal[block_lanes], tangential[block_lanes], normal_damping[block_lanes],
      tangential_damping[block_lanes];
  alignas(64) double moment[3][block_lanes], moment_size[block_lanes];
  alignas(64) double normal_force[block_lanes], sliding_share[block_lanes], sliding_damping[block_lanes],
      rolling_share[block_lanes];

  template <Lanes Real>
  [[gnu::always_inline]] BasicContactStiffness<Real> stiffness(int k) const {
    return {load<Real>(normal + k), load<Real>(tangential + k), load<Real>(normal_damping + k),
            load<Real>(tangential_damping + k)};
  }
  template <Lanes Real>
  [[gnu::always_inline]] void set_stiffness(int k, const BasicContactStiffness<Real>& stiffness) {
    store(stiffness.normal, normal + k);
    store(stiffness.tangential, tangential + k);
    store(stiffness.normal_damping, normal_damping + k);
    store(stiffness.tangential_damping, tangential_damping + k);
  }
};

/// Calls `body` with the law of the pair: the only choice that is compiled twice, so that options cost nothing where
/// there are none.
template <class Body>
auto with_law(const PairParameters& pair, const Body& body) {
  return follows_thesis(pair) ? body(ThesisLaw{}) : body(GeneralLaw{});
}

/// The contact law on every lane. Advances the histories of the block by `dt` s (0 leaves them as they are) and adds
/// forces and torques to the sums of the first bodies, and of the second ones if those are particles (`b` is not null).
/// Returns the difference that scatter collects.
template <class Law, Lanes Real>
[[gnu::always_inline]] inline std::uint64_t evaluate_law(const PairParameters& pair_in, double dt,
                                                         const LaneGeometry& lanes, const LaneBody& a,
                                                         const LaneBody* b, ContactBlock& block, ForceSum* sums) {
  const typename Law::Parameters pair = pair_in;  // a copy: its members cannot be what the loops write
  LaneLaw law;
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const BasicContactGeometry<Real> contact = lanes.get<Real>(k);
    const Vector3<Real> spring = Law::spring(pair, contact, dt, load<Real>(block.spring, k));
    store(contact_radius(contact), law.contact_radius + k);
    store(spring, law.spring, k);
    store(square_root(squared_norm(spring)), law.spring_length + k);
  }
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const BasicContactGeometry<Real> contact = lanes.get<Real>(k);
    const BasicContactStiffness<Real> stiffness = Law::stiffness(pair, contact, load<Real>(law.contact_radius + k));
    const Vector3<Real> moment = Law::moment(pair, stiffness, contact, dt, load<Real>(block.rolling, k));
    law.set_stiffness(k, stiffness);
    store(moment, law.moment, k);
    store(square_root(squared_norm(moment)), law.moment_size + k);
  }
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const BasicContactGeometry<Real> contact = lanes.get<Real>(k);
    const BasicContactStiffness<Real> stiffness = law.stiffness<Real>(k);
    const Real f_n = Law::normal_force(pair, stiffness, contact);
    const BasicSlidingLimit<Real> sliding = sliding_limit(pair, stiffness, f_n, load<Real>(law.spring_length + k));
    store(f_n, law.normal_force + k);
    store(sliding.share, law.sliding_share + k);
    store(sliding.damping, law.sliding_damping + k);
    store(rolling_limit(pair, contact, f_n, load<Real>(law.moment_size + k)), law.rolling_share + k);
  }
  LaneBits<Real> difference = {};
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const BasicContactGeometry<Real> contact = lanes.get<Real>(k);
    // Without overlap all stiffness is zero, and so is every force; only the histories have to be cut.
    const LaneInt<Real> touching = contact.overlap > Real{};
    const Vector3<Real> spring = load<Real>(law.sliding_share + k) * load<Real>(law.spring, k);
    const Vector3<Real> moment = where(touching, load<Real>(law.rolling_share + k) * load<Real>(law.moment, k));
    store(where(touching, spring), block.spring, k);
    store(moment, block.rolling, k);

    const Vector3<Real> friction =
        Law::friction(pair, law.stiffness<Real>(k), contact, spring, load<Real>(law.sliding_damping + k));
    const Vector3<Real> force = load<Real>(law.normal_force + k) * contact.normal + friction;
    const Vector3<Real> turn = cross(contact.normal, friction);
    const Vector3<Real> taken = load<Real>(a.arm + k) * turn + moment;
    scatter(to_fixed_point(force, load<Real>(a.force_scale + k)),
            to_fixed_point_negated(taken, load<Real>(a.torque_scale + k)), block.first + k, sums, difference);
    if (b == nullptr) continue;
    const Vector3<Real> given = moment - load<Real>(b->arm + k) * turn;
    scatter(to_fixed_point_negated(force, load<Real>(b->force_scale + k)),
            to_fixed_point(given, load<Real>(b->torque_scale + k)), block.second + k, sums, difference);
  }
  return any_bits(difference);
}

}  // namespace repose
