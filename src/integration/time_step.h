#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "deck/deck.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/materials.h"

namespace repose {

/// Time in s that a Rayleigh wave takes over a sphere (thesis eq. 2.24).
double rayleigh_time(double radius, const Material& material);

/// Duration in s of a Hertz impact at `speed` m/s (thesis eq. 2.25 with effective quantities).
double hertz_time(double radius_eff, double mass_eff, double youngs_modulus_eff, double speed);

/// Shortest half period in s of the springs of Hooke's law: pi sqrt(m_eff / k_n), the duration of an undamped impact,
/// or that of the tangential spring, pi sqrt(2/7 m_eff / k_t), where k_t exceeds 2/7 k_n (Silbert and others 2001,
/// doi:10.1103/PhysRevE.64.051302).
double hooke_time(double mass_eff, double stiffness, double tangential_ratio);

/// Longest step in s with dashpots of these rates (1/s, hooke_damping_rate and hooke_tangential_damping_rate): half of
/// the time in which the faster one alone takes a velocity away, 1 / gamma_n or 2/7 / gamma_t. A given step may be four
/// times that: forces take velocities of half a step ago, so that beyond it a dashpot drives what it should brake.
double damping_limit(double normal_rate, double tangential_rate);

/// Number of steps that cover `time` s, rounded to the nearest; 2e18 at the most, of which some can be added up.
std::int64_t steps_for(double time, double timestep);

/// Speed in m/s that the deck expects at most: given, or the greatest that any particle can reach in free fall along
/// gravity from where and as fast as it starts, or will be poured, to the far side of the domain, or that a wall or a
/// particle on a prescribed path has.
double expected_speed(const Deck& deck, const NewParticles& particles, const std::vector<Pour>& pours);

/// The time step and what limits it, all in s: by the shares of the Rayleigh time of the worst particle and of the
/// Hertz time of the worst pair at the expected speed, or, with Hooke's law, of the Hooke time of the worst pair and by
/// the fastest damping rate. What does not limit it is infinite.
struct TimeStep {
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  double step = 0.0;
  double rayleigh_limit = infinite;
  double hertz_limit = infinite;
  double hertz_limit_at_1 = infinite;  ///< at 1 m/s (it scales as speed^-1/5)
  double hooke_limit = infinite;
  double damping_limit = infinite;
  double speed = 0.0;     ///< m/s, expected
  std::string criterion;  ///< "rayleigh", "hertz", "hooke", "damping" or "given"
};

/// Smallest radius of the particles of each material; infinity where there are none. Materials behind the last entry
/// have none.
struct SmallestRadii {
  std::vector<double> of_material;
};

/// Chooses the time step (thesis section 2.4), or checks the given one: DeckError when it exceeds a limit, naming it,
/// or when there is neither a given one nor a limit.
TimeStep choose_time_step(const Deck& deck, const MaterialTable& materials, const SmallestRadii& radii, double speed);

/// The step over the tighter of both limits at the true greatest speed (m/s): above 1 the criteria are violated.
double time_step_excess(const TimeStep& step, double speed);

/// The speed (m/s) up to which the criteria are violated by this excess or less; infinity when they do not depend on
/// it.
double greatest_speed(const TimeStep& step, double excess);

}  // namespace repose
