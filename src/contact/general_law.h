#pragma once

#include "contact/epsd2.h"
#include "contact/hooke.h"
#include "contact/mindlin.h"
#include "contact/rotation.h"

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

  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> spring(const PairParameters& pair,
                                                     const BasicContactGeometry<Real>& contact, double dt,
                                                     const Vector3<Real>& spring) {
    if (pair.options.tangential_spring == TangentialSpring::projected) return trial_spring(contact, dt, spring);
    return turned(pair, contact, broadcast<Real>(dt) * contact.tangential_velocity, spring);
  }

  template <class Real>
  [[gnu::always_inline]] static BasicContactStiffness<Real> stiffness(const PairParameters& pair,
                                                                      const BasicContactGeometry<Real>& contact,
                                                                      const Real& contact_radius) {
    if (pair.options.normal_law == NormalLaw::hooke) return hooke_stiffness(pair, contact);
    return hertz_stiffness(pair, contact, contact_radius);
  }

  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> moment(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                     const BasicContactGeometry<Real>& contact, double dt,
                                                     const Vector3<Real>& moment) {
    if (pair.options.rolling_history == RollingHistory::fixed) return trial_moment(k, contact, dt, moment);
    return turned(pair, contact, trial_moment(k, contact, dt, Vector3<Real>{}), moment);
  }

  /// The force of hertz.h, which Hooke's law shares; a NaN stays one.
  template <class Real>
  [[gnu::always_inline]] static Real normal_force(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                  const BasicContactGeometry<Real>& contact) {
    const Real force = hertz_force(k, contact);
    return pair.options.attraction ? force : select(force < Real{}, Real{}, force);
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
