#include "measurement/tilt_onset.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace repose {
namespace {

/// A difference of positions that are known up to a length in each direction (0: exactly).
Vec3 nearest_image(const Vec3& difference, const Vec3& length) {
  const auto along = [](double d, double period) { return period > 0.0 ? d - period * std::round(d / period) : d; };
  return {along(difference.x, length.x), along(difference.y, length.y), along(difference.z, length.z)};
}

}  // namespace

void TiltOnset::sample(const Communicator& comm, const Particles& particles, double tilt) {
  if (onset_) return;
  // Position, radius, that it is there, material, blocked rotation: known to the rank that owns the particle.
  std::array<double, 7> seen = {};
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (particles.id[i] != deck_.particle || is_parked(p)) continue;
    const Vec3 x = particles.position(i);
    const double blocked = particles.torque_to_acceleration[i] == 0.0 ? 1.0 : 0.0;
    seen = {x.x, x.y, x.z, p.radius, 1.0, static_cast<double>(particles.material[i]), blocked};
  }
  comm.sum_elements(std::span(seen.begin(), seen.end()));
  if (seen[4] == 0.0) return;
  const Vec3 position = {seen[0], seen[1], seen[2]};
  if (!start_) {
    start_ = position;
    material_ = static_cast<std::size_t>(seen[5]);
    cannot_turn_ = seen[6] != 0.0;
    bound_ = std::isnan(deck_.displacement) ? 1e-3 * seen[3] : deck_.displacement;
  }
  const double way = norm(nearest_image(position - *start_, particles.periodic.length()));
  if (way > bound_) {
    onset_ = last_tilt_ + (tilt - last_tilt_) * (bound_ - last_way_) / (way - last_way_);
    return;
  }
  last_tilt_ = tilt;
  last_way_ = way;
}

double extrapolated_onset(double at_rate, double at_slower_rate, double slower) {
  const double delay = std::pow(slower, 2.0 / 3.0);  // of the slower rate, over that of the other
  return (at_slower_rate - delay * at_rate) / (1.0 - delay);
}

}  // namespace repose
