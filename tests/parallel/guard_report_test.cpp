// What a run that hits a guard leaves behind: the message, and the neighbourhood of the culprit as a snapshot.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../unit/output_samples.h"
#include "base/error.h"
#include "output/snapshot_reader.h"
#include "output/summary.h"
#include "run/run.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr const char* grains =
    "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n"
    "0.1,0.25,0,20,0,0,0,0,0,0.001,grain\n"        // runs into the next
    "0.1021,0.25,0,-20,0,0,0,0,0,0.001,grain\n"    //
    "0.1,0.2565,0,0,0,0,0,0,0,0.001,grain\n"       // 6.5 radii away: in sight
    "0.1,0.2425,0,0,0,0,0,0,0,0.001,grain\n"       // 7.5 radii away: out of sight
    "0.1,0.25,0.022,0,0,0,0,0,0,0.015,grain\n"     // a ball whose surface is 7 radii away
    "0.1,0.25,-0.022,0,0,0,0,0,0,0.0165,grain\n";  // and one of 5.5 radii

class GuardReport : public ::testing::Test {
 protected:
  /// The message of the PhysicsError that ends the run.
  std::string run() {
    Deck deck = listed_deck(1e-6, 100);
    deck.time.expected_speed = 40.0;
    deck.run.check_every = 5;
    deck.output.snapshot_times = {9e-6, 10e-6, 11e-6};  // too deep at step 10 or 11
    const OutputOptions options = {folder_ / "out", "resolved = true\n", build_info("test"), {.progress = nullptr}};
    try {
      run_deck(
          comm_, deck, [](const std::string&) { return std::string(grains); }, best_vector_level(), options);
    } catch (const PhysicsError& error) {
      return error.what();
    }
    return "no error";
  }

  Communicator comm_{MPI_COMM_WORLD};
  ScratchFolder folder_{comm_, "repose_guard_report"};
};

TEST_F(GuardReport, TheNeighbourhoodIsASnapshot) {
  const std::string message = run();
  const std::size_t found = message.find("; neighbourhood in ");
  EXPECT_EQ(message.substr(0, 4), "step") << message;
  const std::int64_t step = std::stoll("0" + message.substr(5, 2));
  const std::string path = folder_ / fmt::format("out/neighbourhood_{:010d}.hdf", step);
  EXPECT_EQ(message.substr(std::min(found, message.size())), "; neighbourhood in " + path) << message;
  EXPECT_TRUE(std::filesystem::exists(path)) << path;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/summary.json"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / fmt::format("out/run_{:010d}.hdf", step - 1)));
  EXPECT_FALSE(std::filesystem::exists(folder_ / fmt::format("out/run_{:010d}.hdf", step)));  // the bad state
  if (!std::filesystem::exists(path)) return;
  const NewParticles near = parse_snapshot(file_bytes(path), path, {{"grain", 1e7, 0.3, 1000.0}});
  // A rank knows its own and its ghosts: all that touch, and on one rank all that there are.
  EXPECT_GE(near.size(), 2U);
  if (comm_.size() == 1) {
    EXPECT_EQ(near.radius, (std::vector<double>{0.001, 0.001, 0.001, 0.0165}));
    EXPECT_EQ(near.position.at(2).y, 0.2565);
  }
  EXPECT_EQ(near.velocity.at(0).y, 0.0);
  EXPECT_GT(near.velocity.at(0).x, 0.0);
}

TEST_F(GuardReport, TheMessageComesWithoutItsFile) {
  const std::string message = run();
  const std::size_t found = message.find("; neighbourhood in ");
  if (found == std::string::npos) FAIL() << message;
  const std::string path = message.substr(found + 19);
  comm_.barrier();
  if (comm_.is_root()) {
    std::filesystem::remove(path);
    std::filesystem::create_directories(path + "/x");
  }
  comm_.barrier();
  const std::string again = run();
  EXPECT_EQ(again.substr(0, found), message.substr(0, found));
  EXPECT_NE(again.find("; the neighbourhood could not be written: " + path), std::string::npos) << again;
}

TEST_F(GuardReport, ALaterRunRemovesIt) {
  const std::string old = folder_ / "out/neighbourhood_0000000777.hdf";
  if (comm_.is_root()) {
    std::filesystem::create_directories(folder_ / "out");
    std::ofstream(old) << "old";
  }
  comm_.barrier();
  run();
  EXPECT_FALSE(std::filesystem::exists(old));
  comm_.barrier();
}

}  // namespace
}  // namespace repose::test
