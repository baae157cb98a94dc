#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "deck/heat_keys.h"
#include "deck/key.h"

/// Materials and the contact law.
namespace repose {

struct MaterialDeck {
  std::string name;
  double youngs_modulus = unset;
  double poisson_ratio = unset;
  double density = unset;
  double conductivity = unset;  ///< [heat]: or heat_table
  double specific_heat = unset;
  HeatTableDeck heat_table = {};
  double emissivity = unset;
  double stiffness_ratio = 1.0;
};

template <class V>
void describe(V& v, MaterialDeck& m) {
  v("name", m.name, Unit::none, any_value, required, "name, used once: a letter, then letters, digits, _ or -");
  v("youngs_modulus", m.youngs_modulus, Unit::pascal, above(0), required, "Young's modulus");
  v("poisson_ratio", m.poisson_ratio, Unit::none, from_to_below(0, 0.5), required, "Poisson's ratio");
  v("density", m.density, Unit::density, above(0), required, "density of the solid");
  v("conductivity", m.conductivity, Unit::conductivity, above(0), optional_else("none; [heat] needs it or heat_table"),
    "thermal conductivity of the solid");
  v("specific_heat", m.specific_heat, Unit::specific_heat, above(0),
    optional_else("none; [heat] needs it or heat_table"), "of the solid");
  v("emissivity", m.emissivity, Unit::none, above_to(0, 1), optional_else("none; heat.radiation needs it"),
    "of the surface");
  v("stiffness_ratio", m.stiffness_ratio, Unit::none, above_to(0, 1), optional,
    "simulated over real Young's modulus: contacts conduct as if they were as wide as the real ones");
  v.section("heat_table", m.heat_table, optional, "thermal properties that depend on temperature");
}

/// The numbers of a pair of materials; the contact law sees them as they are (PairParameters).
struct PairCoefficients {
  double restitution = unset;
  double sliding_friction = unset;
  double rolling_friction = unset;
  double hooke_stiffness = unset;                ///< [contact] normal_law = hooke: k_n, N/m
  double hooke_tangential_ratio = 2.0 / 7.0;     ///< [contact] normal_law = hooke: k_t / k_n
  double hooke_damping_rate = unset;             ///< the same: c_n / m_eff, 1/s, in place of the restitution
  double hooke_tangential_damping_rate = unset;  ///< the same: c_t / m_eff, 1/s
  double work_of_adhesion = 0.0;                 ///< [contact] normal_law = jkr: W, J/m2
  double cohesion_energy_density = 0.0;          ///< [contact] cohesion = sjkr, sjkr2: Pa
  double surface_tension = 0.0;                  ///< [contact] cohesion = capillary: gamma, N/m
  double contact_angle = 0.0;                    ///< the same: theta, degrees
  double bridge_volume = 0.0;                    ///< the same: V, m3
  double rolling_viscous_damping = 0.0;          ///< [contact] rolling_model = epsd: eta
};

inline bool has_hooke_damping_rate(const PairCoefficients& pair) { return !std::isnan(pair.hooke_damping_rate); }

struct PairDeck : PairCoefficients {
  std::array<std::string, 2> materials;
};

template <class V>
void describe(V& v, PairDeck& p) {
  v("materials", p.materials, Unit::none, any_value, required, "the two materials, which may be the same");
  v("hooke_damping_rate", p.hooke_damping_rate, Unit::per_second, at_least(0),
    optional_else("none; from the restitution"),
    "normal damping over the effective mass, of normal_law = hooke, in place of the restitution");
  v("hooke_tangential_damping_rate", p.hooke_tangential_damping_rate, Unit::per_second, at_least(0),
    required.when(has_hooke_damping_rate(p), "hooke_damping_rate"),
    "tangential damping over the effective mass, with hooke_damping_rate");
  v("restitution", p.restitution, Unit::none, from_to(0, 1),
    required.when(!has_hooke_damping_rate(p), "no hooke_damping_rate"), "coefficient of restitution");
  v("sliding_friction", p.sliding_friction, Unit::none, at_least(0), required, "Coulomb's coefficient of friction");
  v("rolling_friction", p.rolling_friction, Unit::none, at_least(0), required, "coefficient of rolling friction");
  v("hooke_stiffness", p.hooke_stiffness, Unit::stiffness, above(0), optional_else("none; normal_law = hooke needs it"),
    "normal stiffness of normal_law = hooke");
  v("hooke_tangential_ratio", p.hooke_tangential_ratio, Unit::none, above_to(0, 10), optional,
    "tangential over normal stiffness of normal_law = hooke");
  v("work_of_adhesion", p.work_of_adhesion, Unit::stiffness, at_least(0), optional,
    "work of adhesion of normal_law = jkr, in J/m2 = N/m");
  v("cohesion_energy_density", p.cohesion_energy_density, Unit::pascal, at_least(0), optional,
    "attraction per area of cohesion = sjkr, sjkr2");
  v("surface_tension", p.surface_tension, Unit::stiffness, at_least(0), optional,
    "of the liquid, for cohesion = capillary");
  v("contact_angle", p.contact_angle, Unit::none, from_to(0, 90), optional,
    "between liquid and solid in degrees, for cohesion = capillary");
  v("bridge_volume", p.bridge_volume, Unit::volume, at_least(0), optional,
    "of one liquid bridge, for cohesion = capillary");
  v("rolling_viscous_damping", p.rolling_viscous_damping, Unit::none, from_to(0, 1), optional,
    "rolling dashpot of rolling_model = epsd, as a share of the critical damping");
}

enum class NormalLaw { hertz, hooke, jkr };
enum class TangentialSpring { projected, rotated, none };
enum class TangentialDamping { stiffness, normal, none };
enum class RollingModel { epsd2, epsd, cdt };
enum class RollingHistory { fixed, rotated };
enum class Cohesion { none, sjkr, sjkr2, capillary };
constexpr auto enumerators(NormalLaw) { return std::array<std::string_view, 3>{"hertz", "hooke", "jkr"}; }
constexpr auto enumerators(TangentialSpring) { return std::array<std::string_view, 3>{"projected", "rotated", "none"}; }
constexpr auto enumerators(TangentialDamping) { return std::array<std::string_view, 3>{"stiffness", "normal", "none"}; }
constexpr auto enumerators(RollingModel) { return std::array<std::string_view, 3>{"epsd2", "epsd", "cdt"}; }
constexpr auto enumerators(RollingHistory) { return std::array<std::string_view, 2>{"fixed", "rotated"}; }
constexpr auto enumerators(Cohesion) { return std::array<std::string_view, 4>{"none", "sjkr", "sjkr2", "capillary"}; }

/// The defaults are the contact law of the thesis.
struct ContactDeck {
  NormalLaw normal_law = NormalLaw::hertz;
  bool attraction = true;              ///< false: the normal force never pulls, and is damped to the same restitution
  bool restitution_correction = true;  ///< attraction = false: false leaves the damping as it is with attraction
  double hooke_characteristic_velocity = 0.0;  ///< m/s, normal_law = hooke: 0: the pairs have stiffnesses
  TangentialSpring tangential_spring = TangentialSpring::projected;
  TangentialDamping tangential_damping = TangentialDamping::stiffness;
  RollingModel rolling_model = RollingModel::epsd2;
  RollingHistory rolling_history = RollingHistory::fixed;
  Cohesion cohesion = Cohesion::none;
  bool cohesion_in_friction = false;  ///< whether the limits of friction know of the cohesion

  bool operator==(const ContactDeck&) const = default;
};

template <class V>
void describe(V& v, ContactDeck& c) {
  v("normal_law", c.normal_law, Unit::none, any_value, optional,
    "hertz: from the elastic constants; hooke: linear; jkr: Hertz with adhesion");
  v("hooke_characteristic_velocity", c.hooke_characteristic_velocity, Unit::speed, at_least(0),
    optional.when(c.normal_law == NormalLaw::hooke, "normal_law = hooke"),
    "impact speed at which the spring is as deep as Hertz's; 0: the pairs have a hooke_stiffness");
  v("attraction", c.attraction, Unit::none, any_value, optional,
    "whether the dashpot may pull as the surfaces part; false: damped anew to the same restitution");
  v("restitution_correction", c.restitution_correction, Unit::none, any_value,
    optional.when(!c.attraction, "attraction = false"), "false: not damped anew, so that they rebound faster");
  v("tangential_spring", c.tangential_spring, Unit::none, any_value, optional,
    "how the spring follows the normal: by its projection, or rotated with its length kept; none: a dashpot alone");
  v("tangential_damping", c.tangential_damping, Unit::none, any_value, optional,
    "dashpot: from the tangential stiffness, as large as the normal one, or none");
  v("rolling_model", c.rolling_model, Unit::none, any_value, optional,
    "epsd2: a spring with a limit; epsd: another spring with a dashpot; cdt: of constant size");
  v("rolling_history", c.rolling_history, Unit::none, any_value, optional,
    "how the rolling moment follows the normal: not, or rotated with its length kept");
  v("cohesion", c.cohesion, Unit::none, any_value, optional,
    "attraction beside the normal law: by the area in which the bodies cut (sjkr), linear in the overlap (sjkr2), or "
    "by "
    "liquid bridges, which hold beyond contact");
  v("cohesion_in_friction", c.cohesion_in_friction, Unit::none, any_value, optional,
    "whether the normal force that limits sliding and rolling counts the cohesion");
}

}  // namespace repose
