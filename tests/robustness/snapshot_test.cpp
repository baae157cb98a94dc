// HDF5 files that are valid as such, and no snapshots or poor ones, are refused in one line.
#include <gtest/gtest.h>

#include "base/error.h"
#include "fuzz/hdf5_image.h"
#include "output/snapshot_reader.h"

namespace repose {
namespace {

const std::string position = "/particles/position f64 2x3 = 0.1 0 -1e-3 1 2 3\n";
const std::string velocity = "/particles/velocity f64 2x3 = 0 0 0 0 0 -1\n";
const std::string spin = "/particles/angular_velocity f64 2x3 = 0 0 0 1 0 0\n";
const std::string radius = "/particles/radius f64 2 chunk 1 deflate = 1e-4 2e-4\n";
const std::string material = "/particles/material i32 2 = 0 1\n";
const std::string names = "@materials text 2 = glass steel\n";
const std::string all = position + velocity + spin + radius + material + names;

NewParticles read(const std::string& items) {
  std::vector<MaterialDeck> materials(2);
  materials[0].name = "steel";
  materials[1].name = "glass";
  return parse_snapshot(fuzz::hdf5_image(fuzz::parse_hdf5_items(items)), "state.hdf", materials);
}

void expect_refusal(const std::string& part, const std::string& instead, const std::string& problem) {
  std::string items = all;
  items.replace(items.find(part), part.size(), instead);
  std::string message = "no error";
  try {
    read(items);
  } catch (const Error& error) {
    message = error.what();
  }
  SCOPED_TRACE(instead);
  EXPECT_EQ(message.find("state.hdf: "), 0U) << message;
  EXPECT_NE(message.find(problem), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(PoorSnapshot, AGoodOneIsRead) {
  const NewParticles particles = read(all);
  ASSERT_EQ(particles.size(), 2U);
  EXPECT_EQ(particles.position[1], (Vec3{1, 2, 3}));
  EXPECT_EQ(particles.radius, (std::vector<double>{1e-4, 2e-4}));
  EXPECT_EQ(particles.material, (std::vector<int>{1, 0}));
}

TEST(PoorSnapshot, LacksAPart) {
  expect_refusal(position, "", "cannot read /particles/position");
  expect_refusal(material, "", "cannot read /particles/material");
  expect_refusal(names, "", "cannot read the attribute materials");
  expect_refusal(all, "/x f64 1 = 1\n", "cannot read /particles/position");
}

TEST(PoorSnapshot, IsACheckpoint) {
  expect_refusal(names, "@repose_checkpoint i64 1 = 1\n", "is a checkpoint, no snapshot");
}

TEST(PoorSnapshot, HasArraysOfAnotherKind) {
  expect_refusal(radius, "/particles/radius i32 2 = 1 1\n", "is not of real numbers");
  expect_refusal(radius, "/particles/radius text 2 = 1 1\n", "is not of real numbers");
  expect_refusal(radius, "/particles/radius compound 2 = 1 1\n", "is not of real numbers");
  expect_refusal(material, "/particles/material f64 2 = 0 1\n", "is not of integers");
  expect_refusal(radius, "/particles/radius f64 2x1 = 1 1\n", "has not the right columns");
  expect_refusal(radius, "/particles/radius f64 null =\n", "has not the right columns");
  expect_refusal(position, "/particles/position f64 6 = 1 2 3 4 5 6\n", "has not the right columns");
  expect_refusal(position, "/particles/position f64 3x2 = 1 2 3 4 5 6\n", "has not the right columns");
  expect_refusal(position, "/particles/position f64 3x3 = 1 2 3 4 5 6 7 8 9\n", "differ in length");
  expect_refusal(names, "@materials fixed_text 2 = glass steel\n", "cannot read the attribute materials");
  expect_refusal(names, "@materials f64 2 = 1 2\n", "cannot read the attribute materials");
}

TEST(PoorSnapshot, AGreatSizeIsNoMemory) {
  expect_refusal(radius, "/particles/radius f64 1152921504606846976 =\n", "more values than the file can hold");
  expect_refusal(radius, "/particles/radius f64 1152921504606846976 chunk 1000 = 1\n",
                 "more values than the file can hold");
  expect_refusal(position, "/particles/position f64 100000000000000000x3 =\n", "more values than the file can hold");
  expect_refusal(radius, "/particles/radius f64 2 =\n", "has no values");
}

TEST(PoorSnapshot, OpensNoOtherFile) {
  expect_refusal(radius, "/particles/radius f64 2 in /dev/zero =\n", "lies in another file");
  expect_refusal(radius, "/particles/radius link /dev/zero:/radius\n", "cannot read /particles/radius");
  expect_refusal(all, "/particles link /dev/zero:/particles\n", "cannot read /particles/position");
}

TEST(PoorSnapshot, HasNumbersThatMeanNothing) {
  expect_refusal("1e-4 2e-4", "1e-4 0", "row 1 of /particles/radius is 0; a radius is positive");
  expect_refusal("1e-4 2e-4", "-1 2e-4", "row 0 of /particles/radius is -1");
  expect_refusal("1e-4 2e-4", "inf 2e-4", "row 0 of /particles/radius is inf");
  expect_refusal("1 2 3\n", "1 nan 3\n", "row 1 of /particles has a number that is not finite");
  expect_refusal("0 0 -1\n", "0 0 inf\n", "row 1 of /particles has a number that is not finite");
  expect_refusal("= 0 1\n", "= 0 2\n", "material 2 has no name");
  expect_refusal("= 0 1\n", "= -1 1\n", "material -1 has no name");
  expect_refusal("glass steel", "glass wood", "no material is named \"wood\"");
  expect_refusal("glass steel", "glass", "no material is named \"\"");  // names that were never written
}

}  // namespace
}  // namespace repose
