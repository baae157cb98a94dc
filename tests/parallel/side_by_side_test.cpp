// Several runs in one job, each on ranks of its own, as a calibration has them: one that fails ends alone, with the
// same error on all its ranks, and the others do not notice.
#include <fstream>

#include <gtest/gtest.h>

#include "../unit/output_samples.h"
#include "base/error.h"
#include "comm/agreement.h"
#include "output/summary.h"
#include "run/run.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr const char* calm =
    "x,y,z,radius,material\n0.1,0.25,0,0.001,grain\n0.1,0.25,0.0019,0.001,grain\n0.1,0.3,0,0.001,grain\n";
constexpr const char* colliding =
    "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n"
    "0.1,0.25,0,20,0,0,0,0,0,0.001,grain\n0.1021,0.25,0,-20,0,0,0,0,0,0.001,grain\n";

class SideBySide : public testing::Test {
 protected:
  SideBySide() {
    is_first_ = 2 * world_.rank() < world_.size();
    MPI_Comm part = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, is_first_ ? 0 : 1, 0, &part);
    group_.emplace(part);
    MPI_Comm_free(&part);
  }

  /// Runs in the group's own folder; the state hash, or "exit code: message" of the error.
  std::string run(const ReadFile& read_file, const std::string& folder) const {
    Deck deck = listed_deck(1e-6, 2000);
    deck.time.expected_speed = 40.0;
    const OutputOptions options = {folder, "resolved = true\n", build_info("test"), {.progress = nullptr}};
    try {
      return run_deck(*group_, deck, read_file, best_vector_level(), options)->state_hash;
    } catch (const Error& error) {
      return std::to_string(static_cast<int>(error.code())) + ": " + error.what();
    }
  }

  /// The first group fails by `read_file` or because of its folder, the other one does not.
  void expect_lonely_failure(const ReadFile& read_file, const std::string& folder, const std::string& beginning) {
    const ReadFile good = [](const std::string&) { return std::string(calm); };
    const std::string outcome = is_first_ ? run(read_file, folder) : run(good, folder_ / "calm");
    std::string of_group_root = outcome;
    group_->broadcast(of_group_root);
    EXPECT_EQ(outcome, of_group_root);
    if (is_first_) {
      EXPECT_EQ(outcome.find(beginning), 0U) << outcome;
    } else {
      EXPECT_EQ(outcome.size(), 32U) << outcome;
    }
    world_.barrier();
  }

  Communicator world_{MPI_COMM_WORLD};
  ScratchFolder folder_{world_, "repose_side_by_side"};
  std::optional<Communicator> group_;
  bool is_first_ = false;
};

TEST_F(SideBySide, APhysicsErrorEndsOneRun) {
  expect_lonely_failure([](const std::string&) { return std::string(colliding); }, folder_ / "colliding", "3: step ");
}

TEST_F(SideBySide, AMistakeInAFileEndsOneRun) {
  expect_lonely_failure([](const std::string&) { return std::string("x;y\n"); }, folder_ / "bad", "2: grains.csv:1: ");
}

TEST_F(SideBySide, AFileThatCannotBeReadEndsOneRun) {
  // By one rank alone, as with a disk that only one of the nodes has lost.
  const bool fails_here = group_->rank() == group_->size() - 1;
  expect_lonely_failure(
      [&](const std::string& file) -> std::string {
        agree_after(*group_, [&] {
          if (fails_here) throw FileError(file + ": gone");
        });
        return calm;
      },
      folder_ / "gone", "4: grains.csv: gone");
}

TEST_F(SideBySide, APlaceThatCannotBeWrittenEndsOneRun) {
  if (world_.is_root()) std::ofstream(folder_ / "file") << "no folder";
  world_.barrier();
  expect_lonely_failure([](const std::string&) { return std::string(calm); }, folder_ / "file",
                        "4: " + (folder_ / "file"));
}

}  // namespace
}  // namespace repose::test
