#include "scene/walls/servo.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/interpolate.h"
#include "scene/walls/unit_vector.h"

namespace repose {

Servo::Servo(const ServoDeck& deck) : deck_(deck), direction_(unit_vector(deck.direction)) {}

void Servo::begin_phase(const std::string& phase) {
  const std::vector<std::string>& phases = deck_.phases;
  acts_ = phases.empty() || std::find(phases.begin(), phases.end(), phase) != phases.end();
  if (!acts_) hold();
}

void Servo::hold() {
  speed_ = 0.0;
  met_ = 0;
  told_ = false;
}

void Servo::step(double dt) {
  if (!acts_) return;
  ++steps_;
  const double next = way_ + dt * speed_;
  way_ = std::clamp(next, deck_.min_way, deck_.max_way);
  if (way_ != next) speed_ = 0.0;
}

double Servo::target(double dt) const {
  if (deck_.times.empty()) return deck_.force;
  return deck_.force * interpolate(deck_.times, deck_.factors, static_cast<double>(steps_) * dt);
}

/// Half of what would meet the target at the next look if nothing behind the grains at the wall gave way.
double Servo::chosen_speed(const WallResistance& grains, double target) const {
  constexpr double share = 0.5;
  const double lacking = share * (target - grains.force);
  const double most = deck_.max_speed * grains.per_speed;  // what the greatest speed would add
  if (std::fabs(lacking) < most) return lacking / grains.per_speed;
  if (lacking == 0.0) return 0.0;
  return lacking > 0.0 ? deck_.max_speed : -deck_.max_speed;
}

std::optional<std::string> Servo::control(const WallResistance& grains, double dt) {
  const double target = this->target(dt);
  force_ = grains.force;
  const bool is_met = std::fabs(target - force_) <= deck_.tolerance * deck_.force;
  met_ = is_met ? met_ + 1 : 0;
  speed_ = chosen_speed(grains, target);
  const bool at_most = way_ == deck_.max_way && speed_ > 0.0;
  const bool at_least = way_ == deck_.min_way && speed_ < 0.0;
  if (!at_most && !at_least) return {};
  speed_ = 0.0;
  if (told_ || is_met) return {};
  told_ = true;
  return fmt::format("its servo has come to {} = {:.6g} m, where the grains press with {:.4g} N of {:.4g} N{}",
                     at_most ? "max_way" : "min_way", way_, force_, target,
                     at_most && force_ == 0.0 ? ": it has found no resistance; look at its direction and at where the "
                                                "grains are, or raise max_way"
                                              : "; the wall stays there until the force is beyond the target");
}

bool Servo::holds(double dt) const {
  return met_ >= steady_looks && (deck_.times.empty() || static_cast<double>(steps_) * dt >= deck_.times.back());
}

Placement Servo::placement() const {
  Placement placement;
  placement.shift = way_ * direction_;
  placement.motion.velocity = speed_ * direction_;
  return placement;
}

double greatest_speed(const WallDeck& wall, const DomainDeck& domain) {
  return greatest_speed(wall.motions, domain) + (wall.servo.enabled ? wall.servo.max_speed : 0.0);
}

}  // namespace repose
