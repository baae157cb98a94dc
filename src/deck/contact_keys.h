#pragma once

#include <array>
#include <string>
#include <string_view>

#include "deck/key.h"

/// Materials and the contact law.
namespace repose {

struct MaterialDeck {
  std::string name;
  double youngs_modulus = unset;
  double poisson_ratio = unset;
  double density = unset;
};

template <class V>
void describe(V& v, MaterialDeck& m) {
  v("name", m.name, Unit::none, any_value, required, "name, used once: a letter, then letters, digits, _ or -");
  v("youngs_modulus", m.youngs_modulus, Unit::pascal, above(0), required, "Young's modulus");
  v("poisson_ratio", m.poisson_ratio, Unit::none, from_to_below(0, 0.5), required, "Poisson's ratio");
  v("density", m.density, Unit::density, above(0), required, "density of the solid");
}

/// The numbers of a pair of materials; the contact law sees them as they are (PairParameters).
struct PairCoefficients {
  double restitution = unset;
  double sliding_friction = unset;
  double rolling_friction = unset;
  double hooke_stiffness = unset;             ///< [contact] normal_law = hooke: k_n, N/m
  double hooke_tangential_ratio = 2.0 / 7.0;  ///< [contact] normal_law = hooke: k_t / k_n
};

struct PairDeck : PairCoefficients {
  std::array<std::string, 2> materials;
};

template <class V>
void describe(V& v, PairDeck& p) {
  v("materials", p.materials, Unit::none, any_value, required, "the two materials, which may be the same");
  v("restitution", p.restitution, Unit::none, from_to(0, 1), required, "coefficient of restitution");
  v("sliding_friction", p.sliding_friction, Unit::none, at_least(0), required, "Coulomb's coefficient of friction");
  v("rolling_friction", p.rolling_friction, Unit::none, at_least(0), required,
    "coefficient of rolling friction (EPSD2)");
  v("hooke_stiffness", p.hooke_stiffness, Unit::stiffness, above(0), optional_else("none; normal_law = hooke needs it"),
    "normal stiffness of normal_law = hooke");
  v("hooke_tangential_ratio", p.hooke_tangential_ratio, Unit::none, above_to(0, 10), optional,
    "tangential over normal stiffness of normal_law = hooke");
}

enum class NormalLaw { hertz, hooke };
enum class TangentialSpring { projected, rotated };
enum class RollingHistory { fixed, rotated };
constexpr auto enumerators(NormalLaw) { return std::array<std::string_view, 2>{"hertz", "hooke"}; }
constexpr auto enumerators(TangentialSpring) { return std::array<std::string_view, 2>{"projected", "rotated"}; }
constexpr auto enumerators(RollingHistory) { return std::array<std::string_view, 2>{"fixed", "rotated"}; }

/// The defaults are the contact law of the thesis.
struct ContactDeck {
  NormalLaw normal_law = NormalLaw::hertz;
  bool attraction = true;  ///< false: the normal force never pulls, and is damped to the same restitution
  TangentialSpring tangential_spring = TangentialSpring::projected;
  RollingHistory rolling_history = RollingHistory::fixed;

  bool operator==(const ContactDeck&) const = default;
};

template <class V>
void describe(V& v, ContactDeck& c) {
  v("normal_law", c.normal_law, Unit::none, any_value, optional, "hertz: from the elastic constants; hooke: linear");
  v("attraction", c.attraction, Unit::none, any_value, optional,
    "whether the dashpot may pull as the surfaces part; false: damped anew to the same restitution");
  v("tangential_spring", c.tangential_spring, Unit::none, any_value, optional,
    "how the spring follows the normal: by its projection, or rotated with its length kept");
  v("rolling_history", c.rolling_history, Unit::none, any_value, optional,
    "how the rolling moment follows the normal: not, or rotated with its length kept");
}

}  // namespace repose
