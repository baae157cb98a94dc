#pragma once

#include <string>

namespace repose {

/// A small correct deck; its line numbers are used by the tests of messages.
inline const std::string example_deck =
    R"([domain]
min = [-0.1, -0.1, -0.1]
max = [0.1, 0.1, "100 mm"]

[[material]]
name = "glass"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 2500

[[material]]
name = "steel"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 7850

[[pair]]
materials = ["glass", "glass"]
restitution = 0.9
sliding_friction = 0.5
rolling_friction = 0.1

[[pair]]
materials = ["steel", "glass"]
restitution = 0.8
sliding_friction = 0.4
rolling_friction = 0.0

[[wall]]
name = "floor"
type = "plane"
material = "steel"
point = [0, 0, -0.05]

[[wall]]
name = "tube"
type = "profile"
material = "steel"
points = [[0.02, 0.05], [0.02, -0.05]]

[[wall]]
name = "gate"
type = "disc"
material = "steel"
present = false
centre = [0, 0, 0]
radius = 0.02

[[particles]]
type = "fill"
material = "glass"
diameter = "2 mm"
count = 100
region = "cylinder"
centre = [0, 0, 0]
radius = 0.015
height = 0.05

[time]
step = 1e-6

[[phase]]
name = "settle"
until = "kinetic_energy"
kinetic_energy = 1e-12
min_time = 0.1
max_time = 2
add_walls = ["gate"]

[[phase]]
name = "flow"
until = "time"
time = 1
remove_walls = ["gate"]

[measurement.discharge]
orifice_height = 0

[measurement.angle_of_repose]
plate_height = -0.05
)";

}  // namespace repose
