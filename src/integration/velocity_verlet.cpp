#include "integration/velocity_verlet.h"

#include <cmath>

#include "scene/materials.h"
#include "scene/sphere.h"

namespace repose {
namespace {

Vec3 to_vec3(const std::int64_t* sum) {
  return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

/// Greatest power of two p with p * value < 2^(fixed_point_bits - 1).
double scale_for(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);  // value < 2^exponent
  return std::ldexp(1.0, fixed_point_bits - 1 - exponent);
}

}  // namespace

void kick_half_step(const Vec3& gravity, double dt, Particles& particles) {
  const double half = 0.5 * dt;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    const ForceSum& sum = particles.sum[i];
    p.velocity += half * (particles.force_to_acceleration[i] * to_vec3(sum.force) + gravity);
    p.spin += half * (particles.torque_to_acceleration[i] * to_vec3(sum.torque));
  }
}

void drift(double dt, Particles& particles) {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    p.position += dt * p.velocity;
  }
}

void set_fixed_point_scales(const MaterialTable& materials, double max_overlap, Particles& particles) {
  constexpr double room = 4.0;  // for the dashpots, over the spring force at the greatest overlap
  particles.force_to_acceleration.resize(particles.owned);
  particles.torque_to_acceleration.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    const auto material = static_cast<std::size_t>(particles.material[i]);
    const double mass = sphere_mass(p.radius, materials[material].density);
    const double overlap = max_overlap * p.radius;
    const double force =
        room * 4.0 / 3.0 * materials.stiffest_partner(material) * std::sqrt(p.radius * overlap) * overlap;
    p.force_scale = scale_for(force);
    p.torque_scale = scale_for(force * p.radius);
    particles.force_to_acceleration[i] = 1.0 / (p.force_scale * mass);
    particles.torque_to_acceleration[i] = 1.0 / (p.torque_scale * sphere_inertia(mass, p.radius));
  }
}

}  // namespace repose
