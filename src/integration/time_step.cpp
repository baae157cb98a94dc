#include "integration/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "scene/particles/hooke_spring.h"
#include "scene/particles/sphere_mass.h"
#include "scene/walls/motion.h"

namespace repose {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double power_fifth(double x) { return x * x * x * x * x; }

/// Shortest Rayleigh time of all particles that move.
double shortest_rayleigh_time(const MaterialTable& materials, const SmallestRadii& radii) {
  double shortest = infinite;
  for (std::size_t m = 0; m < radii.of_material.size(); ++m) {
    if (radii.of_material[m] < infinite && !materials.is_held(static_cast<std::int32_t>(m))) {
      shortest = std::min(shortest, rayleigh_time(radii.of_material[m], materials[m]));
    }
  }
  return shortest;
}

/// Least value of time(pair, radius_eff, mass_eff) for all particles with one another and with every material they have
/// a pair with.
template <class Time>
double shortest_contact_time(const MaterialTable& materials, const SmallestRadii& radii, const Time& time) {
  double shortest = infinite;
  for (std::size_t a = 0; a < radii.of_material.size(); ++a) {
    const double radius = radii.of_material[a];
    if (!(radius < infinite) || materials.is_held(static_cast<std::int32_t>(a))) continue;
    const double mass = sphere_mass(radius, materials[a].density);
    for (std::size_t b = 0; b < materials.size(); ++b) {
      const PairParameters& pair = materials.pair(a, b);
      if (pair.youngs_modulus_eff <= 0.0) continue;
      shortest = std::min(shortest, time(pair, radius, mass));  // at a wall
      const double other = b < radii.of_material.size() ? radii.of_material[b] : infinite;
      if (!(other < infinite)) continue;
      const double other_mass = sphere_mass(other, pair.density_second);
      shortest =
          std::min(shortest, time(pair, radius * other / (radius + other), mass * other_mass / (mass + other_mass)));
    }
  }
  return shortest;
}

double shortest_hertz_time(const MaterialTable& materials, const SmallestRadii& radii, double speed) {
  return shortest_contact_time(materials, radii,
                               [speed](const PairParameters& pair, double radius_eff, double mass_eff) {
                                 return hertz_time(radius_eff, mass_eff, pair.youngs_modulus_eff, speed);
                               });
}

double shortest_hooke_time(const MaterialTable& materials, const SmallestRadii& radii) {
  return shortest_contact_time(materials, radii, [](const PairParameters& pair, double radius_eff, double mass_eff) {
    return hooke_time(mass_eff, hooke_normal_stiffness(pair, radius_eff, mass_eff),
                      pair.coefficients.hooke_tangential_ratio);
  });
}

double shortest_damping_limit(const MaterialTable& materials, const SmallestRadii& radii) {
  return shortest_contact_time(materials, radii, [](const PairParameters& pair, double, double) {
    const PairCoefficients& c = pair.coefficients;
    return has_hooke_damping_rate(c) ? damping_limit(c.hooke_damping_rate, c.hooke_tangential_damping_rate) : infinite;
  });
}

TimeStep limits_of(const Deck& deck, const MaterialTable& materials, const SmallestRadii& radii, double speed) {
  TimeStep limits;
  limits.speed = speed;
  if (deck.contact.normal_law == NormalLaw::hooke) {
    limits.hooke_limit = deck.time.hooke_fraction * shortest_hooke_time(materials, radii);
    limits.damping_limit = shortest_damping_limit(materials, radii);
  } else {
    limits.rayleigh_limit = deck.time.rayleigh_fraction * shortest_rayleigh_time(materials, radii);
    limits.hertz_limit = deck.time.hertz_fraction * shortest_hertz_time(materials, radii, speed);
    limits.hertz_limit_at_1 = deck.time.hertz_fraction * shortest_hertz_time(materials, radii, 1.0);
  }
  return limits;
}

/// What limits the step: its name, the limit in words and in s.
struct Criterion {
  std::string name;
  std::string text;
  double limit;
};

Criterion tightest(const TimeDeck& time, const TimeStep& limits) {
  const bool is_given = !std::isnan(time.step);
  const auto share = [](double fraction, const char* title) {
    return fmt::format("{:.0f} % of the {} time", 100.0 * fraction, title);
  };
  const Criterion all[] = {
      {"hertz", share(time.hertz_fraction, "Hertz"), limits.hertz_limit},
      {"rayleigh", share(time.rayleigh_fraction, "Rayleigh"), limits.rayleigh_limit},
      {"hooke", share(time.hooke_fraction, "Hooke"), limits.hooke_limit},
      {"damping",
       fmt::format("{} the time in which the faster damping rate of a [[pair]] (the tangential one times 7/2) takes a "
                   "velocity away",
                   is_given ? "twice" : "half of"),
       is_given ? 4.0 * limits.damping_limit : limits.damping_limit}};
  return *std::min_element(std::begin(all), std::end(all),
                           [](const Criterion& a, const Criterion& b) { return a.limit < b.limit; });
}

/// The greatest speed that walls and particles on prescribed paths have.
double driven_speed(const Deck& deck) {
  double speed = 0.0;
  for (const WallDeck& wall : deck.walls) speed = std::max(speed, greatest_speed(wall, deck.domain));
  for (const ParticlesDeck& block : deck.particles) speed = std::max(speed, greatest_speed(block.motions, deck.domain));
  return speed;
}

}  // namespace

double rayleigh_time(double radius, const Material& material) {
  const double shear_modulus = material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
  return pi * radius * std::sqrt(material.density / shear_modulus) / (0.1631 * material.poisson_ratio + 0.8766);
}

double hertz_time(double radius_eff, double mass_eff, double youngs_modulus_eff, double speed) {
  return 2.87 * fifth_root(mass_eff * mass_eff / (radius_eff * youngs_modulus_eff * youngs_modulus_eff * speed));
}

double hooke_time(double mass_eff, double stiffness, double tangential_ratio) {
  return pi * std::sqrt(mass_eff / (stiffness * std::max(1.0, 3.5 * tangential_ratio)));
}

double damping_limit(double normal_rate, double tangential_rate) {
  return 0.5 / std::max(normal_rate, 3.5 * tangential_rate);
}

std::int64_t steps_for(double time, double timestep) {
  constexpr double most = 2e18;
  return static_cast<std::int64_t>(std::clamp(std::rint(time / timestep), 0.0, most));
}

double expected_speed(const Deck& deck, const NewParticles& particles, const std::vector<Pour>& pours) {
  if (!std::isnan(deck.time.expected_speed)) return deck.time.expected_speed;
  const double driven = driven_speed(deck);
  const Vec3 g = deck.gravity;
  const auto& [min, max, periodic] = deck.domain;
  const Vec3 lowest = {g.x > 0.0 ? max.x : min.x, g.y > 0.0 ? max.y : min.y, g.z > 0.0 ? max.z : min.z};
  const double across = norm(max - min);
  const auto fall = [&](const Vec3& from) {      // g times height
    return deck.tilt.enabled ? norm(g) * across  // gravity may come to point anywhere
                             : dot(g, lowest - from);
  };
  double greatest_square = std::max(1e-6, driven * driven);  // nothing moves by itself: 1 mm/s
  for (std::size_t i = 0; i < particles.size(); ++i) {
    greatest_square =
        std::max(greatest_square, squared_norm(particles.velocity[i]) + 2.0 * fall(particles.position[i]));
  }
  for (const Pour& pour : pours) {
    const auto& [bottom, top] = pour.bounds;
    const Vec3 highest = {g.x > 0.0 ? bottom.x : top.x, g.y > 0.0 ? bottom.y : top.y, g.z > 0.0 ? bottom.z : top.z};
    greatest_square = std::max(greatest_square, squared_norm(pour.deck.velocity) + 2.0 * fall(highest));
  }
  return std::sqrt(greatest_square);
}

TimeStep choose_time_step(const Deck& deck, const MaterialTable& materials, const SmallestRadii& radii, double speed) {
  TimeStep result = limits_of(deck, materials, radii, speed);
  const Criterion tight = tightest(deck.time, result);
  if (std::isnan(deck.time.step)) {
    if (!(tight.limit < infinite)) {
      throw DeckError(
          "time.step is missing: no particle of the deck is free to move, so that nothing limits the time step");
    }
    result.step = tight.limit;
    result.criterion = tight.name;
    return result;
  }
  result.step = deck.time.step;
  result.criterion = "given";
  if (result.step > tight.limit) {
    throw DeckError(
        fmt::format("time.step = {:.4g} s is too long: {} is {:.4g} s{}; shorten it, or leave time.step out",
                    result.step, tight.text, tight.limit,
                    tight.name == "hertz" ? fmt::format(" at the expected speed of {:.3g} m/s", speed) : ""));
  }
  return result;
}

double time_step_excess(const TimeStep& step, double speed) {
  if (step.hooke_limit < infinite) return step.step / step.hooke_limit;
  // t_hertz ~ speed^-1/5, so (dt / limit)^5 = (dt / limit at 1 m/s)^5 speed
  const double hertz = fifth_root(power_fifth(step.step / step.hertz_limit_at_1) * std::max(speed, 1e-12));
  return std::max(hertz, step.step / step.rayleigh_limit);
}

double greatest_speed(const TimeStep& step, double excess) {
  if (step.hooke_limit < infinite) return infinite;
  return power_fifth(excess * step.hertz_limit_at_1 / step.step);
}

}  // namespace repose
