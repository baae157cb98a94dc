#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "scene/insertion/overlap.h"
#include "scene_samples.h"

namespace repose {
namespace {

using Pairs = std::multiset<std::pair<std::size_t, std::size_t>>;

Pairs found_pairs(const std::vector<Vec3>& position, const std::vector<double>& radius) {
  Pairs pairs;
  for_each_overlap(position, radius, [&](std::size_t i, std::size_t j) { pairs.insert({i, j}); });
  return pairs;
}

Pairs brute_force(const std::vector<Vec3>& position, const std::vector<double>& radius) {
  Pairs pairs;
  for (std::size_t i = 0; i < position.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (norm(position[i] - position[j]) < radius[i] + radius[j]) pairs.insert({i, j});
    }
  }
  return pairs;
}

TEST(ForEachOverlap, FindsEachPairOnceWhateverTheSizes) {
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    position.push_back(draw_point(i, 0, 1.0));
    const double r = draw(i, 3, 0.01, 0.04);
    radius.push_back(i % 100 == 0 ? 10.0 * r : r);
  }
  const Pairs expected = brute_force(position, radius);
  EXPECT_GT(expected.size(), 100U);
  EXPECT_EQ(found_pairs(position, radius), expected);
}

TEST(ForEachOverlap, LeavesTouchingSpheresAlone) {
  EXPECT_TRUE(found_pairs({{0, 0, 0}, {1, 0, 0}}, {0.5, 0.5}).empty());
  EXPECT_EQ(found_pairs({{0, 0, 0}, {0.99, 0, 0}}, {0.5, 0.5}), (Pairs{{1, 0}}));
  EXPECT_TRUE(found_pairs({}, {}).empty());
}

}  // namespace
}  // namespace repose
