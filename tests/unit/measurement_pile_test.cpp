#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "measurement/clusters.h"
#include "measurement/pile.h"
#include "measurement_piles.h"

namespace repose {
namespace {

using test::diameter;
constexpr double everything = std::numeric_limits<double>::infinity();

bool same(const Sphere& a, const Sphere& b) { return a.centre == b.centre && a.radius == b.radius; }

/// Clusters by looking at every pair, again and again until nothing changes.
std::vector<std::size_t> clusters_by_brute_force(const std::vector<Sphere>& grains, double gap) {
  std::vector<std::size_t> label(grains.size());
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < grains.size(); ++i) {
      for (std::size_t j = 0; j < grains.size(); ++j) {
        const double surface = norm(grains[i].centre - grains[j].centre) - grains[i].radius - grains[j].radius;
        if (surface > gap * 2.0 * std::min(grains[i].radius, grains[j].radius) || label[i] <= label[j]) continue;
        label[i] = label[j];
        changed = true;
      }
    }
  }
  std::vector<std::size_t> number(grains.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) number[i] = label[i] == i ? count++ : number[label[i]];
  return number;
}

TEST(Clusters, AgreeWithBruteForceForSizesOverTwoDecades) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::uniform_real_distribution<double> exponent(-2.4, -0.4);
  std::vector<Sphere> grains;
  for (int k = 0; k < 700; ++k) {
    const Vec3 p{place(random), place(random), place(random)};
    grains.push_back({p, 0.5 * std::pow(10.0, exponent(random))});
  }
  grains.push_back({{3.0, 0.0, 0.0}, 0.001});
  for (const double gap : {0.0, 0.05, 1.0}) {
    EXPECT_EQ(touching_clusters(grains, gap), clusters_by_brute_force(grains, gap)) << "gap " << gap;
  }
}

TEST(Clusters, TouchUpToTheGap) {
  const auto clusters = [](double distance) {
    return touching_clusters(std::vector<Sphere>{{{0.0, 0.0, 0.0}, 2.0}, {{0.0, distance, 0.0}, 1.0}}, 0.05);
  };
  EXPECT_EQ(clusters(3.0999), (std::vector<std::size_t>{0, 0}));
  EXPECT_EQ(clusters(3.1001), (std::vector<std::size_t>{0, 1}));
}

/// Each pair on its own: in a crowd a contact that is overlooked is replaced by a way round it.
TEST(Clusters, FindEveryPairWhereverItLies) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 5000; ++k) {
    const Vec3 place{uniform(random), uniform(random), uniform(random)};
    const Vec3 away{uniform(random), uniform(random), uniform(random)};
    const Sphere first{place, 0.1};
    const Sphere second{place + 0.999 * (0.1 + 0.08) / norm(away) * away, 0.08};
    EXPECT_EQ(touching_clusters(std::vector<Sphere>{first, second}, 0.0), (std::vector<std::size_t>{0, 0})) << k;
  }
}

TEST(Pile, IsTheWholeHeapAndNothingElse) {
  const std::vector<Sphere> heap = test::cone(5e-3, 30.0);
  std::vector<Sphere> grains = heap;
  test::add_strays(grains, 50, 10e-3, 15e-3, 1);
  test::add_airborne(grains, 20, 15e-3, 10e-3, 2);
  const std::vector<Sphere> pile = find_pile(grains, 0.0, everything);
  ASSERT_EQ(pile.size(), heap.size());
  for (std::size_t i = 0; i < pile.size(); ++i) EXPECT_TRUE(same(pile[i], heap[i])) << i;
}

TEST(Pile, LeavesOutWhatIsAboveTheOrificeOrBelowThePlate) {
  std::vector<Sphere> grains = test::cone(5e-3, 30.0);
  const std::size_t count = grains.size();
  Sphere top = *std::max_element(grains.begin(), grains.end(),
                                 [](const Sphere& a, const Sphere& b) { return a.centre.z < b.centre.z; });
  top.centre.z += diameter;  // a grain that sits on the top one
  grains.push_back(top);
  grains.push_back({{0.0, 0.0, -0.2e-3}, 0.5 * diameter});
  EXPECT_EQ(find_pile(grains, 0.0, top.centre.z - 1e-6).size(), count);
  EXPECT_EQ(find_pile(grains, 0.0, top.centre.z + 1e-6).size(), count + 1);
}

TEST(Pile, IsTheOneWithMostVolumeThatStandsOnThePlate) {
  std::vector<Sphere> grains = test::cone(3e-3, 30.0);
  const std::size_t count = grains.size();
  for (Sphere s : test::cone(4e-3, 30.0)) {  // in the funnel
    s.centre.z += 20e-3;
    grains.push_back(s);
  }
  for (Sphere s : test::cone(2e-3, 30.0)) {
    s.centre.x += 20e-3;
    grains.push_back(s);
  }
  grains.push_back({{-20e-3, 0.0, 5e-3}, 5e-3});  // one large ball is no pile
  const std::vector<Sphere> pile = find_pile(grains, 0.0, everything);
  ASSERT_EQ(pile.size(), count);
  EXPECT_TRUE(same(pile.front(), grains.front()));
}

TEST(Pile, OfMixedSizesIsConnectedThroughItsSmallGrains) {
  std::vector<Sphere> grains = test::cone(5e-3, 30.0);
  const std::size_t count = grains.size();
  // A bridge of small grains along the plate to a large one; and a small one that touches nothing.
  const double small = 0.05e-3;
  double x = 0.0;
  for (const Sphere& s : grains) x = std::max(x, s.centre.y == 0.0 ? s.centre.x : 0.0);
  const double dz = 0.5 * diameter - small;
  x += std::sqrt(std::pow(0.5 * diameter + small, 2) - dz * dz);
  for (int k = 0; k < 5; ++k) grains.push_back({{x + 2.0 * small * k, 0.0, small}, small});
  const double large = 1e-3;
  const double reach = std::sqrt(std::pow(large + small, 2) - std::pow(large - small, 2));
  grains.push_back({{x + 8.0 * small + reach, 0.0, large}, large});
  grains.push_back({{-20e-3, 0.0, small}, small});
  EXPECT_EQ(find_pile(grains, 0.0, everything).size(), count + 6);
}

TEST(Pile, IsAbsentWhereThereIsNone) {
  EXPECT_TRUE(find_pile({}, 0.0, everything).empty());

  std::vector<Sphere> monolayer;
  for (int i = 0; i < 400; ++i) {
    monolayer.push_back({{i % 20 * diameter, i / 20 * diameter, 0.5 * diameter}, 0.5 * diameter});
  }
  EXPECT_TRUE(find_pile(monolayer, 0.0, everything).empty());
  std::vector<Sphere> bilayer = monolayer;
  for (Sphere s : monolayer) {
    s.centre.z += diameter;
    bilayer.push_back(s);
  }
  EXPECT_TRUE(find_pile(bilayer, 0.0, everything).empty());

  std::vector<Sphere> airborne;
  test::add_airborne(airborne, 20, 15e-3, 10e-3, 3);
  EXPECT_TRUE(find_pile(airborne, 0.0, everything).empty());

  std::vector<Sphere> hanging = test::cone(5e-3, 30.0);
  for (Sphere& s : hanging) s.centre.z += 1e-3;
  EXPECT_TRUE(find_pile(hanging, 0.0, everything).empty());
}

}  // namespace
}  // namespace repose
