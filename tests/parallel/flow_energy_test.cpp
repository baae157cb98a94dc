// The work of a blade: closed forms for a plate that pushes a grain, one that presses it, and one that turns under it;
// the same bits on any number of ranks, and when the run is stopped in the middle.
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/deck_runs.h"
#include "support/glass_beads.h"

namespace repose::test {
namespace {

/// One grain of 1 mm on the x axis; phases, walls and the measurement are to be added.
const char* const one_grain = R"(
gravity = [0.0, 0.0, {gravity}]
[domain]
min = [-0.01, -0.01, -0.002]
max = [0.01, 0.01, 0.004]
[[material]]
name = "grain"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
[[material]]
name = "floor"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
[[material]]
name = "plate"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
[[pair]]
materials = ["grain", "grain"]
restitution = 0.5
sliding_friction = 0.0
rolling_friction = 0.0
[[pair]]
materials = ["grain", "floor"]
restitution = 0.2
sliding_friction = 0.4
rolling_friction = 0.0
[[pair]]
materials = ["grain", "plate"]
restitution = 0.2
sliding_friction = 0.0
rolling_friction = 0.0
[[wall]]
name = "floor"
type = "plane"
material = "floor"
point = [0.0, 0.0, {floor}]
[[particles]]
type = "lattice"
material = "grain"
diameter = 0.001
counts = [1, 1, 1]
spacing = 0.002
first = {first}
rotation_blocked = true
[time]
step = 5e-6
[measurement.flow_energy]
walls = ["{blade}"]
phase = "work"
interval = {interval}
)";

const double grain_mass = 2500.0 * M_PI / 6.0 * 1e-9;
const double modulus = 5e6 / (2.0 * (1.0 - 0.09));

/// A bed in a tub that a paddle goes through along a helix.
const std::string paddle = glass + R"(
[domain]
min = [-0.006, -0.006, -0.001]
max = [0.006, 0.006, 0.03]
)" + glass_tube("tub", 0.03) +
                           R"(
[[wall]]
name = "paddle"
type = "rectangle"
material = "glass"
corner = [-0.0035, -0.0007, 0.0072]
edge_u = [0.007, 0.0, 0.0]
edge_v = [0.0, 0.0014, 0.0014]
[[wall.motion]]
type = "rotation"
angular_velocity = 12.0
phases = ["stir"]
[[wall.motion]]
type = "translation"
velocity = [0.0, 0.0, -0.09]
phases = ["stir"]
)" + glass_beads(300, 0.007) +
                           R"(
[[phase]]
name = "fall"
until = "steps"
steps = 3000
[[phase]]
name = "stir"
until = "steps"
steps = 6004
[[phase]]
name = "rest"
until = "steps"
steps = 200
[measurement.flow_energy]
walls = ["paddle"]
phase = "stir"
interval = 1.2e-4
)";

class FlowEnergy : public DeckRuns {
 protected:
  /// The rows of flow_energy.csv, on rank 0.
  std::vector<std::vector<double>> rows(const std::string& name) const {
    std::istringstream lines(file_bytes(folder(name) + "/flow_energy.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "step,time_s,way_m,angle_deg,force_N,torque_Nm,flow_energy_J");
    std::vector<std::vector<double>> all;
    while (std::getline(lines, line)) {
      std::istringstream values(line);
      all.emplace_back();
      for (std::string value; std::getline(values, value, ',');) all.back().push_back(std::stod(value));
    }
    return all;
  }
};

TEST_F(FlowEnergy, APlateThatPushesAGrainAlongAFloorDoesTheWorkOfFriction) {
  const double speed = 0.02, time = 0.2;
  const std::string deck =
      fmt::format(fmt::runtime(one_grain), fmt::arg("gravity", -9.81), fmt::arg("first", "[0.0, 0.0, 0.0005]"),
                  fmt::arg("blade", "plate"), fmt::arg("interval", 1e-5), fmt::arg("floor", 0.0)) +
      fmt::format(R"(
[[wall]]
name = "plate"
type = "rectangle"
material = "plate"
corner = [-0.0005, -0.001, 0.0001]
edge_u = [0.0, 0.002, 0.0]
edge_v = [0.0, 0.0, 0.002]
[[wall.motion]]
type = "translation"
velocity = [{}, 0.0, 0.0]
phases = ["work"]
[[phase]]
name = "settle"
until = "time"
time = 0.02
[[phase]]
name = "work"
until = "time"
time = {}
)",
                  speed, time);
  const auto figures = run(world_, deck, "push");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  // The plate's impulse is the momentum of the grain and what friction took of it; whatever the impacts lose is in the
  // first term, of which half stays as kinetic energy. Until the grain slides, the floor's spring stretches: less than
  // a thousandth of the time.
  const double friction = 0.4 * grain_mass * 9.81;
  const double work = grain_mass * speed * speed + friction * speed * time;
  EXPECT_NEAR(figures->figures["flow_energy_J"].get<double>(), work, 2e-3 * work);
  EXPECT_NEAR(figures->figures["specific_flow_energy_J_kg"].get<double>(), work / grain_mass, 2e-3 * work / grain_mass);
  const std::vector<double> last = rows("push").back();
  EXPECT_NEAR(last[2], speed * time, 1e-12);
  EXPECT_EQ(last[3], 0.0);
  EXPECT_NEAR(last[4], friction, 1e-3 * friction);
  EXPECT_EQ(last[5], 0.0);
  EXPECT_EQ(last[6], figures->figures["flow_energy_J"].get<double>());
}

TEST_F(FlowEnergy, APlateThatPressesAGrainStoresTheElasticEnergyOfHertz) {
  const double overlap = 1e-5;  // at plate and floor
  const std::string deck =
      fmt::format(fmt::runtime(one_grain), fmt::arg("gravity", 0.0), fmt::arg("first", "[0.0, 0.0, 0.0005]"),
                  fmt::arg("blade", "lid"), fmt::arg("interval", 1e-5), fmt::arg("floor", 0.0)) +
      R"(
[[wall]]
name = "lid"
type = "plane"
material = "plate"
point = [0.0, 0.0, 0.001]
[[wall.motion]]
type = "translation"
velocity = [0.0, 0.0, -1e-4]
phases = ["work"]
[[phase]]
name = "work"
until = "time"
time = 0.2
)";
  const auto figures = run(world_, deck, "press");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  const double work = 2.0 * (8.0 / 15.0) * modulus * std::sqrt(0.5e-3) * std::pow(overlap, 2.5);
  EXPECT_NEAR(figures->figures["flow_energy_J"].get<double>(), work, 2e-3 * work);  // dashpots
  const double force = (4.0 / 3.0) * modulus * std::sqrt(0.5e-3) * std::pow(overlap, 1.5);
  EXPECT_NEAR(rows("press").back()[4], force, 2e-3 * force);
}

TEST_F(FlowEnergy, ATableThatTurnsUnderAGrainDoesTheWorkOfItsTorque) {
  const double arm = 5e-3, spin = 2.0, time = 1.0;
  const std::string deck =
      fmt::format(fmt::runtime(one_grain), fmt::arg("gravity", -9.81), fmt::arg("first", "[0.006, 0.0, 0.0005]"),
                  fmt::arg("blade", "table"), fmt::arg("interval", 1e-3), fmt::arg("floor", -0.0015)) +
      fmt::format(R"(
[[wall]]
name = "stop"
type = "rectangle"
material = "plate"
corner = [0.005, -0.0005, 0.0001]
edge_u = [0.002, 0.0, 0.0]
edge_v = [0.0, 0.0, 0.002]
[[wall]]
name = "table"
type = "plane"
material = "floor"
point = [0.0, 0.0, 0.0]
[[wall.motion]]
type = "rotation"
axis_origin = [0.001, 0.0, 0.0]
axis_direction = [0.0, 0.0, -1.0]
angular_velocity = {}
phases = ["work"]
[[phase]]
name = "settle"
until = "time"
time = 0.02
[[phase]]
name = "work"
until = "time"
time = {}
)",
                  spin, time);
  const auto figures = run(world_, deck, "turn");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  const double weight = grain_mass * 9.81;
  const double work = 0.4 * weight * arm * spin * time;
  EXPECT_NEAR(figures->figures["flow_energy_J"].get<double>(), work, 1e-3 * work);  // before the stop holds the grain
  const std::vector<double> last = rows("turn").back();
  EXPECT_EQ(last[2], 0.0);
  EXPECT_NEAR(last[3], spin * time * 180.0 / M_PI, 1e-3);
  EXPECT_NEAR(last[4], -weight, 1e-4 * weight);  // along the axis of the turn, which points downwards
  EXPECT_NEAR(last[5], 0.4 * weight * arm, 1e-4 * weight * arm);
}

TEST_F(FlowEnergy, IsForceOverTheWayAndTorqueOverTheAngle) {
  const auto figures = run(world_, paddle, "helix");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  const auto all = rows("helix");
  ASSERT_GT(all.size(), 400U);
  double work = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<double>& now = all[k];
    const std::vector<double> before = k > 0 ? all[k - 1] : std::vector<double>{0, 0, 0, 0, now[4], now[5], 0};
    work += 0.5 * (before[4] + now[4]) * (now[2] - before[2]);
    work += 0.5 * (before[5] + now[5]) * (now[3] - before[3]) * M_PI / 180.0;
    EXPECT_NEAR(now[6], work, 1e-15) << k;
  }
  EXPECT_GT(work, 1e-6);
  EXPECT_EQ(all.back()[0], 9004.0);  // the last, shorter interval counts
  EXPECT_NEAR(all.back()[2], 0.09 * 6004e-5, 1e-15);
}

TEST_F(FlowEnergy, SameBitsOnAllRanksAsOnOne) {
  const auto together = run(world_, paddle, "together");
  if (world_.is_root()) {
    const auto alone = run(Communicator(MPI_COMM_SELF), paddle, "alone");
    EXPECT_EQ(alone->figures["flow_energy_J"], together->figures["flow_energy_J"]);
    EXPECT_EQ(alone->figures["specific_flow_energy_J_kg"], together->figures["specific_flow_energy_J_kg"]);
    EXPECT_EQ(file_bytes(folder("alone") + "/flow_energy.csv"), file_bytes(folder("together") + "/flow_energy.csv"));
  }
  world_.barrier();
}

TEST_F(FlowEnergy, GoesOnAfterAStop) {
  const auto whole = run(world_, paddle, "whole");
  EXPECT_FALSE(run(world_, paddle, "parts", 200));
  int stops = 1;
  std::optional<Summary> parts;
  for (; !parts; ++stops) parts = run(world_, paddle, "parts", 70, true);
  EXPECT_GT(stops, 4);
  EXPECT_EQ(parts->figures["flow_energy_J"], whole->figures["flow_energy_J"]);
  EXPECT_EQ(parts->figures["specific_flow_energy_J_kg"], whole->figures["specific_flow_energy_J_kg"]);
  if (world_.is_root()) {
    EXPECT_EQ(file_bytes(folder("parts") + "/flow_energy.csv"), file_bytes(folder("whole") + "/flow_energy.csv"));
  }
}

}  // namespace
}  // namespace repose::test
