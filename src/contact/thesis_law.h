#pragma once

#include "contact/epsd2.h"
#include "contact/hertz.h"
#include "contact/mindlin.h"

namespace repose {

/// The contact law of the thesis: Hertz normal, Mindlin tangential, EPSD2 rolling. Each function is what one pass of
/// evaluate_law needs; GeneralLaw has the same.
struct ThesisLaw {
  using Parameters = ContactParameters;
  static constexpr bool has_options = false;

  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> velocity_normal(const Parameters&, double, const Vector3<Real>&,
                                                              const Vector3<Real>&, const Vector3<Real>& normal) {
    return normal;
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> spring(const Parameters&, const BasicContactGeometry<Real>& contact,
                                                     double dt, const Vector3<Real>& spring) {
    return trial_spring(contact, dt, spring);
  }
  template <class Real>
  [[gnu::always_inline]] static BasicContactStiffness<Real> stiffness(const Parameters& pair,
                                                                      const BasicContactGeometry<Real>& contact,
                                                                      const Real& contact_radius) {
    return hertz_stiffness(pair, contact, contact_radius);
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> moment(const Parameters&, const BasicContactStiffness<Real>& k,
                                                     const BasicContactGeometry<Real>& contact, double dt,
                                                     const Vector3<Real>& moment) {
    return trial_moment(k, contact, dt, moment);
  }
  template <class Real>
  [[gnu::always_inline]] static Real normal_force(const Parameters&, const BasicContactStiffness<Real>& k,
                                                  const BasicContactGeometry<Real>& contact) {
    return hertz_force(k, contact);
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> friction(const Parameters&, const BasicContactStiffness<Real>& k,
                                                       const BasicContactGeometry<Real>& contact,
                                                       const Vector3<Real>& spring, const Real& damping) {
    return mindlin_force(k, contact, spring, damping);
  }
};

}  // namespace repose
