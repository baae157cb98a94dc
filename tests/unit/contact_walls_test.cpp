// Contacts of particles with walls: forces, histories, removal, alarms.
#include <cmath>
#include <cstring>
#include <tuple>

#include <gtest/gtest.h>

#include "contact/wall_contacts.h"
#include "domain/exits.h"
#include "integration/velocity_verlet.h"
#include "scene/particles/sphere_mass.h"
#include "support/contact_law.h"
#include "support/contact_options.h"
#include "support/draw.h"
#include "support/levels.h"
#include "support/meshes.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 0.5e-3;
constexpr double dt = 1e-6;
constexpr double max_overlap = 0.3;

/// Grains and walls. With lanes a grain near one face goes into the lanes of that face; without, it is searched.
struct Setting {
  explicit Setting(bool in_lanes, const Deck& deck = bare_deck({}, dt)) : lanes(in_lanes), materials(deck) {}

  bool lanes;
  MaterialTable materials;
  std::vector<Wall> walls;
  Particles particles;
  WallContacts contacts;

  void add_wall(const Vec3& point, const Vec3& normal) {
    WallDeck deck = floor_at(0.0);
    deck.point = point;
    deck.normal = normal;
    walls.push_back(make_wall(deck, 1));
  }
  void add_grain(const Vec3& position, const Vec3& velocity, const Vec3& spin) {
    particles.record.push_back({position, radius, velocity, 0.0, spin, 0.0});
    particles.id.push_back(static_cast<std::int64_t>(particles.owned++));
    particles.material.push_back(0);
    particles.sum.assign(particles.owned, ForceSum{});
    set_fixed_point_scales(materials, max_overlap, particles);
  }
  void build(const Csr<WallMemory>& memory) {
    contacts.build(particles, walls, std::vector<double>(particles.owned, 1.3 * radius), memory);
    if (lanes) contacts.select_near(particles, walls, {0.3, 0.0});
  }
  void build() { build(Csr<WallMemory>::empty(particles.owned)); }
  WallAlarms evaluate(VectorLevel level = best_vector_level()) {
    std::fill(particles.sum.begin(), particles.sum.end(), ForceSum{});
    return contacts.evaluate(level, walls, materials, dt, max_overlap, particles);
  }
  std::vector<WallContact> touching() const { return contacts.contacts(walls, particles); }
  Vec3 force(std::size_t i) const {
    const std::int64_t* sum = particles.sum[i].force;
    const double unit = 1.0 / particles.record[i].force_scale;
    return unit * Vec3{static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
  }
  Vec3 torque(std::size_t i) const {
    const std::int64_t* sum = particles.sum[i].torque;
    const double unit = 1.0 / particles.record[i].torque_scale;
    return unit * Vec3{static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
  }
};

Setting grain_on_floor(bool lanes) {
  Setting setting(lanes);
  setting.add_wall({}, {0.0, 0.0, 1.0});
  setting.add_grain({0.0, 0.0, 0.99 * radius}, {0.002, 0.0, -0.003}, {0.0, 5.0, 0.0});
  return setting;
}

class WallContactsTest : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BothWays, WallContactsTest, testing::Values(false, true),
                         [](const auto& way) { return way.param ? "InLanes" : "Searched"; });

TEST_P(WallContactsTest, ForceAndTorqueByHand) {
  Setting s = grain_on_floor(GetParam());
  s.build();
  EXPECT_FALSE(s.evaluate().any());
  ASSERT_EQ(s.touching().size(), 1U);

  const PairParameters& pair = s.materials.pair(0, 1);
  ContactGeometry contact = {};
  contact.normal = {0.0, 0.0, 1.0};
  contact.overlap = 0.01 * radius;
  contact.radius_eff = radius;
  contact.mass_eff = sphere_mass(radius, 3592.0);
  contact.normal_velocity = -0.003;
  const double arm = 0.995 * radius;
  contact.tangential_velocity = {0.002 - arm * 5.0, 0.0,
                                 0.0};  // v - w x (arm n): backwards where the grain rolls ahead
  contact.rolling_velocity = {0.0, 5.0 * arm / (0.99 * radius), 0.0};
  ContactHistory history;
  const ContactForces forces = contact_law(pair, contact, dt, history);
  // Rounding of the overlap, 1e-19 m of 5e-6 m, and of the fixed point: below 1e-12 of the forces.
  EXPECT_NEAR(s.force(0).z, forces.force.z, 1e-12 * forces.force.z);
  EXPECT_NEAR(s.force(0).x, forces.force.x, 1e-12 * forces.force.z);
  EXPECT_GT(forces.force.x, 0.0);
  EXPECT_NEAR(s.torque(0).y, -arm * forces.friction_arm.y - history.rolling.y, 1e-12 * radius * forces.force.z);
  EXPECT_LT(s.torque(0).y, 0.0);  // friction that pushes the grain ahead slows its spin
  EXPECT_NEAR(s.touching()[0].overlap, 0.01 * radius, 1e-15);
}

TEST_P(WallContactsTest, HistoriesGrowAndSurviveARebuild) {
  Setting once = grain_on_floor(GetParam());
  once.build();
  for (int k = 0; k < 5; ++k) once.evaluate();
  Setting rebuilt = grain_on_floor(GetParam());
  rebuilt.build();
  for (int k = 0; k < 5; ++k) {
    rebuilt.evaluate();
    rebuilt.build(rebuilt.contacts.memory(1));
  }
  rebuilt.evaluate();
  once.evaluate();
  EXPECT_EQ(rebuilt.touching()[0].history.spring, once.touching()[0].history.spring);
  EXPECT_EQ(rebuilt.touching()[0].history.rolling, once.touching()[0].history.rolling);
  EXPECT_NEAR(once.touching()[0].history.spring.x, 6.0 * dt * (0.002 - 0.995 * radius * 5.0), 1e-22);
}

TEST_P(WallContactsTest, PartingForgets) {
  Setting s = grain_on_floor(GetParam());
  s.build();
  s.evaluate();
  const ContactHistory first = s.touching()[0].history;
  s.particles.record[0].position.z = 1.001 * radius;
  s.evaluate();
  EXPECT_TRUE(s.touching().empty());
  s.particles.record[0].position.z = 0.99 * radius;
  s.evaluate();
  EXPECT_EQ(s.touching()[0].history.spring, first.spring);
}

TEST_P(WallContactsTest, AnAbsentWallIsNotFeltUntilItIsAdded) {
  Setting s = grain_on_floor(GetParam());
  s.walls[0].present = false;
  s.build();
  s.evaluate();
  EXPECT_TRUE(s.touching().empty());
  EXPECT_EQ(s.force(0), Vec3{});
  s.walls[0].present = true;
  s.evaluate();
  EXPECT_EQ(s.touching().size(), 1U);
  EXPECT_GT(s.force(0).z, 0.0);
}

TEST_P(WallContactsTest, ACornerOfTwoPlanesIsTouchedTwice) {
  Setting s = grain_on_floor(GetParam());
  s.add_wall({-0.99 * radius, 0.0, 0.0}, {1.0, 0.0, 0.0});
  s.build();
  EXPECT_FALSE(s.evaluate().any());
  EXPECT_EQ(s.touching().size(), 2U);
  EXPECT_GT(s.force(0).x, 0.0);
  EXPECT_GT(s.force(0).z, 0.0);
}

TEST_P(WallContactsTest, AlarmsForDeepOverlapAndNan) {
  Setting s = grain_on_floor(GetParam());
  s.particles.record[0].position.z = 0.71 * radius;
  s.build();
  EXPECT_FALSE(s.evaluate().any());
  s.particles.record[0].position.z = 0.69 * radius;
  EXPECT_EQ(s.evaluate().too_deep, 1);
  s.particles.record[0].position.z = 0.99 * radius;
  s.particles.record[0].spin.x = std::nan("");
  EXPECT_EQ(s.evaluate().out_of_range, 1);
}

// A parked particle is out of every contact at once, also out of those with infinite planes, which reach that far.
TEST_P(WallContactsTest, AParkedParticleTouchesNoPlane) {
  for (const Vec3& normal : {Vec3{0.0, 0.0, 1.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.6, 0.8}}) {
    Setting s(GetParam());
    s.add_wall({}, normal);
    s.add_grain(0.99 * radius * normal, {}, {});
    s.build();
    s.evaluate();
    ASSERT_EQ(s.touching().size(), 1U);
    ExitCount left;
    retire_leavers({{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}, {}, s.materials, MassUnit(1.0), s.particles, left);
    EXPECT_FALSE(s.evaluate().any());
    EXPECT_TRUE(s.touching().empty());
  }
}

// One comes to its first wall, one to a second, one from one wall to another: as if all lists had been made anew.
TEST_P(WallContactsTest, WallsListedForSingleGrainsAreFelt) {
  const auto start = [&] {
    Setting s(GetParam());
    s.add_wall({}, {0.0, 0.0, 1.0});
    s.add_wall({}, {1.0, 0.0, 0.0});
    s.add_grain({0.02, 0.0, 5.0 * radius}, {0.002, 0.0, -0.003}, {});
    s.add_grain({0.03, 0.0, 5.0 * radius}, {0.002, 0.0, -0.003}, {});
    s.add_grain({0.02, 0.01, 0.99 * radius}, {0.002, 0.0, -0.003}, {0.0, 5.0, 0.0});
    s.add_grain({0.99 * radius, 0.02, 0.02}, {-0.002, 0.0, -0.003}, {0.0, 5.0, 0.0});
    s.build();
    s.evaluate();
    s.particles.record[0].position = {0.02, 0.0, 0.99 * radius};
    s.particles.record[2].position = {0.99 * radius, 0.01, 0.99 * radius};
    s.particles.record[3].position = {0.02, 0.02, 0.99 * radius};
    return s;
  };
  Setting rebuilt = start();
  rebuilt.build(rebuilt.contacts.memory(4));
  rebuilt.evaluate();
  Setting single = start();
  for (const std::int32_t i : {3, 0, 2, 0}) single.contacts.list_more(single.particles, single.walls, i, 1.3 * radius);
  single.contacts.search(std::vector<std::int32_t>{0, 2, 3});
  single.evaluate();
  EXPECT_EQ(single.touching().size(), 4U);
  EXPECT_EQ(std::memcmp(single.particles.sum.data(), rebuilt.particles.sum.data(), 4 * sizeof(ForceSum)), 0);
  if (GetParam()) {
    single.contacts.select_near(single.particles, single.walls, {0.3, 0.0});
    single.evaluate();
    rebuilt.evaluate();
    EXPECT_EQ(std::memcmp(single.particles.sum.data(), rebuilt.particles.sum.data(), 4 * sizeof(ForceSum)), 0);
  }
}

WallDeck funnel() {
  WallDeck deck;
  deck.name = "funnel";
  deck.type = WallType::profile;
  deck.material = "steel";
  deck.points = {{0.02, 0.05}, {0.02, 0.02}, {0.005, 0.0}};  // a cylinder and a cone
  deck.axis_origin = {0.001, 0.002, 0.003};
  deck.axis_direction = {0.1, -0.2, 1.0};
  return deck;
}
WallDeck tilted_plate() {
  WallDeck deck;
  deck.name = "plate";
  deck.type = WallType::rectangle;
  deck.material = "steel";
  deck.corner = {-0.02, -0.02, -0.01};
  deck.edge_u = {0.04, 0.0, 0.004};
  deck.edge_v = {0.0, 0.04, 0.0};
  return deck;
}

using Walls = std::vector<Wall>;

Walls funnel_and_plate(const std::vector<MotionDeck>& motions = {}) {
  Walls walls;
  for (WallDeck wall : {funnel(), tilted_plate()}) {
    wall.motions = motions;
    walls.push_back(make_wall(wall, 1));
    walls.back().motions.begin_phase("any");
  }
  return walls;
}

/// The same of triangles: twelve facets of the funnel, and a plate of many triangles in one plane.
Walls meshes(const std::vector<MotionDeck>& motions = {}) {
  Triangles cone = frustum(0.005, 0.0, 0.02, 0.02, 12);
  const Triangles cylinder = frustum(0.02, 0.02, 0.02, 0.05, 12);
  cone.insert(cone.end(), cylinder.begin(), cylinder.end());
  Walls walls;
  for (const Triangles& triangles : {cone, irregular_square(0.02, 20)}) {
    WallDeck deck;
    deck.name = "mesh";
    deck.type = WallType::mesh;
    deck.translate = {0.001, 0.002, walls.empty() ? 0.003 : -0.01};
    deck.motions = motions;
    walls.push_back(make_wall(deck, 1, [&](const std::string&) { return ascii_stl(triangles); }));
    walls.back().motions.begin_phase("any");
  }
  return walls;
}

/// Every seventh grain, those near edges and those in lanes.
std::vector<std::int32_t> some_grains(std::int32_t first, std::size_t count) {
  std::vector<std::int32_t> some;
  for (std::int32_t i = first; i < static_cast<std::int32_t>(count); i += 7) some.push_back(i);
  return some;
}

/// A crowd that touches the faces and edges of two walls, moved about for some steps with its lists made anew at times;
/// with lanes, some grains are taken out of them in between, some of these twice.
Setting after_some_steps(bool lanes, VectorLevel level, const Deck& deck = bare_deck({}, dt),
                         const Walls& walls = funnel_and_plate()) {
  Setting s(lanes, deck);
  s.walls = walls;
  Draw draw(5);
  while (s.particles.owned < 300) {
    const Vec3 position = {draw(-0.025, 0.025), draw(-0.025, 0.025), draw(-0.012, 0.05)};
    const double gap = std::min(distance(s.walls[0], position), distance(s.walls[1], position));
    if (gap > 0.8 * radius && gap < 1.1 * radius) s.add_grain(position, draw.vector(0.05), draw.vector(50.0));
  }
  for (int step = 0; step < 40; ++step) {
    if (step % 10 == 0) s.build(s.contacts.memory(s.particles.owned));
    if (lanes && step % 10 > 7) s.contacts.search(some_grains(step % 2, s.particles.owned));
    if (lanes && step % 10 == 9) s.contacts.search(some_grains(0, s.particles.owned));
    s.evaluate(level);
    for (ParticleRecord& p : s.particles.record) p.position += dt * p.velocity;
    for (Wall& wall : s.walls) {
      wall.motions.step();
      place(wall, dt);
    }
  }
  s.evaluate(level);
  return s;
}

MotionDeck turning() {
  MotionDeck motion;
  motion.type = MotionType::rotation;
  motion.axis_origin = {0.01, 0.0, 0.02};
  motion.axis_direction = {1.0, 2.0, 0.5};
  motion.angular_velocity = 30.0;
  return motion;
}

void expect_the_bits_of_the_search(const Deck& deck, const Walls& walls = funnel_and_plate()) {
  const Setting searched = after_some_steps(false, best_vector_level(), deck, walls);
  ASSERT_GT(searched.touching().size(), 100U);
  for (const VectorLevel level : levels_here()) {
    const Setting s = after_some_steps(true, level, deck, walls);
    EXPECT_GT(s.contacts.in_lanes(), 150U);
    EXPECT_LT(s.contacts.in_lanes(), 300U);
    EXPECT_EQ(std::memcmp(s.particles.sum.data(), searched.particles.sum.data(), 300 * sizeof(ForceSum)), 0);
    const std::vector<WallContact> a = s.touching(), b = searched.touching();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(std::tie(a[k].particle, a[k].wall, a[k].feature), std::tie(b[k].particle, b[k].wall, b[k].feature));
      EXPECT_EQ(a[k].normal, b[k].normal);
      EXPECT_EQ(a[k].overlap, b[k].overlap);
      EXPECT_EQ(std::memcmp(&a[k].history, &b[k].history, sizeof(ContactHistory)), 0);
    }
  }
}

TEST(WallContactsInLanes, AreLeftByWhoIsSearched) {
  Setting s(true);
  s.add_wall({}, {0.0, 0.0, 1.0});
  for (int k = 0; k < 37; ++k) s.add_grain({0.01 * k, 0.0, 0.99 * radius}, {0.002, 0.0, 0.0}, {});
  s.build();
  s.evaluate();
  const std::vector<WallContact> before = s.touching();
  s.contacts.search(std::vector<std::int32_t>{0, 20, 36});
  EXPECT_EQ(s.contacts.in_lanes(), 34U);
  s.contacts.search(std::vector<std::int32_t>{5, 20, 35});
  EXPECT_EQ(s.contacts.in_lanes(), 32U);
  const Csr<WallMemory> memory = s.contacts.memory(37);
  for (std::size_t i = 0; i < 37; ++i) {
    ASSERT_EQ(memory.row(i).size(), 1U) << i;
    EXPECT_EQ(memory.row(i)[0].history.spring, before[i].history.spring) << i;
  }
}

TEST(WallContactsInLanes, GiveTheBitsOfTheSearch) { expect_the_bits_of_the_search(bare_deck({}, dt)); }

TEST(WallContactsInLanes, GiveTheBitsOfTheSearchWithAllOptions) {
  const Deck deck = with_all_options(bare_deck({}, dt));
  expect_the_bits_of_the_search(deck);
  const Setting a = after_some_steps(true, best_vector_level());
  const Setting b = after_some_steps(true, best_vector_level(), deck);
  EXPECT_NE(std::memcmp(a.particles.sum.data(), b.particles.sum.data(), 300 * sizeof(ForceSum)), 0);
}

TEST(WallContactsInLanes, GiveTheBitsOfTheSearchAtWallsThatTravel) {
  expect_the_bits_of_the_search(bare_deck({}, dt), funnel_and_plate({turning()}));
  expect_the_bits_of_the_search(with_all_options(bare_deck({}, dt)), funnel_and_plate({turning()}));
}

TEST(WallContactsInLanes, GiveTheBitsOfTheSearchAtMeshes) {
  expect_the_bits_of_the_search(bare_deck({}, dt), meshes());
  expect_the_bits_of_the_search(bare_deck({}, dt), meshes({turning()}));
}

/// A grain of velocity -u at a wall at rest sees what a grain at rest sees at a wall of velocity u.
TEST(MovingWall, OnlyTheRelativeMotionCounts) {
  const Vec3 u = {0.03, -0.01, 0.02};
  for (const bool lanes : {false, true}) {
    Setting rest = grain_on_floor(lanes);
    Setting moved = rest;
    rest.particles.record[0].velocity = -u;
    moved.particles.record[0].velocity = {};
    MotionDeck motion;
    motion.velocity = u;
    WallDeck floor = floor_at(0.0);
    floor.motions = {motion};
    moved.walls = {make_wall(floor, 1)};
    moved.walls[0].motions.begin_phase("any");
    place(moved.walls[0], dt);
    rest.build();
    moved.build();
    rest.evaluate();
    moved.evaluate();
    EXPECT_NE(rest.force(0), Vec3{});
    EXPECT_EQ(rest.force(0), moved.force(0));
    EXPECT_EQ(rest.torque(0), moved.torque(0));
  }
}

/// A grain that turns with a turntable about its own vertical feels no friction, one further out is dragged along.
TEST(MovingWall, ATurntableDragsAlong) {
  MotionDeck motion;
  motion.type = MotionType::rotation;
  motion.angular_velocity = 20.0;
  WallDeck table = floor_at(0.0);
  table.motions = {motion};
  for (const bool lanes : {false, true}) {
    Setting s(lanes);
    s.walls = {make_wall(table, 1)};
    s.walls[0].motions.begin_phase("any");
    place(s.walls[0], dt);
    EXPECT_FALSE(s.walls[0].travels);
    s.add_grain({0.0, 0.0, 0.99 * radius}, {}, {0.0, 0.0, 20.0});
    s.add_grain({0.02, 0.0, 0.99 * radius}, {}, {});
    s.add_grain({0.0, 0.02, 0.99 * radius}, {-0.4, 0.0, 0.0}, {0.0, 0.0, 20.0});  // carried along
    s.build();
    s.evaluate();
    EXPECT_EQ(s.torque(0), Vec3{});
    EXPECT_LT(std::fabs(s.force(0).x) + std::fabs(s.force(0).y), 1e-18);
    EXPECT_GT(s.force(1).y, 1e-8);
    EXPECT_EQ(s.force(1).x, 0.0);
    EXPECT_LT(norm(s.force(2) - Vec3{0.0, 0.0, s.force(2).z}), 1e-12 * s.force(2).z);
  }
}

}  // namespace
}  // namespace repose::test
