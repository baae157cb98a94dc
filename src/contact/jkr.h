#pragma once

#include "base/math.h"
#include "base/root.h"
#include "contact/hertz.h"

// Adhesion of elastic spheres (Johnson, Kendall, Roberts 1971, doi:10.1098/rspa.1971.0141), with a = s^2 the contact
// radius and c = sqrt(2 pi W / E_eff): delta = s^4 / R_eff - c s, F = 4/3 E_eff s^3 (s^3 / R_eff - 3/2 c). Surfaces
// that have touched hold together up to the greatest pull, F = -3/2 pi W R_eff at s^3 = 3/4 c R_eff; docs/theory.md,
// "JKR".

namespace repose {

/// m: how far apart surfaces that have touched may be pulled, (1/4) (3/4)^(1/3) (c R_eff)^(4/3) / R_eff.
template <class Real>
[[gnu::always_inline]] inline Real jkr_pull_off_distance(const PairParameters& pair, const Real& radius_eff) {
  const double c = pair.jkr_adhesion;
  if (c == 0.0) return Real{};
  constexpr double quarter_root = 0.22714002740438;
  const Real root = odd_root<3>(c * radius_eff);
  return quarter_root * (root * c);
}

/// a in m, 0 without contact: the greater root of x^4 - x = delta R_eff / (c R_eff)^(4/3), x = s / (c R_eff)^(1/3), by
/// Newton's method from above.
template <class Real>
[[gnu::always_inline]] inline Real jkr_contact_radius(const PairParameters& pair,
                                                      const BasicContactGeometry<Real>& contact) {
  const double c = pair.jkr_adhesion;
  if (c == 0.0) return contact_radius(contact);
  const Real root = odd_root<3>(c * contact.radius_eff);
  const Real depth = contact.overlap / (c * root);
  const Real pressed = select(depth > Real{}, depth, Real{});
  Real x = 1.0 + square_root(square_root(pressed));
  for (int k = 0; k < 8; ++k) {
    const Real x_3 = x * x * x;
    x = (3.0 * (x_3 * x) + depth) / (4.0 * x_3 - 1.0);
  }
  const Real s = x * root;
  return select(contact.overlap == Real{}, Real{}, s * s);
}

/// F in N without the dashpot, positive when repelling.
template <class Real>
[[gnu::always_inline]] inline Real jkr_force(const PairParameters& pair, const Real& radius_eff,
                                             const Real& contact_radius) {
  const Real s_3 = contact_radius * square_root(contact_radius);
  return (4.0 / 3.0 * pair.youngs_modulus_eff) * (s_3 * (s_3 / radius_eff - 1.5 * pair.jkr_adhesion));
}

/// J: the work of F from s = 0 on, 4/3 E_eff (2/5 s^10 / R_eff^2 - c s^7 / R_eff + 3/8 c^2 s^4).
inline double jkr_energy(const PairParameters& pair, double radius_eff, double contact_radius) {
  const double a_2 = contact_radius * contact_radius;
  const double h = a_2 * contact_radius * std::sqrt(contact_radius);  // s^7
  const double c = pair.jkr_adhesion;
  return 4.0 / 3.0 * pair.youngs_modulus_eff *
         (0.4 * h * contact_radius * std::sqrt(contact_radius) / (radius_eff * radius_eff) - c * h / radius_eff +
          0.375 * c * c * a_2);
}

/// N, positive: the greatest pull.
template <class Real>
[[gnu::always_inline]] inline Real jkr_pull_off_force(const PairParameters& pair, const Real& radius_eff) {
  return (1.5 * pi * pair.coefficients.work_of_adhesion) * radius_eff;
}

}  // namespace repose
