#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/math.h"
#include "scene/insertion/lattice.h"
#include "scene/insertion/overlap.h"
#include "scene/insertion/random_fill.h"
#include "scene/insertion/region.h"
#include "scene_walls.h"

namespace repose {
namespace {

/// A cone frustum of 8 and 6 mm radius, 10 mm high.
ParticlesDeck frustum() {
  ParticlesDeck deck;
  deck.centre = {1e-3, 2e-3, 3e-3};
  deck.radius = 8e-3;
  deck.radius_top = 6e-3;
  deck.height = 10e-3;
  return deck;
}

/// Radii from 0.1 to 1 mm, the small ones more frequent; 20 % of the frustum's volume.
std::vector<double> radii() {
  std::vector<double> all;
  for (double volume = 0.0; volume < 0.2 * region_size(frustum());) {
    const double r = 1e-3 / (1.0 + static_cast<double>(all.size() % 10));
    volume += 4.0 / 3.0 * pi * r * r * r;
    all.push_back(r);
  }
  return all;
}

TEST(RandomFill, SpheresLieInTheRegionApartFromOthersAndWalls) {
  const std::vector<double> r = radii();
  const std::vector<Wall> walls = {plane_wall({0.0, 0.0, 4e-3}, {0.0, 0.0, 1.0})};
  const std::vector<Vec3> positions = random_fill(frustum(), r, 0, 1, walls, "block");
  ASSERT_EQ(positions.size(), r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    EXPECT_TRUE(holds_sphere(frustum(), positions[i], r[i]));
    EXPECT_GE(std::fabs(positions[i].z - 4e-3), r[i] * (1.0 - 1e-8));
  }
  for_each_overlap(positions, r, [](std::size_t i, std::size_t j) { ADD_FAILURE() << i << " overlaps " << j; });
}

TEST(RandomFill, IsAFunctionOfSeedAndNumbers) {
  const std::vector<double> r = radii();
  EXPECT_EQ(random_fill(frustum(), r, 0, 1, {}, "block"), random_fill(frustum(), r, 0, 1, {}, "block"));
  EXPECT_NE(random_fill(frustum(), r, 0, 1, {}, "block"), random_fill(frustum(), r, 0, 2, {}, "block"));
  EXPECT_NE(random_fill(frustum(), r, 0, 1, {}, "block"), random_fill(frustum(), r, 1, 1, {}, "block"));
}

TEST(RandomFill, SaysHowManyFitAndWhatWould) {
  ParticlesDeck box;
  box.region = RegionShape::box;
  box.min = {0.0, 0.0, 0.0};
  box.max = {5e-3, 5e-3, 5e-3};
  const std::vector<double> r(200, 0.5e-3);  // 84 % of the volume
  std::string message = "no error";
  try {
    random_fill(box, r, 0, 1, {}, "block");
  } catch (const DeckError& error) {
    message = error.what();
  }
  int fitting = 0;
  int percent = 0;
  double height = 0.0;
  ASSERT_EQ(std::sscanf(message.c_str(),
                        "block: only the %d largest of 200 particles fit into the region, of whose volume they would "
                        "take %d %%; a region of %lf m height would hold them",
                        &fitting, &percent, &height),
            3)
      << message;
  EXPECT_GT(fitting, 50);  // 21 %, in a box as narrow as five diameters
  EXPECT_LT(fitting, 120);
  EXPECT_EQ(percent, 84);
  box.max.z = height * (1.0 + 1e-5);
  EXPECT_EQ(random_fill(box, r, 0, 1, {}, "block").size(), 200U);
}

ParticlesDeck lattice(LatticeType type) {
  ParticlesDeck deck;
  deck.type = ParticlesType::lattice;
  deck.lattice = type;
  deck.diameter = 1e-3;
  deck.spacing = 2e-3;
  deck.first = {1e-3, 2e-3, 3e-3};
  deck.counts = {2, 3, 4};
  return deck;
}

double nearest(const std::vector<Vec3>& sites) {
  double least = 1.0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, norm(sites[i] - sites[j]));
  }
  return least;
}

TEST(Lattice, HasItsSitesPerCellAndItsNearestNeighbours) {
  const std::vector<Vec3> sc = lattice_sites(lattice(LatticeType::simple_cubic), {}, "block");
  const std::vector<Vec3> bcc = lattice_sites(lattice(LatticeType::body_centred), {}, "block");
  const std::vector<Vec3> fcc = lattice_sites(lattice(LatticeType::face_centred), {}, "block");
  EXPECT_EQ(sc.size(), 24U);
  EXPECT_EQ(bcc.size(), 48U);
  EXPECT_EQ(fcc.size(), 96U);
  EXPECT_NEAR(nearest(sc), 2e-3, 1e-15);
  EXPECT_NEAR(nearest(bcc), 2e-3 * std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(nearest(fcc), 2e-3 * std::sqrt(0.5), 1e-15);
  EXPECT_EQ(fcc.front(), (Vec3{1e-3, 2e-3, 3e-3}));
}

TEST(Lattice, OfTooManySitesIsRefused) {
  ParticlesDeck many = lattice(LatticeType::simple_cubic);
  many.counts = {9223372036854775807, 1, 1};
  EXPECT_THROW(lattice_sites(many, {}, "block"), DeckError);
  many.counts = {1'000'000, 1'000'000, 1};
  EXPECT_THROW(lattice_sites(many, {}, "block"), DeckError);
  many.counts.clear();
  many.region = RegionShape::box;
  many.max = {1e300, 1e300, 1e300};
  EXPECT_THROW(lattice_sites(many, {}, "block"), DeckError);
}

TEST(Lattice, FillsARegionToItsEndsAndLeavesWallsOut) {
  ParticlesDeck box = lattice(LatticeType::simple_cubic);
  box.counts.clear();
  box.region = RegionShape::box;
  box.min = {0.0, 0.0, 0.0};
  box.max = {5e-3, 5.5e-3, 3e-3};  // free for centres: 4, 4.5 and 2 mm
  EXPECT_EQ(lattice_sites(box, {}, "block").size(), 18U);
  box.lattice = LatticeType::body_centred;  // 3 x 3 x 2 corners and 2 x 2 x 1 centres
  EXPECT_EQ(lattice_sites(box, {}, "block").size(), 22U);
  const std::vector<Wall> floor = {plane_wall({0.0, 0.0, 0.5e-3}, {0.0, 0.0, 1.0})};
  EXPECT_EQ(lattice_sites(box, floor, "block").size(), 13U);
  box.max.z = 0.9e-3;
  EXPECT_THROW(lattice_sites(box, {}, "block"), DeckError);
}

}  // namespace
}  // namespace repose
