// The order of particles in memory.
#include <algorithm>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "domain/layer_order.h"
#include "support/draw.h"

namespace repose::test {
namespace {

/// Grains of 1 m that touch one another, a lattice of so many along each axis, in a random order.
std::vector<ParticleRecord> shuffled_lattice(int nx, int ny, int nz) {
  std::vector<ParticleRecord> records;
  for (int n = 0; n < nx * ny * nz; ++n) {
    records.push_back({});
    records.back().position = Vec3{n % nx + 0.125, n / nx % ny + 0.25, n / (nx * ny) + 0.5};
    records.back().radius = 0.5;
  }
  std::shuffle(records.begin(), records.end(), std::mt19937(61));
  return records;
}

std::vector<Vec3> in_layers(const std::vector<ParticleRecord>& records) {
  const std::vector<std::int64_t> ids(records.size(), 0);
  std::vector<Vec3> places;
  for (const std::size_t i : layer_order(records, ids)) places.push_back(records[i].position);
  return places;
}

TEST(LayerOrder, GoesByLayersAcrossTheLongestSideAndThenByRows) {
  const std::vector<Vec3> places = in_layers(shuffled_lattice(3, 4, 2));
  ASSERT_EQ(places.size(), 24U);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Vec3& a = places[k - 1];
    const Vec3& b = places[k];
    EXPECT_LT(std::tie(a.y, a.x, a.z), std::tie(b.y, b.x, b.z)) << k;  // all places differ: each once
  }
  EXPECT_TRUE(layer_order({}, {}).empty());
}

TEST(LayerOrder, CutsLargeLayersIntoStrips) {
  const std::vector<Vec3> places = in_layers(shuffled_lattice(50, 52, 48));  // 2400 grains in a layer across y
  ASSERT_EQ(places.size(), 124800U);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const bool before = places[k - 1].x < 25.0;
    const bool here = places[k].x < 25.0;
    ASSERT_TRUE(before || !here) << k;
    if (before == here) {
      ASSERT_LE(places[k - 1].y, places[k].y) << k;
    }
  }
}

TEST(LayerOrder, DoesNotDependOnTheOrderBefore) {
  Draw draw(62);
  std::vector<ParticleRecord> records(100);
  std::vector<std::int64_t> ids(100);
  for (std::size_t i = 0; i < 100; ++i) {
    records[i].position = i % 10 == 0 ? Vec3{} : draw.vector(1.0);  // ten at one place: the id decides
    ids[i] = static_cast<std::int64_t>(i);
  }
  std::vector<ParticleRecord> reversed(records.rbegin(), records.rend());
  std::vector<std::int64_t> reversed_ids(ids.rbegin(), ids.rend());
  const std::vector<std::size_t> order = layer_order(records, ids);
  const std::vector<std::size_t> other = layer_order(reversed, reversed_ids);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(order[k], 99 - other[k]);
}

}  // namespace
}  // namespace repose::test
