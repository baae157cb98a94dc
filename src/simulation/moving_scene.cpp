#include "simulation/moving_scene.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "deck/acts_in.h"
#include "scene/walls/unit_vector.h"

namespace repose {

MovingScene::MovingScene(const Deck& deck, std::vector<Wall> walls)
    : walls_(std::move(walls)),
      walls_travel_(std::any_of(walls_.begin(), walls_.end(), [](const Wall& w) { return w.travels; })),
      tilt_(deck.tilt),
      gravity_at_start_(deck.gravity),
      gravity_(deck.gravity) {}

void MovingScene::set_wall_skins(const Deck& deck, double inner_horizon, double outer_horizon) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (!walls_[w].travels) continue;
    const double speed = greatest_speed(deck.walls[walls_[w].moves_with.value_or(w)], deck.domain);
    walls_[w].inner_skin = inner_horizon * speed;
    walls_[w].outer_skin = outer_horizon * speed;
  }
}

void MovingScene::begin_phase(const std::string& name) {
  held_.begin_phase(name);
  for (Wall& wall : walls_) {
    wall.motions.begin_phase(name);
    if (wall.servo) wall.servo->begin_phase(name);
  }
  const std::vector<std::string>& phases = tilt_.phases;
  tilts_ = tilt_.enabled && acts_in(phases, name);
}

void MovingScene::set_wall_present(const std::string& name, bool present) {
  const auto wall = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& w) { return w.name == name; });
  if (wall == walls_.end()) return;
  const auto own = static_cast<std::size_t>(wall - walls_.begin());
  for (const std::size_t w : body_of(walls_, own)) walls_[w].present = present;
  std::optional<Servo>& servo = walls_[wall->moves_with.value_or(own)].servo;
  if (servo) servo->hold();
}

bool MovingScene::is_body_present(std::size_t leader) const {
  if (walls_[leader].present) return true;
  return std::any_of(walls_.begin(), walls_.end(), [&](const Wall& w) { return w.present && w.moves_with == leader; });
}

bool MovingScene::is_servo_due(std::size_t wall, std::int64_t step) const {
  const std::optional<Servo>& servo = walls_[wall].servo;
  return servo && servo->is_due(step) && is_body_present(wall);
}

void MovingScene::place(double dt) {
  held_.place(dt);
  repose::place(walls_, dt);
  if (tilt_steps_ > 0) tilt_gravity(dt);
}

void MovingScene::step(double dt, Particles& particles) {
  held_.step(dt);
  held_.hold(particles);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].motions.step();
    if (walls_[w].servo && is_body_present(w)) walls_[w].servo->step(dt);
  }
  repose::place(walls_, dt);
  if (!tilts_) return;
  ++tilt_steps_;
  tilt_gravity(dt);
}

std::optional<std::string> MovingScene::control(std::size_t wall, const WallResistance& grains, double dt) {
  std::optional<std::string> told = walls_[wall].servo->control(grains, dt);
  repose::place(walls_, dt);
  if (told) told = fmt::format("wall \"{}\": {}", walls_[wall].name, *told);
  return told;
}

bool MovingScene::servos_hold(double dt) const {
  bool any = false;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const std::optional<Servo>& servo = walls_[w].servo;
    if (!servo || !servo->acts() || !is_body_present(w)) continue;
    if (!servo->holds(dt)) return false;
    any = true;
  }
  return any;
}

void MovingScene::tilt_gravity(double dt) {
  tilt_angle_ = static_cast<double>(tilt_steps_) * dt * tilt_.angular_velocity;
  gravity_ = turned(gravity_at_start_, unit_vector(tilt_.axis_direction), sin_cos_reproducible(-tilt_angle_));
}

}  // namespace repose
