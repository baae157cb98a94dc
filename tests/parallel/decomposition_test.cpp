// Recursive bisection: balance, one owner for every place, the same tree on all ranks, degenerate clouds.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "domain_samples.h"

namespace repose::test {
namespace {

class DecompositionTest : public ::testing::Test {
 protected:
  const Communicator world{MPI_COMM_WORLD};

  /// All ranks must agree on the owner of `x`, and it must be a rank.
  int agreed_owner(const Decomposition& tree, const Vec3& x) const {
    const int owner = tree.owner(x);
    EXPECT_EQ(world.min(owner), world.max(owner));
    EXPECT_GE(owner, 0);
    EXPECT_LT(owner, world.size());
    return owner;
  }
  /// Cost of the busiest rank over the mean, of the particles 0 to count - 1.
  double imbalance(const Decomposition& tree, std::int64_t count, const std::vector<std::int64_t>& cost_of) const {
    std::vector<std::int64_t> cost(static_cast<std::size_t>(world.size()), 0);
    std::int64_t total = 0;
    for (std::int64_t id = 0; id < count; ++id) {
      const std::int64_t c = cost_of[static_cast<std::size_t>(id)];
      cost[static_cast<std::size_t>(tree.owner(sample(id).record.position))] += c;
      total += c;
    }
    return static_cast<double>(*std::max_element(cost.begin(), cost.end())) * world.size() / static_cast<double>(total);
  }
};

Decomposition bisect_samples(const Communicator& comm, std::int64_t count, const std::vector<std::int64_t>& cost_of) {
  std::vector<Vec3> positions;
  std::vector<std::int64_t> cost;
  for (std::int64_t id = comm.rank(); id < count; id += comm.size()) {
    positions.push_back(sample(id).record.position);
    cost.push_back(cost_of[static_cast<std::size_t>(id)]);
  }
  return Decomposition::bisect(comm, positions, cost);
}

// The planes are found to 128^-4 of a side: a rank is off by a particle or two at each of up to three levels.
TEST_F(DecompositionTest, BalancesAClusteredCloud) {
  const std::vector<std::int64_t> equal(4000, 1);
  EXPECT_LT(imbalance(bisect_samples(world, 4000, equal), 4000, equal), 1.02);
}

TEST_F(DecompositionTest, BalancesTheCostNotTheNumber) {
  std::vector<std::int64_t> cost(4000);
  for (std::size_t id = 0; id < 4000; ++id) {
    const Vec3 x = sample(static_cast<std::int64_t>(id)).record.position;
    cost[id] = std::max({x.x, x.y, x.z}) < 0.2 ? 20 : 1;  // one corner
  }
  const Decomposition tree = bisect_samples(world, 4000, cost);
  EXPECT_LT(imbalance(tree, 4000, cost), 1.10);
  if (world.size() > 1) {
    EXPECT_GT(imbalance(tree, 4000, std::vector<std::int64_t>(4000, 1)), 1.10);
  }
}

// A division into more parts than there are ranks, as for the imagined runs of benchmarks/scaling.
TEST_F(DecompositionTest, AnyNumberOfParts) {
  std::vector<Vec3> positions;
  for (std::int64_t id = world.rank(); id < 4000; id += world.size()) positions.push_back(sample(id).record.position);
  const std::vector<std::int64_t> cost(positions.size(), 1);
  for (const int parts : {1, 3, 40}) {
    const Decomposition tree = Decomposition::bisect(world, parts, positions, cost);
    std::vector<std::int64_t> owned(static_cast<std::size_t>(parts), 0);
    for (const Vec3& x : positions) ++owned[static_cast<std::size_t>(tree.owner(x))];
    world.sum_elements(std::span(owned));
    for (const std::int64_t count : owned) EXPECT_NEAR(static_cast<double>(count), 4000.0 / parts, 6.0) << parts;
  }
}

TEST_F(DecompositionTest, DoesNotDependOnWhoHoldsTheParticles) {
  const std::vector<std::int64_t> equal(500, 1);
  const Decomposition in_turn = bisect_samples(world, 500, equal);
  std::vector<Vec3> positions;
  if (world.rank() == world.size() - 1) {
    for (std::int64_t id = 499; id >= 0; --id) positions.push_back(sample(id).record.position);
  }
  const Decomposition from_one =
      Decomposition::bisect(world, positions, std::vector<std::int64_t>(positions.size(), 1));
  Draw draw(81);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 x = draw.vector(1.2);
    EXPECT_EQ(in_turn.owner(x), from_one.owner(x));
  }
}

TEST_F(DecompositionTest, AllRanksHoldTheSameTree) {
  const Decomposition tree = bisect_samples(world, 500, std::vector<std::int64_t>(500, 1));
  Draw draw(82);
  for (int trial = 0; trial < 200; ++trial) agreed_owner(tree, draw.vector(2.0));
  agreed_owner(tree, {1e20, 0.0, 0.0});
  agreed_owner(tree, {-1e20, 1e20, -1e20});
}

/// The coordinates at which the owner changes along a line through the cloud.
std::vector<double> planes_along(const Decomposition& tree, const Vec3& start, double Vec3::*axis) {
  std::vector<double> planes;
  Vec3 from = start;
  for (int k = 0; k < 200; ++k) {
    Vec3 low = from;
    low.*axis = -0.1 + 0.006 * k;
    Vec3 high = low;
    high.*axis += 0.006;
    const int below = tree.owner(low);
    if (tree.owner(high) == below) continue;
    while (std::nextafter(low.*axis, 2.0) < high.*axis) {
      Vec3 middle = low;
      middle.*axis = 0.5 * (low.*axis + high.*axis);
      Vec3& end = tree.owner(middle) == below ? low : high;
      end = middle;
    }
    planes.push_back(high.*axis);
  }
  return planes;
}

// Particles exactly in the corners, on the edges and on the faces of the boxes.
TEST_F(DecompositionTest, FacesEdgesAndCornersHaveOneOwner) {
  const Decomposition tree = bisect_samples(world, 2000, std::vector<std::int64_t>(2000, 1));
  std::vector<double> xs = {0.0, 0.11};
  std::vector<double> ys = {0.0, 0.12};
  std::vector<double> zs = {0.0, 0.13};
  Draw draw(83);
  for (int line = 0; line < 8; ++line) {
    const Vec3 start = {draw(0.0, 0.5), draw(0.0, 0.5), draw(0.0, 0.5)};
    for (const double x : planes_along(tree, start, &Vec3::x)) xs.push_back(x);
    for (const double y : planes_along(tree, start, &Vec3::y)) ys.push_back(y);
    for (const double z : planes_along(tree, start, &Vec3::z)) zs.push_back(z);
  }
  if (world.size() > 1) {
    EXPECT_GT(xs.size() + ys.size() + zs.size(), 6U);
  }
  std::size_t shared = 0;
  for (const double x : xs) {
    for (const double y : ys) {
      for (const double z : zs) {
        const Vec3 at = {x, y, z};
        const int owner = tree.owner(at);
        std::map<int, int> near;
        tree.for_each_rank_near(at, 1e-9, [&](int rank, double) { ++near[rank]; });
        EXPECT_EQ(near[owner], 1);
        for (const auto& [rank, times] : near) EXPECT_EQ(times, 1);
        shared += near.size() > 1 ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(shared > 0, world.size() > 1);
}

TEST_F(DecompositionTest, OwnerIsTheRankAtNoDistance) {
  const Decomposition tree = bisect_samples(world, 2000, std::vector<std::int64_t>(2000, 1));
  Draw draw(84);
  for (int trial = 0; trial < 5000; ++trial) {
    const Vec3 x = draw.vector(1.1);
    std::vector<int> near;
    tree.for_each_rank_near(x, 1e-150, [&](int rank, double squared) {
      near.push_back(rank);
      EXPECT_EQ(squared, 0.0);
    });
    ASSERT_EQ(near.size(), 1U);  // no trial is on a plane
    EXPECT_EQ(near[0], tree.owner(x));
  }
}

// The box of a rank is at least as near as any place that it owns.
TEST_F(DecompositionTest, NearRanksAreFound) {
  const Decomposition tree = bisect_samples(world, 2000, std::vector<std::int64_t>(2000, 1));
  Draw draw(85);
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 x = draw.vector(1.0);
    const Vec3 y = x + draw(0.0, 0.5) * draw.direction();
    const double distance = norm(y - x);
    std::map<int, double> near;
    tree.for_each_rank_near(x, distance * (1.0 + 1e-12), [&](int rank, double squared) {
      EXPECT_FALSE(near.contains(rank));
      near[rank] = squared;
    });
    const auto found = near.find(tree.owner(y));
    ASSERT_NE(found, near.end());
    EXPECT_LE(found->second, distance * distance * (1.0 + 1e-12));
  }
}

// The distance is that of a box, not merely a bound: ranks far away are left alone.
TEST_F(DecompositionTest, FarRanksAreLeftAlone) {
  const Decomposition tree = bisect_samples(world, 2000, std::vector<std::int64_t>(2000, 1));
  Draw draw(86);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3 x = {draw(0.0, 1.0), draw(0.0, 1.0), draw(0.0, 1.0)};
    std::vector<double> nearest(static_cast<std::size_t>(world.size()), 1e300);  // of the places tried
    for (int place = 0; place < 300; ++place) {
      const Vec3 y = x + draw(0.0, 0.12) * draw.direction();
      double& distance = nearest[static_cast<std::size_t>(tree.owner(y))];
      distance = std::min(distance, norm(y - x));
    }
    tree.for_each_rank_near(x, 0.01, [&](int rank, double) {
      EXPECT_LT(nearest[static_cast<std::size_t>(rank)], 0.12) << "a rank that owns nothing within 0.12 was called";
    });
  }
}

TEST_F(DecompositionTest, WithoutBisectionAllBelongsToTheFirst) {
  const Decomposition tree(world.size());
  EXPECT_EQ(tree.owner({1.0, -2.0, 3.0}), 0);
}

TEST_F(DecompositionTest, FewOrNoParticles) {
  for (const std::int64_t count : {0, 1, 2, 3, 5}) {
    const Decomposition tree =
        bisect_samples(world, count, std::vector<std::int64_t>(static_cast<std::size_t>(count), 7));
    std::map<int, int> owned;
    for (std::int64_t id = 0; id < count; ++id) ++owned[agreed_owner(tree, sample(id).record.position)];
    if (count > 0 && world.size() % 2 == 0) {
      EXPECT_LE(owned.begin()->second, std::max<std::int64_t>(1, count - 1)) << count;  // they were divided at all
    }
  }
}

TEST_F(DecompositionTest, AllParticlesAtOnePlace) {
  for (const Vec3& place : {Vec3{}, Vec3{5.0, -3.0, 2.0}, Vec3{-5.0, 3.0, -2.0}}) {
    const std::vector<Vec3> positions(10, place);
    const Decomposition tree = Decomposition::bisect(world, positions, std::vector<std::int64_t>(10, 1));
    agreed_owner(tree, place);
  }
}

TEST_F(DecompositionTest, AllParticlesOnALine) {
  std::vector<Vec3> positions;
  for (int k = world.rank(); k < 800; k += world.size()) positions.push_back({0.0, 3.0, -0.01 * k});
  const Decomposition tree = Decomposition::bisect(world, positions, std::vector<std::int64_t>(positions.size(), 1));
  std::map<int, int> owned;
  for (int k = 0; k < 800; ++k) ++owned[tree.owner({0.0, 3.0, -0.01 * k})];
  EXPECT_EQ(owned.size(), static_cast<std::size_t>(world.size()));
  for (const auto& [rank, count] : owned) EXPECT_NEAR(count, 800.0 / world.size(), 3.0) << rank;
}

}  // namespace
}  // namespace repose::test
