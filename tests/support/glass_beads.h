#pragma once

#include <string>

#include <fmt/core.h>

namespace repose::test {

/// Sections of a deck: glass, its contacts with itself, and a time step that it stands.
inline const std::string glass = R"(
[[material]]
name = "glass"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 2500.0
[[pair]]
materials = ["glass", "glass"]
restitution = 0.6
sliding_friction = 0.4
rolling_friction = 0.05
[time]
step = 1e-5
)";

/// A wall of glass, a tube of 5 mm radius with a floor at z = 0; height in m.
inline std::string glass_tube(const std::string& name, double height) {
  return fmt::format(R"(
[[wall]]
name = "{}"
type = "profile"
material = "glass"
points = [[0.0, 0.0], [0.005, 0.0], [0.005, {}]]
)",
                     name, height);
}

/// Beads of glass of 1 mm, at random in the tube up to `height` (m).
inline std::string glass_beads(int count, double height) {
  return fmt::format(R"(
[[particles]]
type = "fill"
material = "glass"
diameter = 0.001
count = {}
region = "cylinder"
centre = [0.0, 0.0, 0.0]
radius = 0.0049
height = {}
)",
                     count, height);
}

}  // namespace repose::test
