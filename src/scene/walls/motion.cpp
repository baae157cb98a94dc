#include "scene/walls/motion.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "deck/acts_in.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

/// What one motion does to points: x' = turn x + shift, by columns of the rotation.
Placement placement_of(const MotionDeck& motion, double time, bool runs) {
  Placement placement;
  switch (motion.type) {
    case MotionType::translation:
      placement.shift = time * motion.velocity;
      if (runs) placement.motion.velocity = motion.velocity;
      break;
    case MotionType::oscillation: {
      const double omega = 2.0 * pi * motion.frequency;
      const auto [sine, cosine] = sin_cos_reproducible(omega * time);
      placement.shift = sine * motion.amplitude;
      if (runs) placement.motion.velocity = (omega * cosine) * motion.amplitude;
      break;
    }
    case MotionType::conveyor:
      if (runs) placement.motion.belt = motion.velocity;
      break;
    case MotionType::rotation: {
      const Vec3 axis = unit_vector(motion.axis_direction);
      placement = turned_about(motion.axis_origin, axis, motion.angular_velocity * time);
      if (runs) {
        placement.motion.angular_velocity = motion.angular_velocity * axis;
        placement.motion.velocity = -cross(placement.motion.angular_velocity, motion.axis_origin);
      }
      break;
    }
  }
  return placement;
}

std::array<Vec3, 8> corners(const DomainDeck& domain) {
  std::array<Vec3, 8> all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = {(k & 1) != 0 ? domain.max.x : domain.min.x, (k & 2) != 0 ? domain.max.y : domain.min.y,
              (k & 4) != 0 ? domain.max.z : domain.min.z};
  }
  return all;
}

/// Of a point from the axis of a rotation.
double distance(const MotionDeck& rotation, const Vec3& x) {
  return norm(cross(unit_vector(rotation.axis_direction), x - rotation.axis_origin));
}

bool are_coaxial(const MotionDeck& a, const MotionDeck& b) {
  return distance(a, b.axis_origin) == 0.0 &&
         norm(cross(unit_vector(a.axis_direction), unit_vector(b.axis_direction))) == 0.0;
}

/// How far a point of the domain can be from the axis of a rotation that later motions carry along. Another rotation
/// leaves a point as far from its origin as it was; under a translation the axis is taken to stay in the domain.
double greatest_lever(const MotionDeck& rotation, std::span<const MotionDeck> later, const DomainDeck& domain) {
  const Vec3 axis = unit_vector(rotation.axis_direction);
  const bool is_turned = std::any_of(later.begin(), later.end(), [&](const MotionDeck& m) {
    return m.type == MotionType::rotation && !are_coaxial(rotation, m);
  });
  const auto across = [&](const Vec3& v) { return is_turned ? norm(v) : norm(cross(axis, v)); };
  const MotionDeck* pivot = &rotation;
  double lever = 0.0;
  double moved = 0.0;
  for (const MotionDeck& m : later) {
    if (m.type == MotionType::oscillation) moved += across(m.amplitude);
    if (m.type == MotionType::translation && across(m.velocity) > 0.0) lever = across(domain.max - domain.min);
    if (m.type != MotionType::rotation) continue;
    moved += pivot == &rotation ? distance(rotation, m.axis_origin) : across(m.axis_origin - pivot->axis_origin);
    pivot = &m;
  }
  for (const Vec3& x : corners(domain)) lever = std::max(lever, across(x - pivot->axis_origin));
  return lever + moved;
}

}  // namespace

Placement turned_about(const Vec3& origin, const Vec3& axis, double angle) {
  const auto [sine, cosine] = sin_cos_reproducible(angle);
  const double rest = 1.0 - cosine;
  Placement placement;
  placement.rows = {
      Vec3{cosine + rest * axis.x * axis.x, rest * axis.x * axis.y - sine * axis.z,
           rest * axis.x * axis.z + sine * axis.y},
      Vec3{rest * axis.y * axis.x + sine * axis.z, cosine + rest * axis.y * axis.y,
           rest * axis.y * axis.z - sine * axis.x},
      Vec3{rest * axis.z * axis.x - sine * axis.y, rest * axis.z * axis.y + sine * axis.x,
           cosine + rest * axis.z * axis.z},
  };
  placement.shift = origin - placement.turn(origin);
  return placement;
}

Placement carried(const Placement& outer, const Placement& inner) {
  Placement both;
  const auto column = [&](double Vec3::*component) {
    return outer.turn(Vec3{inner.rows[0].*component, inner.rows[1].*component, inner.rows[2].*component});
  };
  const std::array<Vec3, 3> columns = {column(&Vec3::x), column(&Vec3::y), column(&Vec3::z)};
  both.rows = {Vec3{columns[0].x, columns[1].x, columns[2].x}, Vec3{columns[0].y, columns[1].y, columns[2].y},
               Vec3{columns[0].z, columns[1].z, columns[2].z}};
  both.shift = outer.place(inner.shift);
  // The inner motion's velocity at x, which the outer one has brought there, is that of the point where it was.
  const Vec3 turning = outer.turn(inner.motion.angular_velocity);
  both.motion.angular_velocity = outer.motion.angular_velocity + turning;
  both.motion.belt = outer.motion.belt + outer.turn(inner.motion.belt);
  both.motion.velocity = outer.motion.velocity + outer.turn(inner.motion.velocity) - cross(turning, outer.shift);
  return both;
}

void Motions::begin_phase(const std::string& phase) {
  for (std::size_t k = 0; k < motions_.size(); ++k) {
    const std::vector<std::string>& phases = motions_[k].phases;
    clocks_[k].runs = acts_in(phases, phase);
  }
}

void Motions::step() {
  for (Clock& clock : clocks_) clock.steps += clock.runs ? 1 : 0;
}

Placement Motions::placement(double dt) const {
  Placement placement;
  for (std::size_t k = 0; k < motions_.size(); ++k) {
    const double time = static_cast<double>(clocks_[k].steps) * dt;
    placement = carried(placement_of(motions_[k], time, clocks_[k].runs), placement);
  }
  return placement;
}

double greatest_speed(const std::vector<MotionDeck>& motions, const DomainDeck& domain) {
  double speed = 0.0;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const MotionDeck& m = motions[k];
    switch (m.type) {
      case MotionType::translation:
      case MotionType::conveyor:
        speed += norm(m.velocity);
        break;
      case MotionType::oscillation:
        speed += 2.0 * pi * m.frequency * norm(m.amplitude);
        break;
      case MotionType::rotation:
        speed += std::fabs(m.angular_velocity) * greatest_lever(m, std::span(motions).subspan(k + 1), domain);
        break;
    }
  }
  return speed;
}

Vec3 turned(const Vec3& v, const Vec3& axis, const SineCosine& angle) {
  const auto [sine, cosine] = angle;
  return cosine * v + sine * cross(axis, v) + ((1.0 - cosine) * dot(axis, v)) * axis;
}

}  // namespace repose
