#include <csignal>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/file_seal.h"
#include "output/snapshot.h"
#include "output/snapshot_reader.h"
#include "output_samples.h"

namespace repose {
namespace {

class SnapshotTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const ParticleTable& table) {
    write_snapshot(comm_, folder_ / name, table, sample_header(table.total));
    comm_.barrier();
  }
  /// The bytes that one rank alone writes for `total` particles; on rank 0.
  std::string serial_bytes(std::int64_t total) {
    if (!comm_.is_root()) return {};
    const Communicator alone(MPI_COMM_SELF);
    write_snapshot(alone, folder_ / "serial.hdf", sample_table(alone, total), sample_header(total));
    return file_bytes(folder_ / "serial.hdf");
  }
  void expect_serial_bytes(std::int64_t total, Blocks blocks) {
    write("parallel.hdf", sample_table(comm_, total, blocks));
    const std::string expected = serial_bytes(total);
    if (!comm_.is_root()) return;
    const std::string actual = file_bytes(folder_ / "parallel.hdf");
    EXPECT_GT(actual.size(), 1000U);
    EXPECT_TRUE(actual == expected) << total << " particles: " << actual.size() << " and " << expected.size()
                                    << " bytes";
  }
  /// Writing must fail on every rank with a message that holds `reason`, and leave no partial file.
  void expect_failure(const std::string& path, const std::string& reason, std::int64_t total = 10) {
    std::string message = "no error";
    try {
      write_snapshot(comm_, path, sample_table(comm_, total), sample_header(total));
    } catch (const FileError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_NE(message.find(path), std::string::npos) << message;
    comm_.barrier();
    EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
  }

  Communicator comm_{MPI_COMM_WORLD};
  ScratchFolder folder_{comm_, "repose_snapshot_test"};
};

TEST_F(SnapshotTest, ReadsBackWhatWasWritten) {
  write("back.hdf", sample_table(comm_, 100));
  const std::string bytes = file_bytes(folder_ / "back.hdf");
  std::vector<MaterialDeck> materials(3);  // in another order than in the snapshot: glass, steel
  materials[0].name = "steel";
  materials[1].name = "wood";
  materials[2].name = "glass";
  const NewParticles particles = parse_snapshot(bytes, folder_ / "back.hdf", materials);  // as from the deck's folder
  const Communicator alone(MPI_COMM_SELF);
  const ParticleTable table = sample_table(alone, 100);
  ASSERT_EQ(particles.size(), 100U);
  for (std::size_t i = 0; i < 100; ++i) {
    const auto vector = [&](const std::vector<double>& v) { return Vec3{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
    EXPECT_EQ(particles.position[i], vector(table.position));
    EXPECT_EQ(particles.velocity[i], vector(table.velocity));
    EXPECT_EQ(particles.spin[i], vector(table.angular_velocity));
    EXPECT_EQ(particles.radius[i], table.radius[i]);
    EXPECT_EQ(particles.material[i], i % 2 == 0 ? 2 : 0);
  }
}

TEST_F(SnapshotTest, WhatIsNoSnapshotOrHasUnknownMaterialsIsNotRead) {
  write("back.hdf", sample_table(comm_, 10));
  const std::string bytes = file_bytes(folder_ / "back.hdf");
  const std::vector<MaterialDeck> none(1);
  const auto error_of = [&](const std::string& text) -> std::string {
    try {
      parse_snapshot(text, "back.hdf", none);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of(bytes), "back.hdf: no material is named \"glass\"; add it to the deck");
  EXPECT_EQ(error_of("x,y,z").find("back.hdf: cannot read as a snapshot"), 0U) << error_of("x,y,z");
  EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2)).find("back.hdf: its length, "), 0U);
  EXPECT_EQ(error_of("").find("back.hdf: cannot read"), 0U) << error_of("");
}

TEST_F(SnapshotTest, EveryFlippedBitIsNoticed) {
  write("seal.hdf", sample_table(comm_, 10));
  std::string bytes = file_bytes(folder_ / "seal.hdf");
  const std::size_t first = std::string("repose file of ").size();  // damaged before, it is no file of repose's
  for (std::size_t at = first; at < bytes.size(); at += at < 600 ? 1 : 37) {
    const char bit = static_cast<char>(1 << (at % 8));
    bytes[at] ^= bit;
    EXPECT_THROW(check_seal_if_any(bytes, "seal.hdf"), FileError) << at;
    bytes[at] ^= bit;
  }
  EXPECT_NO_THROW(check_seal_if_any(bytes, "seal.hdf"));
  check_seal(comm_, folder_ / "seal.hdf");
}

TEST_F(SnapshotTest, BytesDoNotDependOnRanksOrBlocks) {
  for (const Blocks blocks : {Blocks::even, Blocks::all_on_last, Blocks::none_on_first}) {
    expect_serial_bytes(100, blocks);
    expect_serial_bytes(2, blocks);
    expect_serial_bytes(50000, blocks);   // blocks of many pages that share a chunk
    expect_serial_bytes(300000, blocks);  // two chunks
  }
}

TEST_F(SnapshotTest, BytesOfNoParticles) { expect_serial_bytes(0, Blocks::even); }

TEST_F(SnapshotTest, ReplacesAnOldSnapshot) {
  write("a.hdf", sample_table(comm_, 1000));
  const std::string first = file_bytes(folder_ / "a.hdf");
  write("a.hdf", sample_table(comm_, 10));
  EXPECT_NE(file_bytes(folder_ / "a.hdf"), first);
  write("a.hdf", sample_table(comm_, 1000));
  EXPECT_TRUE(file_bytes(folder_ / "a.hdf") == first);
}

TEST_F(SnapshotTest, FolderMissing) { expect_failure(folder_ / "missing/a.hdf", "No such file or directory"); }

TEST_F(SnapshotTest, FolderThatTakesNoFiles) { expect_failure("/proc/a.hdf", "/proc/a.hdf: cannot open: "); }

TEST_F(SnapshotTest, NameOfAFolder) {
  if (comm_.is_root()) std::filesystem::create_directory(folder_ / "folder.hdf");
  comm_.barrier();
  expect_failure(folder_ / "folder.hdf", "not a regular file");
}

TEST_F(SnapshotTest, NameWithoutHdf) { expect_failure(folder_ / "a.h5", "must end in .hdf"); }

TEST_F(SnapshotTest, TableThatDisagreesAmongRanks) {
  ParticleTable table = sample_table(comm_, 10);
  table.total = 11;
  EXPECT_THROW(write("a.hdf", table), FileError);
  table = sample_table(comm_, 10);
  if (comm_.is_root()) table.mass.push_back(1.0);  // only one rank sees it, all must stop
  EXPECT_THROW(write("a.hdf", table), FileError);
  comm_.barrier();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.hdf"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.hdf.partial"));
}

/// A file size limit stands for a full disk: writes fail in the middle of the file.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &old_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
};

TEST_F(SnapshotTest, DiskFull) {
  write("kept.hdf", sample_table(comm_, 10));
  const std::string before = file_bytes(folder_ / "kept.hdf");
  for (const rlim_t bytes : {0U, 100000U, 2000000U}) {
    const FileSizeLimit limit(bytes);
    expect_failure(folder_ / "kept.hdf", "cannot reserve space: File too large", 50000);
  }
  EXPECT_EQ(file_bytes(folder_ / "kept.hdf"), before);
  write("after.hdf", sample_table(comm_, 10));
  EXPECT_TRUE(file_bytes(folder_ / "after.hdf") == before);
}

TEST(AgreementTest, OneRankStopsAll) {
  const Communicator comm(MPI_COMM_WORLD);
  std::string message;
  try {
    agree_after(comm, [&] {
      if (comm.rank() == comm.size() - 1) throw std::runtime_error("the last rank failed");
    });
  } catch (const FileError& error) {
    message = error.what();
  }
  EXPECT_EQ(message, "the last rank failed");
  EXPECT_NO_THROW(agree_after(comm, [] {}));
  EXPECT_THROW(agree_after_root(comm, [] { throw std::runtime_error("root"); }), FileError);
}

}  // namespace
}  // namespace repose
