// Shear cells and beds under a lid: closed forms for a layer of grains that slides, in a box and in a ring, and for one
// that is pressed and let go; the same bits on any number of ranks, and when the run is stopped in the middle.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/deck_runs.h"

namespace repose::test {
namespace {

constexpr double friction = 0.4;
constexpr double force = 0.02;  // N, of the lid
constexpr int grains = 16;
const double weight = grains * 2500.0 * M_PI / 6.0 * 1e-9 * 9.81;

/// A layer of 16 grains of 1 mm that cannot roll, which stick to the lid and slide on the floor; the motion of the
/// floor and a measurement are to be added.
const char* const layer = R"(
[domain]
min = [-0.01, -0.01, -0.002]
max = [0.01, 0.01, 0.004]
[[material]]
name = "grain"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
[[material]]
name = "slippery"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
[[pair]]
materials = ["grain", "grain"]
restitution = 0.2
sliding_friction = 1.0
rolling_friction = 0.0
[[pair]]
materials = ["grain", "slippery"]
restitution = 0.2
sliding_friction = 0.4
rolling_friction = 0.0
[[particles]]
type = "lattice"
material = "grain"
diameter = 0.001
counts = [4, 4, 1]
spacing = 0.0015
first = [-0.00225, -0.00225, 0.0005]
rotation_blocked = true
[time]
step = 5e-6
[[phase]]
name = "press"
until = "servo"
max_time = 0.2
[[phase]]
name = "work"
until = "time"
time = 0.05
[[wall]]
name = "lid"
type = "plane"
material = "grain"
point = [0.0, 0.0, 0.00101]
normal = [0.0, 0.0, -1.0]
[wall.servo]
direction = [0.0, 0.0, -1.0]
force = 0.02
max_speed = 0.01
max_way = 0.0003
tolerance = 1e-4
)";

const char* const box = R"(
times = [0.0, 1.0]
factors = [1.0, 1.0]
[[wall]]
name = "floor"
type = "plane"
material = "slippery"
point = [0.0, 0.0, 0.0]
[[wall.motion]]
type = "translation"
velocity = [0.006, 0.008, 0.0]
phases = ["work"]
[measurement.shear]
walls = ["floor"]
direction = [3.0, 4.0, 0.0]
area = 2e-5
plane_height = 0.0
phase = "work"
from = 0.02
interval = 1e-3
)";

/// Its axis is the floor's, beside the layer.
const char* const ring = R"(
[[wall]]
name = "floor"
type = "plane"
material = "slippery"
point = [0.0, 0.0, 0.0]
[[wall.motion]]
type = "rotation"
axis_origin = [0.001, 0.0, 0.0]
angular_velocity = 3.0
phases = ["work"]
[measurement.shear]
type = "rotation"
walls = ["floor"]
axis_origin = [0.001, 0.0, 0.0]
inner_radius = 0.0005
outer_radius = 0.004
plane_height = 0.0
phase = "work"
from = 0.02
interval = 1e-3
)";

/// The lid presses with its whole force, then with less and less.
const char* const compression = R"(
times = [0.0, 0.3, 0.35]
factors = [1.0, 1.0, 0.5]
[[wall]]
name = "floor"
type = "plane"
material = "slippery"
point = [0.0, 0.0, 0.0]
[measurement.compression]
lid = "lid"
area = 2e-5
height = 0.00101
load_phase = "hold"
unload_phase = "let_go"
interval = 1e-4
)";

class LidMeasurements : public DeckRuns {
 protected:
  static double number(const std::optional<Summary>& figures, const char* key) {
    return figures->figures[key].get<double>();
  }
};

TEST_F(LidMeasurements, ALayerThatSlidesHasTheFrictionOfItsGrainsInABox) {
  const auto figures = run(world_, std::string(layer) + box, "box");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  const double normal = (force + weight) / 2e-5;
  EXPECT_NEAR(number(figures, "normal_stress_Pa"), normal, 1e-3 * normal);
  EXPECT_NEAR(number(figures, "shear_stress_Pa"), friction * normal, 1e-3 * friction * normal);
  EXPECT_NEAR(number(figures, "internal_friction_deg"), std::atan(friction) * 180.0 / M_PI, 0.01);
  EXPECT_NEAR(number(figures, "internal_friction_peak_deg"), std::atan(friction) * 180.0 / M_PI, 0.05);
}

TEST_F(LidMeasurements, AndInARingWithTheLeverOfEachGrain) {
  const auto figures = run(world_, std::string(layer) + ring, "ring");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  double levers = 0.0;  // their mean
  for (int k = 0; k < grains; ++k) {
    levers += std::hypot(-0.00225 + 0.0015 * (k % 4) - 0.001, -0.00225 + 0.0015 * (k / 4)) / grains;
  }
  const double inner = 0.0005, outer = 0.004;
  const double area = M_PI * (outer * outer - inner * inner);
  const double mean_radius = 2.0 / 3.0 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
  const double normal = (force + weight) / area;
  EXPECT_NEAR(number(figures, "normal_stress_Pa"), normal, 1e-3 * normal);
  const double shear = friction * normal * levers / mean_radius;
  EXPECT_NEAR(number(figures, "shear_stress_Pa"), shear, 2e-3 * shear);
}

std::string pressed_layer() {
  std::string text = std::string(layer) + compression;
  const std::string work = "name = \"work\"\nuntil = \"time\"\ntime = 0.05\n";
  text.replace(
      text.find(work), work.size(),
      "name = \"hold\"\nuntil = \"time\"\ntime = 0.1\n[[phase]]\nname = \"let_go\"\nuntil = \"time\"\ntime = 0.2\n");
  const std::string press = "until = \"servo\"\nmax_time = 0.2\n";
  text.replace(text.find(press), press.size(), "until = \"time\"\ntime = 0.2\n");
  return text;
}

TEST_F(LidMeasurements, ALayerThatIsLetGoHasTheModulusOfHertz) {
  const auto figures = run(world_, pressed_layer(), "compression");
  ASSERT_TRUE(figures);
  if (!world_.is_root()) return;
  const double area = 2e-5, modulus = 5e6 / (2.0 * (1.0 - 0.09));
  const auto height = [&](double pressing) {  // overlaps at lid and floor, which bears the weight, too
    const auto overlap = [&](double load) {
      return std::pow(0.75 * load / grains / (modulus * std::sqrt(0.5e-3)), 2.0 / 3.0);
    };
    return 0.001 - overlap(pressing) - overlap(pressing + weight);
  };
  EXPECT_NEAR(number(figures, "compression_stress_Pa"), force / area, 1e-3 * force / area);
  const double solid = grains * M_PI / 6.0 * 1e-9;
  EXPECT_NEAR(number(figures, "compression_porosity"), 1.0 - solid / (area * height(force)), 1e-6);
  const double slope = -0.1 * force / area / std::log(height(0.98 * force) / height(0.88 * force));
  EXPECT_NEAR(number(figures, "compression_modulus_Pa"), slope, 0.01 * slope);
}

TEST_F(LidMeasurements, SameBitsOnAllRanksAsOnOne) {
  const Communicator self(MPI_COMM_SELF);
  const std::string ring_text = std::string(layer) + ring, bed_text = pressed_layer();
  const auto ring_together = run(world_, ring_text, "ring_together");
  const auto bed_together = run(world_, bed_text, "bed_together");
  if (world_.is_root()) {
    const auto ring_alone = run(self, ring_text, "ring_alone");
    const auto bed_alone = run(self, bed_text, "bed_alone");
    EXPECT_EQ(ring_alone->figures["internal_friction_deg"], ring_together->figures["internal_friction_deg"]);
    EXPECT_EQ(bed_alone->figures["compression_modulus_Pa"], bed_together->figures["compression_modulus_Pa"]);
    EXPECT_EQ(file_bytes(folder("ring_alone") + "/shear.csv"), file_bytes(folder("ring_together") + "/shear.csv"));
    EXPECT_EQ(file_bytes(folder("bed_alone") + "/compression.csv"),
              file_bytes(folder("bed_together") + "/compression.csv"));
  }
  world_.barrier();
}

TEST_F(LidMeasurements, GoOnAfterAStop) {
  for (const auto& [text, file] :
       {std::pair{std::string(layer) + ring, "/shear.csv"}, std::pair{pressed_layer(), "/compression.csv"}}) {
    const auto whole = run(world_, text, "whole");
    EXPECT_FALSE(run(world_, text, "parts", 30));
    int stops = 1;
    std::optional<Summary> parts;
    for (; !parts; ++stops) parts = run(world_, text, "parts", 25, true);
    EXPECT_GT(stops, 2);
    if (!world_.is_root()) continue;
    for (const char* key :
         {"internal_friction_deg", "internal_friction_peak_deg", "compression_modulus_Pa", "compression_porosity"}) {
      EXPECT_EQ(parts->figures[key], whole->figures[key]) << key;
    }
    EXPECT_EQ(file_bytes(folder("parts") + file), file_bytes(folder("whole") + file));
  }
}

}  // namespace
}  // namespace repose::test
