// Empty space costs nothing: a pile from which a few grains fly far is the same work, list by list, in a small and in a
// large domain.
#include <gtest/gtest.h>

#include "simulation_counts.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

/// A stack of grains that falls apart on a floor, and eight grains that slide off over it at 2 m/s.
std::vector<Grain> scattering() {
  constexpr double r = 5e-4;
  std::vector<Grain> grains;
  for (int k = 0; k < 64; ++k) {
    grains.push_back({{2.1 * r * (k % 4) + 1e-5 * k, 2.1 * r * (k / 4 % 4), r + 2.1 * r * (k / 16)}, {}, {}, r});
  }
  const Vec3 ways[] = {{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {1, 2, 0}, {-2, 1, 0}, {2, -1, 0}, {-1, -2, 0}};
  for (const Vec3& way : ways) grains.push_back({0.005 * way + Vec3{3 * r, 3 * r, r}, way, {}, r});
  return grains;
}

struct Work {
  std::string hash;
  std::vector<std::int64_t> counts;
  bool operator==(const Work&) const = default;
};

Work work_in(double half_width) {
  Deck deck = bare_deck({}, 1e-5);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.domain = {{-half_width, -half_width, -0.001}, {half_width, half_width, 0.04}};
  deck.walls.push_back(floor_at(0.0));
  Scene scene(deck, scattering());
  scene.run(1200);
  const Simulation& s = scene.simulation();
  const auto all = [&](std::size_t here) { return s.comm().sum(static_cast<std::int64_t>(here)); };
  return {hash_of(s),
          {inside(s), s.counters().rebuilds, s.counters().inner_selections, s.counters().bisections,
           all(s.pairs().listed()), all(s.pairs().lanes()), all(s.particles().ghosts()), all(s.memory_bytes())}};
}

TEST(EmptySpace, CostsNothing) {
  const Work small = work_in(0.04);
  EXPECT_EQ(small.counts[0], 72);
  EXPECT_GT(small.counts[1], 2);
  for (const double half_width : {0.07, 0.7, 7.0}) EXPECT_EQ(work_in(half_width), small) << half_width;
}

}  // namespace
}  // namespace repose::test
