#include <algorithm>

#include <gtest/gtest.h>

#include "measurement/discharge.h"

namespace repose {
namespace {

/// Opens at 0.5 s, lets 0.02 kg/s through for 0.4 s, then is watched for 0.3 s more; sampled every 0.01 s.
DischargeRecord steady_flow() {
  DischargeRecord record;
  for (int k = 0; k <= 70; ++k) record.add(0.5 + 0.01 * k, 0.02 * 0.01 * std::min(k, 40));
  return record;
}

TEST(Discharge, OfASteadyFlow) {
  const Discharge d = steady_flow().result(0.010, 0.5);
  EXPECT_NEAR(d.mass, 0.008, 1e-15);
  EXPECT_NEAR(d.retained_mass, 0.002, 1e-15);
  ASSERT_TRUE(d.time && d.rate);
  EXPECT_NEAR(*d.time, 0.4, 1e-12);
  EXPECT_NEAR(*d.rate, 0.02, 1e-12);
  EXPECT_FALSE(d.plugged);
}

TEST(Discharge, RateLeavesOutStartAndTrickle) {
  DischargeRecord record;
  record.add(0.0, 0.0);
  record.add(0.2, 0.0);  // nothing yet
  for (int k = 1; k <= 90; ++k) record.add(0.2 + 0.001 * k, 0.01 * k);
  record.add(5.0, 1.0);
  const Discharge d = record.result(1.0, 0.5);
  ASSERT_TRUE(d.time && d.rate);
  EXPECT_NEAR(*d.time, 5.0, 1e-12);
  EXPECT_NEAR(*d.rate, 10.0, 1e-9);
}

TEST(Discharge, WithNothingOutIsPlugged) {
  DischargeRecord record;
  for (int k = 0; k < 10; ++k) record.add(k, 0.0);
  const Discharge d = record.result(1.0, 0.5);
  EXPECT_EQ(d.mass, 0.0);
  EXPECT_EQ(d.retained_mass, 1.0);
  EXPECT_FALSE(d.time);
  EXPECT_FALSE(d.rate);
  EXPECT_TRUE(d.plugged);
}

TEST(Discharge, OfAFewGrainsHasATimeButNoRate) {
  DischargeRecord record;
  for (int k = 0; k <= 10; ++k) record.add(0.1 * k, 0.001 * std::min(k, 5));
  const Discharge d = record.result(1.0, 0.5);
  ASSERT_TRUE(d.time);
  EXPECT_NEAR(*d.time, 0.5, 1e-12);
  EXPECT_FALSE(d.rate);
  EXPECT_TRUE(d.plugged);
}

TEST(Discharge, BetweenTwoSamplesHasNoRate) {
  DischargeRecord record;
  record.add(0.0, 0.0);
  record.add(1.0, 1.0);
  record.add(2.0, 1.0);
  EXPECT_FALSE(record.result(1.0, 0.5).rate);
}

TEST(Discharge, StillFlowingIsNotPlugged) {
  DischargeRecord record;
  for (int k = 0; k <= 10; ++k) record.add(0.1 * k, 0.01 * k);
  EXPECT_FALSE(record.result(1.0, 0.5).plugged);
  record.add(1.1, 0.1);
  EXPECT_TRUE(record.result(1.0, 0.5).plugged);
}

TEST(Discharge, DoesNotCountAGrainThatHopsAtTheOrifice) {
  DischargeRecord record = steady_flow();
  record.add(1.3, 0.0079);
  record.add(1.4, 0.0080);
  record.add(1.5, 0.0079);
  const Discharge d = record.result(0.010, 0.5);
  EXPECT_NEAR(d.mass, 0.0079, 1e-15);
  EXPECT_NEAR(*d.time, 0.4, 1e-12);
}

TEST(Discharge, GoesOnFromItsSamples) {
  DischargeRecord record = steady_flow();
  DischargeRecord restored(record.samples());
  EXPECT_LT(record.samples().size(), 45u);  // the quiet end is kept as two samples
  for (DischargeRecord* r : {&record, &restored}) {
    r->add(1.3, 0.008);
    r->add(1.4, 0.009);
  }
  const Discharge a = record.result(0.010, 0.5);
  const Discharge b = restored.result(0.010, 0.5);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(*a.time, *b.time);
  EXPECT_EQ(*a.rate, *b.rate);
  EXPECT_NEAR(*a.time, 0.9, 1e-12);
}

TEST(Discharge, WithoutSamplesHasKeptEverything) {
  const Discharge d = DischargeRecord{}.result(1.0, 0.5);
  EXPECT_EQ(d.retained_mass, 1.0);
  EXPECT_FALSE(d.time);
}

}  // namespace
}  // namespace repose
