// The static angle of repose in a tilting box: what the slope was before the avalanche, the same bits on any number of
// ranks, and when the run is stopped in the middle.
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "support/deck_runs.h"

namespace repose::test {
namespace {

const char* const box = R"(
[domain]
min = [-0.017, -0.002, -0.001]
max = [0.017, 0.002, 0.02]
periodic = ["y"]
[[material]]
name = "glass"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 2500.0
[[pair]]
materials = ["glass", "glass"]
restitution = 0.5
sliding_friction = 0.5
rolling_friction = 0.1
[[wall]]
name = "floor"
type = "plane"
material = "glass"
point = [0.0, 0.0, 0.0]
[[wall]]
name = "lower_end"
type = "plane"
material = "glass"
point = [-0.016, 0.0, 0.0]
normal = [1.0, 0.0, 0.0]
[[wall]]
name = "upper_end"
type = "plane"
material = "glass"
point = [0.016, 0.0, 0.0]
normal = [-1.0, 0.0, 0.0]
[[particles]]
type = "fill"
material = "glass"
diameter = 0.001
count = 800
region = "box"
min = [-0.016, -0.002, 0.0]
max = [0.016, 0.002, 0.016]
[tilt]
axis_direction = [0.0, -1.0, 0.0]
angular_velocity = "200 deg/s"
phases = ["tilt"]
[time]
step = 1e-5
[[phase]]
name = "settle"
until = "steps"
steps = 12000
[[phase]]
name = "tilt"
until = "tilt_onset"
max_time = 0.4
[[phase]]
name = "rest"
until = "steps"
steps = 5000
[measurement.surface_angle]
axis_origin = [0.0, 0.0, 0.004]
radius = 0.016
half_width = 0.8
interval = 1e-3
)";

using TiltingBox = DeckRuns;

double figure(const Summary& summary, const char* key) { return summary.figures.at(key).get<double>(); }

TEST_F(TiltingBox, TheBedKeepsItsSlopeInTheBoxUntilTheAvalanche) {
  const auto summary = run(world_, box, "whole");
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->phases[1].ended_by, "tilt_onset");
  if (!world_.is_root()) return;
  const double angle = figure(*summary, "static_angle_of_repose_deg");
  EXPECT_GT(angle, 20.0);
  EXPECT_LT(angle, 50.0);
  EXPECT_NEAR(figure(*summary, "avalanche_tilt_deg"), angle, 12.0);  // it lay level, and at this rate it lags
  const double after = figure(*summary, "slope_after_avalanche_deg");
  EXPECT_LT(after, angle - 1.0);
  // The same surface in columns along gravity.
  std::istringstream lines(file_bytes(folder("whole") + "/surface_angle.csv"));
  std::string last;
  for (std::string line; std::getline(lines, line);) last = line;
  EXPECT_NEAR(std::stod(last.substr(last.rfind(',') + 1)), after, 5.0);
}

TEST_F(TiltingBox, SameBitsOnAllRanksAndAfterStops) {
  const auto whole = run(world_, box, "whole");
  EXPECT_FALSE(run(world_, box, "parts", 150));
  std::optional<Summary> parts;
  while (!parts) parts = run(world_, box, "parts", 200, true);
  ASSERT_TRUE(whole);
  if (world_.is_root()) {
    const auto alone = run(Communicator(MPI_COMM_SELF), box, "alone");
    for (const char* key : {"static_angle_of_repose_deg", "avalanche_tilt_deg", "slope_after_avalanche_deg"}) {
      EXPECT_EQ(parts->figures.at(key), whole->figures.at(key)) << key;
      EXPECT_EQ(alone->figures.at(key), whole->figures.at(key)) << key;
    }
    EXPECT_EQ(parts->state_hash, whole->state_hash);
    EXPECT_EQ(alone->state_hash, whole->state_hash);
  }
  world_.barrier();
}

}  // namespace
}  // namespace repose::test
