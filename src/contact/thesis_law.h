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
  template <class Real, class Condition>
  [[gnu::always_inline]] static Real overlap(const Parameters&, const Real& gap, const Real&, const Condition&) {
    const Real none = {};
    return gap > none ? gap : none;
  }
  template <class Real>
  [[gnu::always_inline]] static auto touches(const BasicContactGeometry<Real>& contact) {
    return contact.overlap > Real{};
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> spring(const Parameters&, const BasicContactGeometry<Real>& contact,
                                                     double dt, const Vector3<Real>& spring) {
    return trial_spring(contact, dt, spring);
  }
  template <class Real>
  [[gnu::always_inline]] static Real contact_radius(const Parameters&, const BasicContactGeometry<Real>& contact) {
    return repose::contact_radius(contact);
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
    return trial_moment(epsd2_stiffness(k, contact), contact, dt, moment);
  }
  template <class Real>
  [[gnu::always_inline]] static Real normal_force(const Parameters&, const BasicContactStiffness<Real>& k,
                                                  const BasicContactGeometry<Real>& contact, const Real&) {
    return hertz_force(k, contact);
  }
  template <class Real>
  [[gnu::always_inline]] static Real with_cohesion(const Parameters&, const BasicContactGeometry<Real>&,
                                                   const Real& normal_force) {
    return normal_force;
  }
  template <class Real>
  [[gnu::always_inline]] static Real pressing_force(const Parameters&, const BasicContactStiffness<Real>&,
                                                    const BasicContactGeometry<Real>&, const Real& normal_force) {
    return normal_force;
  }
  template <class Real>
  [[gnu::always_inline]] static BasicSlidingLimit<Real> sliding(const Parameters& pair,
                                                                const BasicContactStiffness<Real>& k,
                                                                const BasicContactGeometry<Real>&,
                                                                const Real& pressing_force, const Real& length) {
    return sliding_limit(pair, k, pressing_force, length);
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> friction(const Parameters&, const BasicContactStiffness<Real>& k,
                                                       const BasicContactGeometry<Real>& contact,
                                                       const Vector3<Real>& spring, const Real& damping) {
    return mindlin_force(k, contact, spring, damping);
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> acting_moment(const Parameters&, const BasicContactStiffness<Real>&,
                                                            const BasicContactGeometry<Real>&,
                                                            const Vector3<Real>& moment, const Real&) {
    return moment;
  }
  template <class Real>
  [[gnu::always_inline]] static Vector3<Real> remembered(const Parameters&, const BasicContactGeometry<Real>&,
                                                         const Vector3<Real>& spring) {
    return spring;
  }
};

}  // namespace repose
