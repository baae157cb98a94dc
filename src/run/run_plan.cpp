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

/// The guards of a run, for what is known of the particles beforehand: DeckError when one that has this radius (m) and
/// velocity (m/s) is too fast for the time step, whose greatest speed is `greatest`. `who()` names it.
template <class Name>
void check_speed(double radius, const Vec3& velocity, const TimeStep& dt, double greatest, const Name& who) {
  const double speed = norm(velocity);
  const double share = speed * dt.step / radius;
  if (!(share < longest_way)) throw DeckError(too_far_text(who(), speed, share, dt.step, "slow it down"));
  if (speed > greatest) throw DeckError(too_fast_text(who(), speed, dt));
}

void check_speeds(const Insertion& insertion, const TimeStep& dt) {
  const double greatest = greatest_speed(dt, greatest_excess);
  const NewParticles& now = insertion.now;
  for (std::size_t i = 0; i < now.size(); ++i) {
    check_speed(now.radius[i], now.velocity[i], dt, greatest,
                [&] { return fmt::format("particle {} at {}", now.id[i], place_text(now.position[i])); });
  }
  for (const Pour& pour : insertion.pours) {
    const double smallest = *std::min_element(pour.radius.begin(), pour.radius.end());
    check_speed(smallest, pour.deck.velocity, dt, greatest,
                [&] { return fmt::format("{}: what is poured", pour.block); });
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
