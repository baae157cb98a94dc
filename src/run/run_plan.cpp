#include "run/run_plan.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "integration/velocity_verlet.h"
#include "simulation/guards.h"
#include "simulation/phases.h"
#include "simulation/setup.h"

namespace repose {
namespace {

/// The guards of a run, for what is known of the particles beforehand.
class SpeedCheck {
 public:
  explicit SpeedCheck(const TimeStep& dt) : dt_(dt), greatest_(greatest_speed(dt, greatest_excess)) {}

  /// DeckError when what has this radius (m) and velocity (m/s) is too fast for the time step; `who()` names it.
  template <class Name>
  void operator()(double radius, const Vec3& velocity, const Name& who) const {
    const double speed = norm(velocity);
    const double way = speed * dt_.step / radius;
    if (!(way < longest_way)) {
      throw DeckError(
          fmt::format("{} moves at {:.3g} m/s, {:.3g} of its radius in one step: beyond {} it could pass "
                      "through a wall or another particle unseen; shorten time.step to {:.1e} s, or slow "
                      "it down",
                      who(), speed, way, longest_way, 0.5 * longest_way / way * dt_.step));
    }
    if (speed <= greatest_) return;
    throw DeckError(
        fmt::format("{} moves at {:.3g} m/s, for which the time step {:.3g} s is {:.2f} times its "
                    "criterion (expected {:.3g} m/s; an error at {:g}); set time.expected_speed to {:.3g} "
                    "or shorten time.step",
                    who(), speed, dt_.step, time_step_excess(dt_, speed), dt_.speed, greatest_excess, speed));
  }

 private:
  const TimeStep& dt_;
  double greatest_;  ///< m/s
};

void check_speeds(const Insertion& insertion, const TimeStep& dt) {
  const SpeedCheck check(dt);
  const NewParticles& now = insertion.now;
  for (std::size_t i = 0; i < now.size(); ++i) {
    check(now.radius[i], now.velocity[i],
          [&] { return fmt::format("particle {} at {}", now.id[i], place_text(now.position[i])); });
  }
  for (const Pour& pour : insertion.pours) {
    const double smallest = *std::min_element(pour.radius.begin(), pour.radius.end());
    check(smallest, pour.deck.velocity, [&] { return fmt::format("{}: what is poured", pour.block); });
  }
}

}  // namespace

RunPlan::RunPlan(const Deck& deck, const ReadFile& read_file)
    : materials(deck), walls(make_walls(deck, materials, read_file)) {
  SetUp s = set_up(deck, materials, walls, read_file);
  insertion = std::move(s.insertion);
  dt = s.time_step;
  check_speeds(insertion, dt);
}

double most_steps(const Deck& deck, const TimeStep& dt) {
  double steps = 0.0;
  for (const PhaseDeck& phase : deck.phases) steps += static_cast<double>(longest_steps(phase, dt.step));
  return steps;
}

}  // namespace repose
