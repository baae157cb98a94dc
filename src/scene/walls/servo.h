#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "deck/deck.h"
#include "scene/walls/motion.h"

namespace repose {

/// How grains withstand a wall that presses on them along an axis, or turns against them about one.
struct WallResistance {
  double force = 0.0;      ///< N, of the grains against the wall; N m where it turns
  double per_speed = 0.0;  ///< N s/m, or N m s: growth of the force until the next look, over the speed until then
};

/// The one way in which a servo moves a body.
struct ServoAxis {
  ServoType type = ServoType::translation;
  Vec3 direction;  ///< unit
  Vec3 origin;     ///< m, where the axis of a rotation is

  /// Of a body that moves along it at `speed` m/s, or about it at `speed` rad/s.
  SurfaceMotion motion(double speed) const;
  /// What a force (N) on something at x (m) and a torque (N m) on it, too, do along it in N, or about it in N m.
  double load(const Vec3& x, const Vec3& force, const Vec3& torque) const;
};

/// A wall under load: moves along an axis so that the force on the grains meets a target, or turns about one so that
/// the torque does: ways are angles, speeds are angular velocities and forces are torques then. Where it has got to is
/// part of the state of a run; everything in it is the same on all ranks (docs/theory.md, "Walls under load").
class Servo {
 public:
  /// std::invalid_argument when the direction has no length.
  explicit Servo(const ServoDeck& deck);

  /// Acts in the phases that its deck names, or in all; in others it holds the wall. Changes nothing when the phase has
  /// begun before, as after a restart.
  void begin_phase(const std::string& phase);
  /// The wall moves on by one step of `dt` s, as far as it may.
  void step(double dt);
  /// The wall stays where it is until the next look, as if there had been none before.
  void hold();

  bool is_due(std::int64_t step) const { return acts_ && step % deck_.every == 0; }
  /// Chooses the speed by what the grains do now. Tells once when the wall stands at the end of its way and
  /// the target is not met.
  std::optional<std::string> control(const WallResistance& grains, double dt);

  const ServoAxis& axis() const { return axis_; }
  bool turns() const { return axis_.type == ServoType::rotation; }
  double max_speed() const { return limits_.speed; }  ///< m/s or rad/s
  std::int64_t every() const { return deck_.every; }
  double way() const { return way_; }      ///< m or rad along or about the axis, from where the wall is in the deck
  double angle_deg() const;                ///< of one that turns
  double force() const { return force_; }  ///< N or N m, of the grains at the last look
  double target(double dt) const;          ///< N or N m, now
  bool acts() const { return acts_; }
  /// Whether the target is no longer changing and has been met at the last `steady_looks` looks.
  bool holds(double dt) const;
  static constexpr std::int64_t steady_looks = 50;

  /// What it adds to where the wall is and to how it moves.
  Placement placement() const;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("way", self.way_);
    v("speed", self.speed_);
    v("force", self.force_);
    v("steps", self.steps_);
    v("met", self.met_);
    v("acts", self.acts_);
    v("told", self.told_);
  }

 private:
  struct Limits {
    double force, speed, max_way, min_way;
  };

  static Limits limits_of(const ServoDeck& deck);
  double chosen_speed(const WallResistance& grains, double target) const;
  std::string end_text(bool at_most, double target) const;

  ServoDeck deck_;
  ServoAxis axis_;
  Limits limits_;
  double way_ = 0.0;
  double speed_ = 0.0;
  double force_ = 0.0;
  std::int64_t steps_ = 0;  ///< in which it has acted
  std::int64_t met_ = 0;    ///< looks in a row that found the target met
  bool acts_ = false;
  bool told_ = false;
};

/// The greatest speed in m/s that its motions and its servo can give a point of a wall within the domain.
double greatest_speed(const WallDeck& wall, const DomainDeck& domain);

}  // namespace repose
