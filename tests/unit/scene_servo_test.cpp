// The controller of a wall under load against springs whose answer is known, its bounds and what it says.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "base/math.h"
#include "scene/walls/servo.h"

namespace repose {
namespace {

constexpr double dt = 1e-4;

ServoDeck servo_deck() {
  ServoDeck deck;
  deck.enabled = true;
  deck.direction = {0.0, 0.0, -2.0};
  deck.force = 3.0;
  deck.max_speed = 0.1;
  deck.max_way = 0.01;
  deck.every = 5;
  return deck;
}

Servo acting(const ServoDeck& deck) {
  Servo servo(deck);
  servo.begin_phase("any");
  return servo;
}

/// A spring of stiffness N/m that the wall meets after a gap.
struct Spring {
  double gap;
  double stiffness;

  WallResistance at(const Servo& servo) const {
    const bool touches = servo.way() > gap;
    return {touches ? stiffness * (servo.way() - gap) : 0.0,
            touches ? stiffness * dt * static_cast<double>(servo.every()) : 0.0};
  }
};

/// What was told.
std::vector<std::string> run(Servo& servo, const Spring& spring, int looks) {
  std::vector<std::string> told;
  for (int k = 0; k < looks; ++k) {
    for (int step = 0; step < servo.every(); ++step) servo.step(dt);
    if (auto text = servo.control(spring.at(servo), dt)) told.push_back(*text);
  }
  return told;
}

TEST(Servo, HalvesWhatIsLackingAtEachLook) {
  Servo servo = acting(servo_deck());
  const Spring spring = {0.0, 1e3};
  run(servo, spring, 61);  // 0.05 mm a look at most until it is near
  double lacking = 3.0 - servo.force();
  for (int k = 0; k < 8; ++k) {
    run(servo, spring, 1);
    const double before = std::exchange(lacking, 3.0 - servo.force());
    EXPECT_NEAR(lacking, 0.5 * before, 1e-9);
  }
  EXPECT_EQ(run(servo, spring, 100).size(), 0U);
  EXPECT_NEAR(servo.way(), 3e-3, 1e-12);
  EXPECT_TRUE(servo.holds(dt));
  EXPECT_EQ(servo.placement().shift, servo.way() * (Vec3{0.0, 0.0, -1.0}));
}

TEST(Servo, NeverExceedsItsSpeed) {
  Servo servo = acting(servo_deck());
  const Spring spring = {1e-3, 1e3};
  double fastest = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double before = servo.way();
    run(servo, spring, 1);
    fastest = std::max(fastest, std::fabs(servo.way() - before) / (5 * dt));
  }
  EXPECT_NEAR(fastest, 0.1, 1e-12);
}

TEST(Servo, FollowsATargetOverTimeAndGoesBack) {
  ServoDeck deck = servo_deck();
  deck.times = {0.0, 0.2, 0.4};
  deck.factors = {0.0, 1.0, 0.25};
  Servo servo = acting(deck);
  const Spring spring = {0.0, 1e3};
  run(servo, spring, 200);
  EXPECT_NEAR(servo.target(dt), 1.5, 1e-12);
  EXPECT_NEAR(servo.force(), 1.5, 0.05);  // behind by some looks
  EXPECT_FALSE(servo.holds(dt));
  run(servo, spring, 700);
  EXPECT_NEAR(servo.force(), 0.75, 1e-9);
  EXPECT_TRUE(servo.holds(dt));
}

TEST(Servo, SaysOnceThatItFindsNoResistance) {
  ServoDeck deck = servo_deck();
  deck.max_way = 0.00203;  // between two looks
  Servo servo = acting(deck);
  const std::vector<std::string> told = run(servo, {1.0, 1e3}, 200);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("max_way = 0.00203 m"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("no resistance"), std::string::npos) << told[0];
  EXPECT_EQ(servo.way(), 0.00203);
  EXPECT_EQ(servo.placement().motion.velocity, Vec3{});
}

TEST(Servo, StandsAtItsEndUntilTheForceIsBeyondTheTarget) {
  ServoDeck deck = servo_deck();
  deck.max_way = 0.001;
  Servo servo = acting(deck);
  const std::vector<std::string> told = run(servo, {0.0, 1e3}, 200);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("press with 1 N of 3 N; the wall stays there"), std::string::npos) << told[0];
  EXPECT_FALSE(servo.holds(dt));
  run(servo, {0.0, 4e3}, 200);
  EXPECT_NEAR(servo.way(), 0.75e-3, 1e-12);
}

TEST(Servo, GoesBackToTheLeastWayAtMost) {
  ServoDeck deck = servo_deck();
  deck.min_way = -1e-3;
  Servo servo = acting(deck);
  const std::vector<std::string> told = run(servo, {-0.02, 1e3}, 200);  // presses everywhere with more
  EXPECT_EQ(servo.way(), -1e-3);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("min_way"), std::string::npos) << told[0];
}

ServoDeck turning_deck() {
  ServoDeck deck;
  deck.enabled = true;
  deck.type = ServoType::rotation;
  deck.axis_origin = {0.01, 0.0, 0.0};
  deck.axis_direction = {0.0, 3.0, 0.0};
  deck.torque = 0.2;
  deck.max_angular_velocity = 2.0;
  deck.max_angle = 90.0;
  deck.every = 5;
  return deck;
}

TEST(TurningServo, TurnsATorsionSpringUntilItsTorqueIsTheTarget) {
  Servo servo = acting(turning_deck());
  const Spring spring = {0.1, 0.5};  // rad, N m/rad
  run(servo, spring, 20);
  EXPECT_NEAR(servo.way(), 19 * 5 * dt * 2.0, 1e-12);  // nothing is felt: as fast as it may
  const SurfaceMotion motion = servo.placement().motion;
  EXPECT_EQ(motion.angular_velocity, (Vec3{0.0, 2.0, 0.0}));
  EXPECT_EQ(motion.at({0.01, 7.0, 0.0}), Vec3{});
  EXPECT_NEAR(motion.at({0.03, 7.0, 0.0}).z, -0.04, 1e-15);
  EXPECT_EQ(run(servo, spring, 1000).size(), 0U);
  EXPECT_NEAR(servo.way(), 0.5, 1e-12);
  EXPECT_NEAR(servo.angle_deg(), 90.0 / pi, 1e-9);
  EXPECT_NEAR(servo.force(), 0.2, 1e-12);
  EXPECT_TRUE(servo.holds(dt));
  const Vec3 x = servo.placement().place({0.03, 7.0, 0.0});
  EXPECT_NEAR(x.x, 0.01 + 0.02 * std::cos(0.5), 1e-15);
  EXPECT_NEAR(x.y, 7.0, 1e-15);
  EXPECT_NEAR(x.z, -0.02 * std::sin(0.5), 1e-15);
}

TEST(TurningServo, ALoadAboutItsAxisIsThatOfForceTimesLeverAndOfTorque) {
  const Servo servo = acting(turning_deck());
  EXPECT_DOUBLE_EQ(servo.axis().load({0.03, 0.5, 0.0}, {0.0, 0.0, -2.0}, {5.0, 0.01, 7.0}), 0.05);
  EXPECT_DOUBLE_EQ(acting(servo_deck()).axis().load({0.03, 0.5, 0.0}, {1.0, 1.0, -2.0}, {5.0, 0.01, 7.0}), 2.0);
}

TEST(TurningServo, SaysAtWhichAngleItEnds) {
  ServoDeck deck = turning_deck();
  deck.max_angle = 30.0;
  deck.min_angle = -20.0;
  Servo servo = acting(deck);
  std::vector<std::string> told = run(servo, {10.0, 1.0}, 2000);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("max_angle = 30 degrees, where the grains press with 0 N m of 0.2 N m: it has found no "
                         "resistance; look at its axis and at where the grains are, or raise max_angle"),
            std::string::npos)
      << told[0];
  EXPECT_NEAR(servo.angle_deg(), 30.0, 1e-12);
  servo = acting(deck);
  told = run(servo, {-10.0, 1.0}, 2000);  // turns it back everywhere
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("min_angle = -20 degrees"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("stays there until the torque is beyond the target"), std::string::npos) << told[0];
  EXPECT_NEAR(servo.angle_deg(), -20.0, 1e-12);
}

TEST(TurningServo, NoPointOfTheDomainIsFasterThanTheBound) {
  WallDeck wall;
  wall.servo = turning_deck();
  const DomainDeck domain = {{-1.0, -2.0, -3.0}, {2.0, 1.0, 1.0}};
  EXPECT_NEAR(greatest_speed(wall, domain), 2.0 * std::hypot(1.99, 3.0), 1e-12);
  wall.servo = servo_deck();
  EXPECT_EQ(greatest_speed(wall, domain), 0.1);
}

// A blade that turns about y at 20 rad/s, pressed along x: by 40 mm its corner is at (-90, 50) mm from its axis.
TEST(Servo, ThatCarriesARotationAlongLetsItReachFarther) {
  WallDeck wall;
  wall.servo = servo_deck();
  wall.servo.direction = {1.0, 0.0, 0.0};
  MotionDeck turn;
  turn.type = MotionType::rotation;
  turn.axis_direction = {0.0, 1.0, 0.0};
  turn.angular_velocity = 20.0;
  wall.motions = {turn};
  const DomainDeck domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  EXPECT_GT(greatest_speed(wall, domain), 20.0 * std::hypot(0.09, 0.05) + 0.1);
}

TEST(Servo, HoldsTheWallInOtherPhases) {
  ServoDeck deck = servo_deck();
  deck.phases = {"press"};
  Servo servo(deck);
  servo.begin_phase("press");
  run(servo, {1.0, 1e3}, 3);
  const double way = servo.way();
  EXPECT_GT(way, 0.0);
  servo.begin_phase("rest");
  EXPECT_FALSE(servo.is_due(5));
  for (int k = 0; k < 10; ++k) servo.step(dt);
  EXPECT_EQ(servo.way(), way);
  EXPECT_EQ(servo.placement().motion.velocity, Vec3{});
}

}  // namespace
}  // namespace repose
