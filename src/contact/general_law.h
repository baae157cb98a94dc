#pragma once

#include "contact/capillary.h"
#include "contact/cdt.h"
#include "contact/epsd.h"
#include "contact/hooke.h"
#include "contact/jkr.h"
#include "contact/rotation.h"
#include "contact/sjkr.h"
#include "contact/viscous_friction.h"

namespace repose {

/// The contact law with the options of [contact] and time.integrator (docs/theory.md, "Options"). They are the same for
/// all lanes, so that their branches cost little beside the roots and divisions.
struct GeneralLaw {
  using Parameters = PairParameters;
  static constexpr bool has_options = true;

  /// The normal to which velocities refer. `apart` (m) is from the second body to the first, `velocity` (m/s) the
  /// first's relative to the second. Synchronised: half a step ago, when the velocities hold (Vyas and others 2025,
  /// doi:10.1016/j.cpc.2025.109524).
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> velocity_normal(const PairParameters& pair, double dt,
                                                              const Vector3<Real>& apart, const Vector3<Real>& velocity,
                                                              const Vector3<Real>& normal) {
    if (!pair.synchronised) return normal;
    const Vector3<Real> halfway = apart - broadcast<Real>(0.5 * dt) * velocity;
    return (1.0 / square_root(squared_norm(halfway))) * halfway;
  }

  /// What the contact has of `gap` m between overlapping surfaces (negative: they are apart): the gap while it is
  /// positive, or while surfaces that have touched (`remembers`) are held together; else 0. One that is held at a gap
  /// of exactly 0 gets the least number.
  template <class Real, class Condition>
  [[gnu::always_inline]] static Real overlap(const PairParameters& pair, const Real& gap, const Real& radius_eff,
                                             const Condition& remembers) {
    const Real overlap = select(gap > Real{}, gap, Real{});
    if (!adheres(pair)) return overlap;
    const auto held = remembers & (gap >= -holding_distance(pair, radius_eff));
    const Real pulled = select(gap == Real{}, broadcast<Real>(1e-300), gap);
    return select(held, pulled, overlap);
  }
  /// m: how far apart surfaces that have touched may be pulled.
  template <class Real>
  [[gnu::always_inline]] static Real holding_distance(const PairParameters& pair, const Real& radius_eff) {
    if (pair.options.normal_law == NormalLaw::jkr) return jkr_pull_off_distance(pair, radius_eff);
    return broadcast<Real>(pair.capillary.breaking_distance);
  }
  template <class Real>
  [[gnu::always_inline]] static auto touches(const BasicContactGeometry<Real>& contact) {
    return contact.overlap != Real{};
  }

  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> spring(const PairParameters& pair,
                                                     const BasicContactGeometry<Real>& contact, double dt,
                                                     const Vector3<Real>& spring) {
    if (pair.options.tangential_spring == TangentialSpring::none) return {};
    if (pair.options.tangential_spring == TangentialSpring::projected) return trial_spring(contact, dt, spring);
    return turned(pair, contact, broadcast<Real>(dt) * contact.tangential_velocity, spring);
  }

  template <class Real>
  [[gnu::always_inline]] static Real contact_radius(const PairParameters& pair,
                                                    const BasicContactGeometry<Real>& contact_in) {
    if (pair.options.normal_law == NormalLaw::jkr) return jkr_contact_radius(pair, contact_in);
    BasicContactGeometry<Real> contact = contact_in;
    contact.overlap = select(contact.overlap < Real{}, Real{}, contact.overlap);  // a bridge presses on nothing
    return repose::contact_radius(contact);
  }

  template <class Real>
  [[gnu::always_inline]] static BasicContactStiffness<Real> stiffness(const PairParameters& pair,
                                                                      const BasicContactGeometry<Real>& contact,
                                                                      const Real& contact_radius) {
    if (pair.options.normal_law == NormalLaw::hooke) return hooke_stiffness(pair, contact);
    return hertz_stiffness(pair, contact, contact_radius);
  }

  /// Of the rolling moment's spring, in N m.
  template <class Real>
  [[gnu::always_inline]] static Real rolling_stiffness(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                       const BasicContactGeometry<Real>& contact) {
    if (pair.options.rolling_model == RollingModel::epsd) return epsd_stiffness(pair, k, contact);
    return epsd2_stiffness(k, contact);
  }

  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> moment(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                     const BasicContactGeometry<Real>& contact, double dt,
                                                     const Vector3<Real>& moment) {
    if (pair.options.rolling_model == RollingModel::cdt) return {};
    const Real k_r = rolling_stiffness(pair, k, contact);
    if (pair.options.rolling_history == RollingHistory::fixed) return trial_moment(k_r, contact, dt, moment);
    return turned(pair, contact, trial_moment(k_r, contact, dt, Vector3<Real>{}), moment);
  }

  /// The normal law's force in N, dashpot included; a NaN stays one.
  template <class Real>
  [[gnu::always_inline]] static Real normal_force(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                  const BasicContactGeometry<Real>& contact,
                                                  const Real& contact_radius) {
    if (pair.options.normal_law == NormalLaw::jkr) {
      return jkr_force(pair, contact.radius_eff, contact_radius) - k.normal_damping * contact.normal_velocity;
    }
    const Real force = hertz_force(k, contact);
    return pair.options.attraction ? force : select(force < Real{}, Real{}, force);
  }

  /// The force in N that acts along the normal where the normal law gives `normal_force`.
  template <class Real>
  [[gnu::always_inline]] static Real with_cohesion(const PairParameters& pair,
                                                   const BasicContactGeometry<Real>& contact,
                                                   const Real& normal_force) {
    if (pair.options.cohesion == Cohesion::none) return normal_force;
    if (pair.options.cohesion == Cohesion::capillary) return normal_force - capillary_pull(pair, contact);
    return normal_force - pair.coefficients.cohesion_energy_density * contact.cohesive_area;
  }

  /// The force in N whose magnitude limits sliding and rolling. With JKR it is the force without its dashpot and twice
  /// the pull-off force (Thornton 1991, doi:10.1088/0022-3727/24/11/007).
  template <class Real>
  [[gnu::always_inline]] static Real pressing_force(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                    const BasicContactGeometry<Real>& contact,
                                                    const Real& normal_force) {
    if (pair.options.normal_law == NormalLaw::jkr) {
      const Real pull = select(touches(contact), 2.0 * jkr_pull_off_force(pair, contact.radius_eff), Real{});
      return normal_force + k.normal_damping * contact.normal_velocity + pull;
    }
    if (!pair.options.cohesion_in_friction) return normal_force;
    return select(contact.overlap > Real{}, with_cohesion(pair, contact, normal_force), normal_force);
  }

  template <class Real>
  [[gnu::always_inline]] static BasicSlidingLimit<Real> sliding(const PairParameters& pair,
                                                                const BasicContactStiffness<Real>& k,
                                                                const BasicContactGeometry<Real>& contact,
                                                                const Real& pressing_force, const Real& length) {
    if (pair.options.tangential_spring == TangentialSpring::none) {
      return viscous_limit(pair, k, contact, pressing_force);
    }
    return sliding_limit(pair, k, pressing_force, length);
  }

  /// The dashpot's velocity, which may belong to the plane of half a step ago, acts in that of the force.
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> friction(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                       const BasicContactGeometry<Real>& contact_in,
                                                       const Vector3<Real>& spring, const Real& damping) {
    BasicContactGeometry<Real> contact = contact_in;
    if (pair.synchronised)
      contact.tangential_velocity = without_normal_part(contact.tangential_velocity, contact.normal);
    return mindlin_force(k, contact, spring, damping);
  }

  /// The moment in N m that acts where the spring's is `moment`, after the limit has left `share` of it.
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> acting_moment(const PairParameters& pair,
                                                            const BasicContactStiffness<Real>& k,
                                                            const BasicContactGeometry<Real>& contact,
                                                            const Vector3<Real>& moment, const Real& share) {
    if (pair.options.rolling_model == RollingModel::cdt) return cdt_moment(pair, k, contact);
    if (pair.options.rolling_model == RollingModel::epsd2) return moment;
    const Real c_r = epsd_damping(pair, epsd_stiffness(pair, k, contact), contact);
    return moment + select(share < broadcast<Real>(1.0), Real{}, c_r) * contact.rolling_velocity;
  }

  /// The spring to remember: where surfaces adhere it is never all zero bits while they touch, which is how the next
  /// step knows that they have touched. A liquid bridge holds no spring.
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> remembered(const PairParameters& pair,
                                                         const BasicContactGeometry<Real>& contact,
                                                         const Vector3<Real>& spring) {
    if (!adheres(pair)) return spring;
    const bool is_jkr = pair.options.normal_law == NormalLaw::jkr;
    const Real kept = select(is_jkr ? touches(contact) : contact.overlap > Real{}, broadcast<Real>(1.0), Real{});
    const Vector3<Real> held = kept * spring;
    return {select(touches(contact) & (held.x == Real{}), broadcast<Real>(-0.0), held.x), held.y, held.z};
  }

 private:
  /// A history rotated into the plane of the velocities, advanced by `increment` there, and rotated into the present
  /// one.
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> turned(const PairParameters& pair,
                                                     const BasicContactGeometry<Real>& contact,
                                                     const Vector3<Real>& increment, const Vector3<Real>& history) {
    const Vector3<Real> advanced = rotated_into_plane(history, contact.velocity_normal) + increment;
    return pair.synchronised ? rotated_into_plane(advanced, contact.normal) : advanced;
  }
};

}  // namespace repose
