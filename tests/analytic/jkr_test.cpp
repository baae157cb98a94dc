// JKR adhesion: equilibrium, pull-off and energy in closed form, and a bounce as LAMMPS has it.
#include "contact/jkr.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "scene/particles/sphere_mass.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double work_of_adhesion = 0.02;  // J/m2
constexpr double large = 2.2e-4;           // m
constexpr double small = 1.5e-4;

Deck jkr_deck(double restitution, double timestep, double density = 3592.0) {
  Coefficients c;
  c.restitution_pp = restitution;
  c.restitution_pw = restitution;
  c.density = density;
  Deck deck = bare_deck(c, timestep);
  deck.contact.normal_law = NormalLaw::jkr;
  for (PairDeck& pair : deck.pairs) pair.work_of_adhesion = work_of_adhesion;
  return deck;
}

Vec3 force_on(const Simulation& simulation, std::size_t i) {
  const Particles& p = simulation.particles();
  const double scale = p.record[i].force_scale;
  const auto& sum = p.sum[i].force;
  return (1.0 / scale) * Vec3{static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

/// N: the greatest pull on the grain `i` while it is drawn away in `steps` steps; it must be free of force afterwards.
double greatest_pull(Scene& scene, std::size_t i, int steps) {
  double pull = 0.0;
  for (int k = 0; k < steps; ++k) {
    scene.run(1);
    pull = std::max(pull, -force_on(scene.simulation(), i).z);
  }
  EXPECT_EQ(force_on(scene.simulation(), i), Vec3{});
  return pull;
}

constexpr double heavy = 1e13;  // kg/m3: forces change no velocity, so that the grains are drawn apart evenly
constexpr double drawing_speed = 0.1;
constexpr double drawing_step = 1e-9;

TEST(Jkr, CompressedSpheresPullOffAtThreeHalvesPiWR) {
  const double overlap = 0.5e-6;
  Scene scene(jkr_deck(1.0, drawing_step, heavy),
              {{{0, 0, 0}, {}, {}, large}, {{0, 0, large + small - overlap}, {0, 0, drawing_speed}, {}, small}});
  const double pull_off = 1.5 * pi * work_of_adhesion * large * small / (large + small);
  EXPECT_NEAR(greatest_pull(scene, 1, 20000) / pull_off, 1.0, 1e-4);  // the pull is flat there: far less than a step
}

TEST(Jkr, SpheresPullOffWallsInLanesAndAtEdges) {
  const double pull_off = 1.5 * pi * work_of_adhesion * large;
  for (const bool at_edge : {false, true}) {
    SCOPED_TRACE(at_edge);
    Deck deck = jkr_deck(1.0, drawing_step, heavy);
    WallDeck wall = floor_at(0.0);
    if (at_edge) {  // of a rectangle: searched at each step
      wall.type = WallType::rectangle;
      wall.corner = {0.0, -0.01, 0.0};
      wall.edge_u = {0.02, 0.0, 0.0};
      wall.edge_v = {0.0, 0.02, 0.0};
    }
    deck.walls.push_back(wall);
    Scene scene(deck, {{{0, 0, large - 0.5e-6}, {0, 0, drawing_speed}, {}, large}});
    EXPECT_EQ(scene.simulation().wall_contacts().in_lanes(), at_edge ? 0U : 1U);
    EXPECT_NEAR(greatest_pull(scene, 0, 20000) / pull_off, 1.0, 1e-4);
  }
}

TEST(Jkr, SurfacesThatHaveNotTouchedDoNotPull) {
  const double gap = 1e-9;  // less than the pull-off distance
  Scene scene(jkr_deck(1.0, 1e-8), {{{0, 0, 0}, {}, {}, large}, {{0, 0, large + small + gap}, {}, {}, small}});
  scene.run(10);
  EXPECT_EQ(force_on(scene.simulation(), 0), Vec3{});
}

TEST(Jkr, TheContactRadiusSolvesTheEquationOfTheOverlap) {
  const Deck deck = jkr_deck(1.0, 1e-8);
  const MaterialTable materials(deck);
  const PairParameters& pair = materials.pair(0, 0);
  const double c = pair.jkr_adhesion;
  ContactGeometry contact = {};
  for (const double radius : {1e-6, 1e-4, 1e-2}) {
    contact.radius_eff = radius;
    const double farthest = jkr_pull_off_distance(pair, radius);
    for (const double overlap : {-farthest, -0.5 * farthest, 1e-300, 1e-3 * farthest, farthest, 0.3 * radius}) {
      contact.overlap = overlap;
      const double a = jkr_contact_radius(pair, contact);
      const double found = a * a / radius - c * std::sqrt(a);
      EXPECT_NEAR(found, overlap, 4e-15 * a * a / radius) << radius << ' ' << overlap;  // rounding of the difference
    }
    contact.overlap = -farthest;
    const double pull = -jkr_force(pair, radius, jkr_contact_radius(pair, contact));
    EXPECT_NEAR(pull / jkr_pull_off_force(pair, radius), 1.0, 1e-13);
  }
}

TEST(Jkr, EnergyIsTheWorkOfTheForce) {
  const Deck deck = jkr_deck(1.0, 1e-8);
  const MaterialTable materials(deck);
  const PairParameters& pair = materials.pair(0, 0);
  ContactGeometry contact = {};
  contact.radius_eff = 1e-4;
  const auto at = [&](double overlap) {
    contact.overlap = overlap;
    return jkr_contact_radius(pair, contact);
  };
  const double step = 1e-9;
  for (const double overlap : {-1e-7, 1e-7, 5e-7, 2e-6}) {
    const double slope =
        (jkr_energy(pair, 1e-4, at(overlap + step)) - jkr_energy(pair, 1e-4, at(overlap - step))) / (2.0 * step);
    const double force = jkr_force(pair, 1e-4, at(overlap));
    EXPECT_NEAR(slope, force, 1e-3 * jkr_pull_off_force(pair, 1e-4)) << overlap;  // the step squared
  }
}

struct BounceRow {
  std::int64_t step;
  double x_1, x_2, v_1, v_2;
};

std::vector<BounceRow> read_bounce(const std::string& name) {
  std::ifstream file(std::string(REPOSE_SOURCE_DIR) + "/tests/reference/lammps/jkr_bounce_" + name + ".csv");
  std::string line;
  std::getline(file, line);
  std::vector<BounceRow> rows;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    BounceRow r;
    fields >> r.step >> r.x_1 >> r.x_2 >> r.v_1 >> r.v_2;
    rows.push_back(r);
  }
  return rows;
}

class JkrBounce : public ::testing::TestWithParam<std::string> {};

TEST_P(JkrBounce, FollowsLammps) {
  const std::vector<BounceRow> rows = read_bounce(GetParam());
  ASSERT_GT(rows.size(), 300U);
  const double beta = 0.340740625 / std::sqrt(5.0);  // jkr_bounce.lammps
  Scene scene(
      jkr_deck(std::exp(-pi * beta / std::sqrt(1.0 - beta * beta)), 1e-7),
      {{{rows[0].x_1, 0, 0}, {rows[0].v_1, 0, 0}, {}, large}, {{rows[0].x_2, 0, 0}, {rows[0].v_2, 0, 0}, {}, small}});
  double position = 0.0, velocity = 0.0;
  for (const BounceRow& row : rows) {
    scene.run(row.step - scene.simulation().steps());
    const std::vector<Grain> g = scene.grains();
    position = std::max({position, std::abs(g[0].position.x - row.x_1), std::abs(g[1].position.x - row.x_2)});
    velocity = std::max({velocity, std::abs(g[0].velocity.x - row.v_1), std::abs(g[1].velocity.x - row.v_2)});
  }
  EXPECT_LT(position / (large + small), 1e-9);
  EXPECT_LT(velocity / rows[0].v_1, 1e-9);
  std::cout << "  relative deviation: position " << position / (large + small) << ", velocity "
            << velocity / rows[0].v_1 << "\n";
}

INSTANTIATE_TEST_SUITE_P(All, JkrBounce, ::testing::Values("parts", "sticks"));

}  // namespace
}  // namespace repose::test
