#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "integration/held_particles.h"
#include "scene/walls/wall.h"

namespace repose {

/// What moves by prescription: walls, held particles, and gravity when the apparatus tilts; where they are is a
/// function of the deck and of how many steps each has moved. And walls under load, which go where the grains let them.
class MovingScene {
 public:
  MovingScene(const Deck& deck, std::vector<Wall> walls);

  /// Takes note of the particles that are held.
  void hold(const Deck& deck, const Insertion& insertion) { held_ = HeldParticles(deck, insertion); }
  /// To be called when the particles have been sorted anew.
  void list_held(Particles& particles) { held_.list(particles); }
  /// Walls that travel get skins that last as long as the horizons (s) of the inner and of the outer lists.
  void set_wall_skins(const Deck& deck, double inner_horizon, double outer_horizon);

  /// Starts the motions and the tilt that belong to a phase, and stops the others.
  void begin_phase(const std::string& name);
  /// Adds or removes a named wall, and those that move with it.
  void set_wall_present(const std::string& name, bool present);

  /// After reading it, place has to be called.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v.each("walls", self.walls_);
    v("held", self.held_);
    v("tilt_steps", self.tilt_steps_);
  }
  /// Brings everything to where it is after all steps so far of `dt` s.
  void place(double dt);

  /// Everything moves on by one step of `dt` s, the held particles among `particles` too.
  void step(double dt, Particles& particles);
  /// Gives the held particles position, velocity and spin as they have to be now.
  void put_back(Particles& particles) const { held_.hold(particles); }

  /// Whether the servo of a wall looks at the grains after this step: it acts, and a wall of its body is there.
  bool is_servo_due(std::size_t wall, std::int64_t step) const;
  /// The servo of a wall chooses its speed by what the grains do. What it has to tell, with the name of the wall.
  std::optional<std::string> control(std::size_t wall, const WallResistance& grains, double dt);
  /// Whether every servo that acts on a body that is there holds its target steadily, and there is one.
  bool servos_hold(double dt) const;

  const std::vector<Wall>& walls() const { return walls_; }
  bool walls_travel() const { return walls_travel_; }
  const HeldParticles& held() const { return held_; }
  const Vec3& gravity() const { return gravity_; }  ///< m/s2, as it points now
  double tilt() const { return tilt_angle_; }       ///< rad, by which the apparatus has tilted
  bool is_tilting() const { return tilts_; }

 private:
  void tilt_gravity(double dt);
  /// Whether a wall that moves by itself is there, or one that moves with it.
  bool is_body_present(std::size_t leader) const;

  std::vector<Wall> walls_;
  bool walls_travel_;
  HeldParticles held_;
  TiltDeck tilt_;
  Vec3 gravity_at_start_;
  Vec3 gravity_;
  std::int64_t tilt_steps_ = 0;
  double tilt_angle_ = 0.0;
  bool tilts_ = false;
};

}  // namespace repose
