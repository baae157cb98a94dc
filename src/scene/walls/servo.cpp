#include "scene/walls/servo.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/interpolate.h"
#include "base/math.h"
#include "deck/acts_in.h"
#include "scene/walls/unit_vector.h"

namespace repose {

SurfaceMotion ServoAxis::motion(double speed) const {
  const Vec3 along = speed * direction;
  SurfaceMotion motion;
  motion.velocity = type == ServoType::rotation ? -cross(along, origin) : along;
  if (type == ServoType::rotation) motion.angular_velocity = along;
  return motion;
}

double ServoAxis::load(const Vec3& x, const Vec3& force, const Vec3& torque) const {
  return dot(direction, type == ServoType::rotation ? cross(x - origin, force) + torque : force);
}

Servo::Servo(const ServoDeck& deck)
    : deck_(deck),
      axis_{deck.type, unit_vector(deck.type == ServoType::rotation ? deck.axis_direction : deck.direction),
            deck.axis_origin},
      limits_(limits_of(deck)) {}

Servo::Limits Servo::limits_of(const ServoDeck& deck) {
  if (deck.type == ServoType::translation) return {deck.force, deck.max_speed, deck.max_way, deck.min_way};
  return {deck.torque, deck.max_angular_velocity, degree * deck.max_angle, degree * deck.min_angle};
}

void Servo::begin_phase(const std::string& phase) {
  const std::vector<std::string>& phases = deck_.phases;
  acts_ = acts_in(phases, phase);
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
  way_ = std::clamp(next, limits_.min_way, limits_.max_way);
  if (way_ != next) speed_ = 0.0;
}

double Servo::angle_deg() const { return 180.0 / pi * way_; }

double Servo::target(double dt) const {
  if (deck_.times.empty()) return limits_.force;
  return limits_.force * interpolate(deck_.times, deck_.factors, static_cast<double>(steps_) * dt);
}

/// Half of what would meet the target at the next look if nothing behind the grains at the wall gave way.
double Servo::chosen_speed(const WallResistance& grains, double target) const {
  constexpr double share = 0.5;
  const double lacking = share * (target - grains.force);
  const double most = limits_.speed * grains.per_speed;  // what the greatest speed would add
  if (std::fabs(lacking) < most) return lacking / grains.per_speed;
  if (lacking == 0.0) return 0.0;
  return lacking > 0.0 ? limits_.speed : -limits_.speed;
}

std::optional<std::string> Servo::control(const WallResistance& grains, double dt) {
  const double target = this->target(dt);
  force_ = grains.force;
  const bool is_met = std::fabs(target - force_) <= deck_.tolerance * limits_.force;
  met_ = is_met ? met_ + 1 : 0;
  speed_ = chosen_speed(grains, target);
  const bool at_most = way_ == limits_.max_way && speed_ > 0.0;
  const bool at_least = way_ == limits_.min_way && speed_ < 0.0;
  if (!at_most && !at_least) return {};
  speed_ = 0.0;
  if (told_ || is_met) return {};
  told_ = true;
  return end_text(at_most, target);
}

std::string Servo::end_text(bool at_most, double target) const {
  const std::string end = fmt::format("{}_{}", at_most ? "max" : "min", turns() ? "angle" : "way");
  const char* const unit = turns() ? "N m" : "N";
  const std::string advice =
      at_most && force_ == 0.0
          ? fmt::format(": it has found no resistance; look at its {} and at where the grains are, or raise {}",
                        turns() ? "axis" : "direction", end)
          : fmt::format("; the wall stays there until the {} is beyond the target", turns() ? "torque" : "force");
  return fmt::format("its servo has come to {} = {:.6g}{}, where the grains press with {:.4g} {} of {:.4g} {}{}", end,
                     turns() ? angle_deg() : way_, turns() ? " degrees" : " m", force_, unit, target, unit, advice);
}

bool Servo::holds(double dt) const {
  return met_ >= steady_looks && (deck_.times.empty() || static_cast<double>(steps_) * dt >= deck_.times.back());
}

Placement Servo::placement() const {
  Placement placement;
  if (turns()) {
    placement = turned_about(axis_.origin, axis_.direction, way_);
  } else {
    placement.shift = way_ * axis_.direction;
  }
  placement.motion = axis_.motion(speed_);
  return placement;
}

double greatest_speed(const WallDeck& wall, const DomainDeck& domain) {
  const ServoDeck& servo = wall.servo;
  if (!servo.enabled) return greatest_speed(wall.motions, domain);
  MotionDeck fastest;  // of the servo, which carries the motions along
  if (servo.type == ServoType::rotation) {
    fastest.type = MotionType::rotation;
    fastest.axis_origin = servo.axis_origin;
    fastest.axis_direction = servo.axis_direction;
    fastest.angular_velocity = servo.max_angular_velocity;
  } else {
    if (wall.motions.empty()) return servo.max_speed;
    fastest.velocity = servo.max_speed * unit_vector(servo.direction);
  }
  std::vector<MotionDeck> all = wall.motions;
  all.push_back(fastest);
  return greatest_speed(all, domain);
}

}  // namespace repose
