#pragma once

#include "contact/mindlin.h"

namespace repose {

/// Tangential force without history: the dashpot alone, never more than Coulomb's limit (LIGGGHTS 3.8, "no_history";
/// Haff, Werner 1986, doi:10.1016/0032-5910(86)80048-1). As a sliding limit for mindlin_force with a spring of zero.
template <class Real>
[[gnu::always_inline]] inline BasicSlidingLimit<Real> viscous_limit(const ContactParameters& pair,
                                                                    const BasicContactStiffness<Real>& k,
                                                                    const BasicContactGeometry<Real>& contact,
                                                                    const std::type_identity_t<Real>& normal_force) {
  const Real speed = square_root(squared_norm(contact.tangential_velocity));
  const Real limit = pair.sliding_friction * magnitude(normal_force);
  const auto slides = k.tangential_damping * speed > limit;
  return {broadcast<Real>(1.0), select(slides, limit / speed, k.tangential_damping)};
}

}  // namespace repose
