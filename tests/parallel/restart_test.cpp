// A run that is stopped and goes on from its checkpoint, on any number of ranks, ends as one that was never stopped:
// the same bits, the same rows, the same figures.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "../unit/output_samples.h"
#include "base/error.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "files/directory_lock.h"
#include "output/summary.h"
#include "run/checkpoints.h"
#include "run/run.h"

namespace repose::test {
namespace {

/// Everything that has state of its own: a pour, walls that come and go and that move, by prescription,
/// under load and with one another, held grains, a tilt, exits, all
/// the series, a periodic direction, heat, and particles that grow.
const char* const scene = R"(
[domain]
min = [-0.02, -0.01, -0.001]
max = [0.0075, 0.01, 0.03]
periodic = ["y"]
[[exit]]
name = "chute"
face = "x_max"
max = [0.0, 0.0, 0.03]
[[material]]
name = "glass"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 2500.0
conductivity = 1.4
specific_heat = 800.0
emissivity = 0.9
[heat]
every = 41
gas = "air"
radiation = true
max_gap = 0.5
[[pair]]
materials = ["glass", "glass"]
restitution = 0.6
sliding_friction = 0.4
rolling_friction = 0.05
[[wall]]
name = "floor"
type = "rectangle"
material = "glass"
corner = [-0.008, -0.01, 0.0]
edge_u = [0.016, 0.0, 0.0]
edge_v = [0.0, 0.02, 0.0]
[wall.heat]
type = "temperature"
temperature = 600.0
times = [0.0, 0.05]
factors = [1.0, 1.2]
[[wall]]
name = "pusher"
type = "rectangle"
material = "glass"
corner = [-0.008, -0.01, 0.0001]
edge_u = [0.0, 0.02, 0.0]
edge_v = [0.0, 0.0, 0.004]
[[wall.motion]]
type = "oscillation"
amplitude = [0.001, 0.0, 0.0]
frequency = 50.0
phases = ["shake"]
[wall.heat]
type = "power"
power = 0.05
[[wall]]
name = "press"
type = "rectangle"
material = "glass"
corner = [0.003, -0.008, 0.0065]
edge_u = [0.003, 0.0, 0.0]
edge_v = [0.0, 0.016, 0.0]
[wall.servo]
direction = [0.0, 0.0, -1.0]
force = 2e-3
max_speed = 0.1
max_way = 0.005
every = 7
times = [0.0, 0.02, 0.04]
factors = [0.5, 1.0, 0.1]
[[wall]]
name = "flap"
type = "rectangle"
material = "glass"
corner = [-0.006, -0.008, 0.003]
edge_u = [0.003, 0.0, 0.0]
edge_v = [0.0, 0.016, 0.0]
[wall.servo]
type = "rotation"
axis_origin = [-0.006, 0.0, 0.003]
axis_direction = [0.0, 1.0, 0.0]
torque = "4 uN m"
max_angular_velocity = 30.0
max_angle = 50.0
min_angle = -20.0
every = 9
[[wall]]
name = "flap_edge"
type = "rectangle"
material = "glass"
moves_with = "flap"
corner = [-0.003, -0.008, 0.002]
edge_u = [0.0, 0.016, 0.0]
edge_v = [0.0, 0.0, 0.001]
[[wall]]
name = "stop"
type = "rectangle"
material = "glass"
corner = [0.007, -0.01, 0.0]
edge_u = [0.0, 0.02, 0.0]
edge_v = [0.0, 0.0, 0.004]
[[particles]]
type = "fill"
material = "glass"
diameter = 0.001
count = 120
region = "box"
min = [-0.0065, -0.0095, 0.0002]
max = [0.0065, 0.0095, 0.0045]
[[particles]]
type = "lattice"
material = "glass"
diameter = 0.001
counts = [1, 3, 1]
spacing = 0.004
first = [0.0, -0.004, 0.0051]
fixed = true
temperature = 900.0
isothermal = true
[[particles]]
type = "pour"
material = "glass"
diameter = 0.001
count = 40
region = "box"
min = [-0.004, -0.009, 0.008]
max = [0.004, 0.009, 0.012]
particle_rate = 2000.0
start_time = 0.004
interval = 0.002
heating = 2000.0
[tilt]
angular_velocity = 80.0
phases = ["shake"]
[time]
step = 1e-5
[[phase]]
name = "fall"
until = "steps"
steps = 1500
[[phase]]
name = "shake"
until = "steps"
steps = 4500
remove_walls = ["stop"]
[phase.growth]
factor = 1.0005
every = 130
[[phase.heat]]
min = [-0.008, -0.01, 0.0]
max = [0.0, 0.01, 0.03]
temperature = 450.0
power = 0.001
[measurement.discharge]
orifice_height = 0.0
[output]
series_interval = "1 ms"
snapshot_interval = "5 ms"
contacts = true
walls = true
trace = true
trace_every = 500
)";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class Restart : public testing::Test {
 protected:
  std::string folder(const std::string& name) const { return folder_ / name; }

  /// The summary, or none when it was stopped after so many looks at whether it should be (0: never).
  std::optional<Summary> run(const Communicator& comm, const std::string& name, int looks, bool restart,
                             const std::vector<std::string>& overrides = {}) const {
    const Deck deck = read_deck(deck_, "scene.toml", overrides);
    OutputOptions options;
    options.directory = folder(name);
    options.resolved_deck = resolved_deck(deck);
    options.log.progress = nullptr;
    options.restart = restart;
    int looked = 0;
    const auto stop_asked = [&](double) -> std::optional<std::string> {
      if (++looked == looks && comm.rank() == comm.size() - 1) return "the test";  // one rank decides for all
      return {};
    };
    try {
      return run_deck(comm, deck, {}, best_vector_level(), options, stop_asked);
    } catch (const Stopped&) {
      return {};
    }
  }

  void expect_same_files(const std::string& a, const std::string& b) const {
    if (!world_.is_root()) return;
    for (const char* file : {"series.csv", "walls.csv", "trace.csv", "run.hdf.series", "run_0000002500.hdf",
                             "contacts_0000002500.vtp", "walls_0000002500.vtp"}) {
      EXPECT_FALSE(text_of(folder(a) + "/" + file).empty()) << file;
      EXPECT_EQ(text_of(folder(a) + "/" + file), text_of(folder(b) + "/" + file)) << file;
    }
  }

  std::string deck_ = scene;
  Communicator world_{MPI_COMM_WORLD};
  ScratchFolder folder_{world_, "repose_restart"};
};

TEST_F(Restart, EndsAsARunThatWasNeverStopped) {
  const std::optional<Summary> whole = run(world_, "whole", 0, false);
  ASSERT_TRUE(whole);
  EXPECT_EQ(checkpoints_in(folder("whole")).size(), 0U);
  EXPECT_FALSE(run(world_, "parts", 3, false));
  int stops = 1;
  std::optional<Summary> parts;
  for (; !parts; ++stops) parts = run(world_, "parts", 7, true);
  EXPECT_GT(stops, 4);
  EXPECT_EQ(parts->restarts, stops - 1);
  EXPECT_EQ(parts->state_hash, whole->state_hash);
  EXPECT_EQ(parts->figures["servos"], whole->figures["servos"]);
  EXPECT_GT(parts->figures["servos"]["press"]["force_N"].get<double>(), 0.0);
  EXPECT_NEAR(parts->figures["servos"]["flap"]["angle_deg"].get<double>(), 25.0, 24.0);  // grains have held it
  EXPECT_EQ(parts->inserted, 163);
  EXPECT_GT(parts->left, 0);
  EXPECT_EQ(parts->figures["discharged_mass_kg"], whole->figures["discharged_mass_kg"]);
  EXPECT_EQ(parts->figures["discharge_time_s"], whole->figures["discharge_time_s"]);
  for (std::size_t e = 0; e < whole->exits.size(); ++e) {
    EXPECT_EQ(parts->exits[e].particles, whole->exits[e].particles);
    EXPECT_EQ(parts->exits[e].mass_kg, whole->exits[e].mass_kg);
  }
  expect_same_files("whole", "parts");
  const std::string walls = text_of(folder("parts") + "/walls.csv");
  EXPECT_NE(walls.find(",press_way_m,flap_angle_deg,"), std::string::npos) << walls.substr(0, walls.find('\n'));
}

// A phase that asks for the load on a wall asks right after a restart, before any step.
TEST_F(Restart, TheLoadOnAWallIsKnownAtOnce) {
  const std::string steps = "until = \"steps\"\nsteps = 4500";
  deck_.replace(
      deck_.find(steps), steps.size(),
      "until = \"wall_torque\"\nwall = \"floor\"\ntorque = 1.0\naxis_origin = [0, 0, 0]\naxis_direction = [0, 1, 0]"
      "\nmax_time = 0.03");
  const std::optional<Summary> whole = run(world_, "whole", 0, false);
  ASSERT_TRUE(whole);
  EXPECT_FALSE(run(world_, "parts", 9, false));
  std::optional<Summary> parts;
  while (!parts) parts = run(world_, "parts", 11, true);
  EXPECT_EQ(parts->phases.back().ended_by, "max_time");
  EXPECT_EQ(parts->steps, whole->steps);
  EXPECT_EQ(parts->state_hash, whole->state_hash);
}

TEST_F(Restart, GoesOnInAPhaseInWhichNothingMovesAndAWallHasGone) {
  deck_ += R"(
[[phase]]
name = "rest"
until = "steps"
steps = 3000
mechanics = false
remove_walls = ["floor"]
)";
  const std::vector<std::string> brief = {"phase.1.steps=1000"};  // some grains touch the floor and the flap then
  const std::optional<Summary> whole = run(world_, "whole", 0, false, brief);
  ASSERT_TRUE(whole);
  EXPECT_FALSE(run(world_, "parts", 3, false, brief));
  std::optional<Summary> parts;
  while (!parts) parts = run(world_, "parts", 7, true, brief);
  EXPECT_EQ(parts->steps, 5500);
  EXPECT_EQ(parts->state_hash, whole->state_hash);
  expect_same_files("whole", "parts");
}

TEST_F(Restart, GoesOnOnAnotherNumberOfRanks) {
  const std::optional<Summary> whole = run(world_, "whole", 0, false);
  EXPECT_FALSE(run(world_, "parts", 12, false));
  for (int ranks = world_.size() - 1; ranks > 0; --ranks) {  // fewer and fewer
    MPI_Comm some = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, world_.rank() < ranks ? 0 : MPI_UNDEFINED, 0, &some);
    if (some != MPI_COMM_NULL) {
      EXPECT_FALSE(run(Communicator(some), "parts", 4, true));
      MPI_Comm_free(&some);
    }
    world_.barrier();
  }
  const std::optional<Summary> parts = run(world_, "parts", 0, true);
  ASSERT_TRUE(parts && whole);
  EXPECT_EQ(parts->state_hash, whole->state_hash);
  expect_same_files("whole", "parts");
}

/// The message of the error with which a run ends.
template <class Work>
std::string error_of(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Restart, OnlyOutputAndLimitsOfTheDeckMayDiffer) {
  EXPECT_FALSE(run(world_, "parts", 20, false));
  const std::string other = error_of([&] {
    run(world_, "parts", 0, true, {"pair.0.restitution=0.5", "gravity=[0, 0, -9.8]", "output.series_interval=2e-3"});
  });
  EXPECT_NE(other.find("gravity: [0, 0, -9.81] there, [0, 0, -9.8] here; pair[0].restitution: 0.6 there, 0.5 here;"),
            std::string::npos)
      << other;
  EXPECT_EQ(other.find("series_interval"), std::string::npos) << other;
}

TEST_F(Restart, APhaseMayLastLongerOrLessUnlessParticlesGrow) {
  const std::string brief = "phase.1.steps=300";
  EXPECT_FALSE(run(world_, "parts", 10, false, {brief}));  // by step 1000, in the phase before they grow
  const std::string growing = error_of([&] { run(world_, "parts", 0, true, {brief, "phase.1.max_time=1e-3"}); });
  EXPECT_NE(growing.find("belongs to another deck: phase[1].max_time: nothing there, 0.001 here;"), std::string::npos)
      << growing;
  const std::optional<Summary> limited =
      run(world_, "parts", 0, true, {brief, "output.snapshot_interval=0", "phase.0.max_time=0.012"});
  ASSERT_TRUE(limited);
  EXPECT_EQ(limited->steps, 1500);
}

TEST_F(Restart, AnUnfinishedRunIsNotOverwritten) {
  EXPECT_FALSE(run(world_, "parts", 5, false));
  const std::string message = error_of([&] { run(world_, "parts", 0, false); });
  EXPECT_NE(message.find("--restart"), std::string::npos) << message;
  EXPECT_EQ(checkpoints_in(folder("parts")).size(), 1U);
}

TEST_F(Restart, ADamagedCheckpointGivesWayToTheOneBefore) {
  const std::optional<Summary> whole = run(world_, "whole", 0, false);
  EXPECT_FALSE(run(world_, "parts", 9, false, {"output.checkpoint_steps=300"}));
  const std::vector<std::string> checkpoints = checkpoints_in(folder("parts"));
  ASSERT_EQ(checkpoints.size(), 2U);
  world_.barrier();
  if (world_.is_root()) {
    std::fstream file(checkpoints[0], std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(20000);
    file.put('x');
  }
  world_.barrier();
  const std::optional<Summary> parts = run(world_, "parts", 0, true);
  ASSERT_TRUE(parts && whole);
  EXPECT_EQ(parts->state_hash, whole->state_hash);
  expect_same_files("whole", "parts");
}

TEST_F(Restart, RowsThatHaveGoneMissingAreNoticed) {
  EXPECT_FALSE(run(world_, "parts", 20, false));
  if (world_.is_root()) std::filesystem::resize_file(folder("parts") + "/series.csv", 100);
  world_.barrier();
  const std::string message = error_of([&] { run(world_, "parts", 0, true); });
  EXPECT_NE(message.find("series.csv: holds 100 bytes"), std::string::npos) << message;
}

TEST_F(Restart, TwoJobsDoNotWriteToOneDirectory) {
  EXPECT_FALSE(run(world_, "parts", 20, false));
  std::optional<DirectoryLock> other;
  if (world_.is_root()) other.emplace(folder("parts"));
  world_.barrier();
  const std::string message = error_of([&] { run(world_, "parts", 0, true); });
  EXPECT_NE(message.find("another run is at work"), std::string::npos) << message;
  other.reset();
  world_.barrier();
  EXPECT_TRUE(run(world_, "parts", 0, true));
}

TEST_F(Restart, WithoutACheckpointItBegins) {
  const std::optional<Summary> run_alone = run(world_, "new", 0, true);
  ASSERT_TRUE(run_alone);
  EXPECT_EQ(run_alone->restarts, 0);
}

}  // namespace
}  // namespace repose::test
