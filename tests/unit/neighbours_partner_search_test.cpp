// The partners of single particles against brute force.
#include <algorithm>

#include <gtest/gtest.h>

#include "neighbours/partner_search.h"
#include "neighbours_samples.h"

namespace repose::test {
namespace {

constexpr SkinRule outer = {0.3, 8e-5};
constexpr SkinRule inner = {0.02, 8e-6};

std::vector<std::int32_t> by_brute_force(const Particles& p, const SkinWatch& watch, std::int32_t i) {
  std::vector<std::int32_t> partners;
  const ReachSphere a = watch.outer_sphere(p, static_cast<std::size_t>(i));
  for (std::size_t j = 0; j < p.owned; ++j) {
    const ReachSphere b = watch.outer_sphere(p, j);
    const double limit = a.reach + b.reach;
    const bool near = squared_norm(a.position - b.position) < limit * limit;
    if (near && static_cast<std::int32_t>(j) != i && !is_parked(p.record[j])) {
      partners.push_back(static_cast<std::int32_t>(j));
    }
  }
  return partners;
}

/// A third are ghosts. In each of ten turns some particles go elsewhere with another speed, and one is parked.
std::size_t compare(const CloudOptions& options) {
  Draw draw(61);
  Particles p = random_cloud(62, options);
  SkinWatch watch(inner, outer);
  watch.begin_outer(p);
  PartnerSearch search;
  search.begin(sort_into_levels(std::span(p.record).first(p.total()), reaches(p, outer)), p.owned);
  std::size_t found = 0;
  for (int turn = 0; turn < 10; ++turn) {
    std::vector<std::int32_t> moved;
    for (int k = 0; k < 8; ++k) {
      const std::size_t i = draw.below(p.owned);
      const auto index = static_cast<std::int32_t>(i);
      if (is_parked(p.record[i]) || std::find(moved.begin(), moved.end(), index) != moved.end()) continue;
      p.record[i].position = draw.vector(0.7 * options.box);  // some leave the cloud
      p.record[i].velocity = draw.vector(draw(0.0, 1.0) < 0.2 ? 20.0 : 0.5);
      watch.begin_outer(p, i);
      moved.push_back(index);
    }
    search.renew(p, watch, moved);
    p.record[draw.below(p.owned)].position.x = parking_distance;
    for (const std::int32_t i : moved) {
      const std::span<const std::int32_t> partners = search.partners(p, watch, i);
      std::vector<std::int32_t> sorted(partners.begin(), partners.end());
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(sorted, by_brute_force(p, watch, i)) << "turn " << turn;
      found += sorted.size();
    }
  }
  return found;
}

TEST(PartnerSearch, FindsThoseOfBruteForce) {
  EXPECT_GT(compare({.count = 600, .box = 0.02, .speed = 0.0}), 100U);
  EXPECT_GT(compare({.count = 900, .smallest = 2e-4, .largest = 2e-3, .box = 0.02}), 100U);
  EXPECT_GT(compare({.count = 900, .smallest = 1e-4, .largest = 5e-3, .box = 0.04}), 100U);
  EXPECT_GT(compare({.count = 600, .smallest = 2e-4, .largest = 2e-3, .box = 0.02, .fast_share = 0.05}), 100U);
  compare({.count = 300, .box = 0.3});
  compare({.count = 3});
}

TEST(PartnerSearch, ReachesBeyondTheCells) {
  Particles p = random_cloud(63, {.count = 60, .box = 1e9});
  p.owned = p.total();
  SkinWatch watch(inner, outer);
  watch.begin_outer(p);
  PartnerSearch search;
  search.begin(sort_into_levels(std::span(p.record).first(p.total()), reaches(p, outer)), p.owned);
  p.record[7].velocity = {8e12, 0.0, 0.0};
  watch.begin_outer(p, 7);
  search.renew(p, watch, std::vector<std::int32_t>{7});
  EXPECT_GT(search.partners(p, watch, 7).size(), 10U);
  EXPECT_EQ(search.partners(p, watch, 7).size(), by_brute_force(p, watch, 7).size());
}

}  // namespace
}  // namespace repose::test
