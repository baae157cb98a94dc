// Prescribed motions: where they bring a body, how fast its points move, and walls on the way.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "scene/walls/motion.h"
#include "scene/walls/wall.h"

namespace repose {
namespace {

constexpr double dt = 1e-4;

MotionDeck translation(const Vec3& velocity) {
  MotionDeck m;
  m.type = MotionType::translation;
  m.velocity = velocity;
  return m;
}

MotionDeck oscillation(const Vec3& amplitude, double frequency) {
  MotionDeck m;
  m.type = MotionType::oscillation;
  m.amplitude = amplitude;
  m.frequency = frequency;
  return m;
}

MotionDeck rotation(const Vec3& origin, const Vec3& axis, double angular_velocity) {
  MotionDeck m;
  m.type = MotionType::rotation;
  m.axis_origin = origin;
  m.axis_direction = axis;
  m.angular_velocity = angular_velocity;
  return m;
}

Motions after(const std::vector<MotionDeck>& deck, int steps) {
  Motions motions(deck);
  motions.begin_phase("any");
  for (int k = 0; k < steps; ++k) motions.step();
  return motions;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LT(norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Motions, QuarterTurnAboutAnAxisBesideTheOrigin) {
  const Motions m = after({rotation({1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, 0.5 * pi / (100 * dt))}, 100);
  expect_near(m.placement(dt).place({2.0, 0.0, 5.0}), {1.0, 1.0, 5.0}, 1e-14);
  expect_near(m.placement(dt).turn(Vec3{1.0, 0.0, 0.0}), {0.0, 1.0, 0.0}, 1e-15);
  expect_near(m.placement(dt).back(Vec3{1.0, 1.0, 5.0}), {2.0, 0.0, 5.0}, 1e-14);
}

TEST(Motions, OscillationReturnsAfterAPeriod) {
  const MotionDeck shake = oscillation({0.0, 0.0, 1e-3}, 1.0 / (400 * dt));
  expect_near(after({shake}, 100).placement(dt).shift, {0.0, 0.0, 1e-3}, 1e-18);
  expect_near(after({shake}, 400).placement(dt).shift, {}, 1e-17);
  expect_near(after({shake}, 400).placement(dt).motion.velocity, {0.0, 0.0, 2e-3 * pi / (400 * dt)}, 1e-13);
}

TEST(Motions, VelocityIsTheDerivativeOfThePlaceWhateverIsCombined) {
  const std::vector<MotionDeck> deck = {rotation({0.1, -0.2, 0.3}, {1.0, 2.0, -1.0}, 3.0),
                                        translation({0.4, 0.1, -0.7}), oscillation({0.02, -0.01, 0.03}, 5.0),
                                        rotation({-0.3, 0.0, 0.1}, {0.0, 1.0, 1.0}, -2.0)};
  const Vec3 x = {0.5, 0.6, -0.4};
  for (const int steps : {1, 777, 5000}) {
    const Placement now = after(deck, steps).placement(dt);
    const Vec3 derivative =
        (0.5 / dt) * (after(deck, steps + 1).placement(dt).place(x) - after(deck, steps - 1).placement(dt).place(x));
    expect_near(now.motion.at(now.place(x)), derivative, 2e-4);  // of about 4 m/s; third derivative times dt^2 / 6
  }
}

TEST(Motions, AdvanceInTheirPhasesOnly) {
  MotionDeck belt = translation({1.0, 0.0, 0.0});
  belt.phases = {"run"};
  Motions motions({belt});
  for (const char* phase : {"fill", "run", "rest"}) {
    motions.begin_phase(phase);
    for (int k = 0; k < 10; ++k) motions.step();
    const bool runs = std::string(phase) == "run";
    EXPECT_EQ(motions.placement(dt).motion.velocity, (runs ? Vec3{1.0, 0.0, 0.0} : Vec3{}));
  }
  EXPECT_DOUBLE_EQ(motions.placement(dt).shift.x, 10 * dt);
}

/// The greatest speed of the domain's corners at any of many times.
double greatest_seen(const std::vector<MotionDeck>& deck, const DomainDeck& domain) {
  double speed = 0.0;
  Motions motions(deck);
  motions.begin_phase("any");
  for (int k = 0; k < 4000; ++k) {
    for (int j = 0; j < 10; ++j) motions.step();
    const SurfaceMotion now = motions.placement(dt).motion;
    for (int corner = 0; corner < 8; ++corner) {
      speed = std::max(speed, norm(now.at({(corner & 1) != 0 ? domain.max.x : domain.min.x,
                                           (corner & 2) != 0 ? domain.max.y : domain.min.y,
                                           (corner & 4) != 0 ? domain.max.z : domain.min.z})));
    }
  }
  return speed;
}

TEST(Motions, NoPointOfTheDomainIsFasterThanTheBound) {
  const DomainDeck domain = {{-1.0, -2.0, -3.0}, {2.0, 1.0, 1.0}};
  const MotionDeck turn = rotation({0.1, 0.0, 0.0}, {0.0, 1.0, 0.0}, 4.0);
  const MotionDeck shake = oscillation({0.01, 0.0, 0.0}, 10.0);
  // A translation along the axis leaves it where it is, an oscillation across moves it by its amplitude.
  EXPECT_NEAR(greatest_speed({turn, translation({0.0, 0.3, 0.0}), shake}, domain),
              4.0 * (std::hypot(1.9, 3.0) + 0.01) + 0.3 + 0.2 * pi, 1e-12);
  EXPECT_NEAR(greatest_speed({turn, turn}, domain), 8.0 * std::hypot(1.9, 3.0), 1e-12);
  EXPECT_LE(greatest_seen({turn, shake}, domain), greatest_speed({turn, shake}, domain));
  // An axis that others carry around comes nearer to some points and farther from others.
  for (const MotionDeck& other : {rotation({1.5, 0.0, 0.5}, {0.0, 1.0, 0.0}, 5.0), rotation({}, {1.0, 0.0, 0.0}, 3.0),
                                  rotation({0.0, 1.0, -2.0}, {1.0, 0.5, -1.0}, -3.0)}) {
    const double bound = greatest_speed({turn, other}, domain);
    EXPECT_LE(greatest_seen({turn, other}, domain), bound);
    EXPECT_GT(bound, greatest_speed({turn}, domain) + greatest_speed({other}, domain));
    for (const MotionDeck& third : {turn, shake, rotation({-1.0, -2.0, 1.0}, {0.0, 0.0, 1.0}, 2.0)}) {
      EXPECT_LE(greatest_seen({turn, other, third}, domain), greatest_speed({turn, other, third}, domain));
    }
  }
}

WallDeck rectangle() {
  WallDeck deck;
  deck.name = "paddle";
  deck.type = WallType::rectangle;
  deck.corner = {-0.02, -0.01, 0.0};
  deck.edge_u = {0.04, 0.0, 0.0};
  deck.edge_v = {0.0, 0.02, 0.0};
  return deck;
}

TEST(MovingWall, IsFeltWhereItHasCome) {
  WallDeck deck = rectangle();
  deck.motions = {rotation({}, {0.0, 1.0, 0.0}, 0.5 * pi / (100 * dt)), translation({1.0, 0.0, 0.0})};
  Wall wall = make_wall(deck, 0);
  EXPECT_TRUE(wall.travels);
  wall.motions.begin_phase("any");
  for (int k = 0; k < 100; ++k) wall.motions.step();
  place(wall, dt);
  // It stands upright in the plane x = 10 mm now.
  const Vec3 centre = {0.013, 0.002, 0.015};
  EXPECT_NEAR(distance(wall, centre), 0.003, 1e-15);
  TouchBuffer touches;
  ASSERT_EQ(find_touches(wall, 7, centre, 0.004, touches), 1);
  expect_near(touches[0].normal, {1.0, 0.0, 0.0}, 1e-15);
  expect_near(touches[0].point, {0.01, 0.002, 0.015}, 1e-15);
  EXPECT_EQ(touches[0].wall, 7);
  EXPECT_TRUE(keeps_to_face(wall, touches[0].feature, centre, 0.0, 0.0049));
  EXPECT_FALSE(keeps_to_face(wall, touches[0].feature, centre, 0.0, 0.0051));
}

TEST(MovingWall, TakesThoseAlongThatMoveWithIt) {
  WallDeck drum;
  drum.name = "drum";
  drum.type = WallType::profile;
  drum.points = {{0.03, -0.01}, {0.03, 0.01}};
  drum.axis_direction = {0.0, 1.0, 0.0};
  drum.motions = {rotation({}, {0.0, 1.0, 0.0}, 0.5 * pi / (100 * dt))};
  std::vector<Wall> walls = {make_wall(rectangle(), 0), make_wall(drum, 0), make_wall(rectangle(), 0)};
  join(walls, 0, 1);
  EXPECT_TRUE(walls[0].travels);  // while the drum does not
  EXPECT_FALSE(walls[1].travels);
  EXPECT_EQ(body_of(walls, 1), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(body_of(walls, 2), (std::vector<std::size_t>{2}));
  walls[1].motions.begin_phase("any");
  for (int k = 0; k < 100; ++k) walls[1].motions.step();
  place(walls, dt);
  EXPECT_NEAR(distance(walls[0], {0.003, 0.002, 0.015}), 0.003, 1e-15);  // in the plane x = 0 now
  EXPECT_NEAR(distance(walls[2], {0.003, 0.002, 0.015}), 0.015, 1e-15);
  EXPECT_EQ(walls[0].placement.motion.angular_velocity, walls[1].placement.motion.angular_velocity);
  EXPECT_GT(norm(walls[0].placement.motion.angular_velocity), 0.0);
}

TEST(MovingWall, StaysWhereItsMotionLeavesItsShape) {
  WallDeck drum;
  drum.name = "drum";
  drum.type = WallType::profile;
  drum.points = {{0.03, -0.01}, {0.03, 0.01}};
  drum.axis_direction = {0.0, 3.0, 0.0};
  drum.motions = {rotation({0.0, 0.7, 0.0}, {0.0, -1.0, 0.0}, 2.0)};
  EXPECT_FALSE(make_wall(drum, 0).travels);
  drum.motions = {rotation({0.0, 0.7, 1e-6}, {0.0, 1.0, 0.0}, 2.0)};
  EXPECT_TRUE(make_wall(drum, 0).travels);

  WallDeck belt;
  belt.name = "belt";
  belt.type = WallType::plane;
  belt.motions = {translation({1.0, 2.0, 0.0})};
  EXPECT_FALSE(make_wall(belt, 0).travels);
  belt.motions = {translation({1.0, 2.0, 1e-9})};
  EXPECT_TRUE(make_wall(belt, 0).travels);
}

}  // namespace
}  // namespace repose
