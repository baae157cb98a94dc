// The contact law against values worked out by hand and against its limits.
#include <cmath>

#include <gtest/gtest.h>

#include "contact_samples.h"
#include "scene/particles/damping.h"

namespace repose::test {
namespace {

constexpr double sqrt_five_sixths = 0.9128709291752769;

TEST(Hertz, SpringsAndDashpotsByHand) {
  const ContactStiffness k = hertz_stiffness(round_pair(), round_contact());
  EXPECT_NEAR(k.normal, 80.0, 1e-12);
  EXPECT_NEAR(k.tangential, 160.0, 1e-12);
  EXPECT_NEAR(k.normal_damping, sqrt_five_sixths * 0.012, 1e-16);  // -2 sqrt(5/6) beta sqrt(120 x 1.2e-6)
  EXPECT_NEAR(k.tangential_damping, sqrt_five_sixths * std::sqrt(160.0 * 1.2e-6), 1e-16);
}

TEST(Hertz, ForceGrowsWithTheOverlapToTheThreeHalves) {
  ContactGeometry contact = round_contact();
  EXPECT_NEAR(hertz_force(hertz_stiffness(round_pair(), contact), contact), 8e-5, 1e-18);
  contact.overlap *= 4.0;
  EXPECT_NEAR(hertz_force(hertz_stiffness(round_pair(), contact), contact), 8.0 * 8e-5, 1e-17);
  contact.overlap = 0.0;
  EXPECT_EQ(hertz_force(hertz_stiffness(round_pair(), contact), contact), 0.0);
}

TEST(Hertz, DampingOpposesTheVelocityAndMayAttract) {
  ContactGeometry contact = round_contact();
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  contact.normal_velocity = -0.01;
  EXPECT_NEAR(hertz_force(k, contact), 8e-5 + 0.01 * k.normal_damping, 1e-18);
  contact.normal_velocity = 0.01;
  EXPECT_NEAR(hertz_force(k, contact), 8e-5 - 0.01 * k.normal_damping, 1e-18);
  EXPECT_LT(hertz_force(k, contact), 0.0);
}

TEST(Hertz, NoDampingAtRestitutionOne) {
  PairParameters pair = round_pair();
  pair.damping_ratio = damping_ratio(1.0);
  const ContactStiffness k = hertz_stiffness(pair, round_contact());
  EXPECT_EQ(k.normal_damping, 0.0);
  EXPECT_EQ(k.tangential_damping, 0.0);
}

TEST(Mindlin, SpringStretchesWithoutItsNormalPart) {
  ContactGeometry contact = round_contact();
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  contact.tangential_velocity = {0.001, 0.0, 0.0};
  Vec3 spring = {0.0, 3e-9, 5e-9};  // the last is along the normal
  const Vec3 force = mindlin_force(round_pair(), k, contact, 1.0, 4e-6, spring);
  EXPECT_NEAR(spring.x, 4e-9, 1e-24);
  EXPECT_NEAR(spring.y, 3e-9, 1e-24);
  EXPECT_EQ(spring.z, 0.0);
  EXPECT_NEAR(force.x, -160.0 * 4e-9 - k.tangential_damping * 0.001, 1e-20);
  EXPECT_NEAR(force.y, -160.0 * 3e-9, 1e-20);
  EXPECT_EQ(force.z, 0.0);
}

TEST(Mindlin, NormalPartIsRemovedForAnyNormal) {
  Draw draw(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const ContactGeometry contact = random_contact(draw);
    Vec3 spring = draw.vector(1e-7);
    const Vec3 projected = without_normal_part(spring, contact.normal);
    mindlin_force(round_pair(), hertz_stiffness(round_pair(), contact), contact, 1e3, 0.0, spring);
    EXPECT_NEAR(dot(spring, contact.normal), 0.0, 1e-22);  // 2^-52 of the spring's length
    EXPECT_EQ(spring, projected);                          // a projection: no rescaling
  }
}

TEST(Mindlin, CoulombCutsTheForceAndTheSpringFollows) {
  ContactGeometry contact = round_contact();
  contact.tangential_velocity = {0.3, -0.1, 0.0};  // a dashpot would show
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  for (const double normal_force : {8e-5, -8e-5}) {  // the limit is of the magnitude
    Vec3 spring = {3e-6, 4e-6, 0.0};
    const Vec3 force = mindlin_force(round_pair(), k, contact, normal_force, 0.0, spring);
    EXPECT_NEAR(force.x, -0.6 * 4e-5, 1e-19);  // mu |F_n| = 4e-5 N
    EXPECT_NEAR(force.y, -0.8 * 4e-5, 1e-19);
    EXPECT_NEAR(spring.x, 0.6 * 4e-5 / 160.0, 1e-21);
    EXPECT_NEAR(spring.y, 0.8 * 4e-5 / 160.0, 1e-21);
  }
}

TEST(Mindlin, JustBelowTheLimitItSticks) {
  ContactGeometry contact = round_contact();
  contact.tangential_velocity = {0.1, 0.0, 0.0};
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  Vec3 spring = {0.0, 0.999 * 4e-5 / 160.0, 0.0};
  const Vec3 before = spring;
  const Vec3 force = mindlin_force(round_pair(), k, contact, 8e-5, 0.0, spring);
  EXPECT_EQ(spring, before);
  EXPECT_NEAR(force.x, -0.1 * k.tangential_damping, 1e-18);  // the dashpot acts; the limit is not looked at again
}

TEST(Mindlin, WithoutFrictionThereIsNoForce) {
  PairParameters pair = round_pair();
  pair.sliding_friction = 0.0;
  ContactGeometry contact = round_contact();
  contact.tangential_velocity = {0.1, 0.2, 0.0};
  Vec3 spring;
  const Vec3 force = mindlin_force(pair, hertz_stiffness(pair, contact), contact, 8e-5, 1e-6, spring);
  EXPECT_EQ(norm(force), 0.0);
  EXPECT_EQ(norm(spring), 0.0);
}

TEST(Epsd2, MomentGrowsWithTheRotation) {
  ContactGeometry contact = round_contact();
  contact.rolling_velocity = {2.0, 0.0, 0.0};
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  const Vec3 moment = epsd2_moment(round_pair(), k, contact, 8e-5, 1e-6, {0.0, 1e-12, 0.0});
  EXPECT_NEAR(moment.x, 160.0 * 1.6e-7 * 2.0 * 1e-6, 1e-26);  // k_t R_eff^2 w dt
  EXPECT_NEAR(moment.y, 1e-12, 1e-26);
}

TEST(Epsd2, TheCapIsStored) {
  ContactGeometry contact = round_contact();
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  const double cap = 0.25 * 8e-5 * 4e-4;  // mu_r |F_n| R_eff = 8e-9 N m
  for (const double normal_force : {8e-5, -8e-5}) {
    const Vec3 moment = epsd2_moment(round_pair(), k, contact, normal_force, 0.0, {3e-8, 0.0, 4e-8});
    EXPECT_NEAR(moment.x, 0.6 * cap, 1e-23);
    EXPECT_NEAR(moment.z, 0.8 * cap, 1e-23);
  }
  ContactHistory history = {{}, {3e-8, 0.0, 4e-8}};
  const ContactForces forces = contact_law(round_pair(), contact, 0.0, history);
  EXPECT_EQ(history.rolling, forces.rolling_moment);
  EXPECT_NEAR(norm(history.rolling), cap, 1e-23);
}

TEST(ContactLaw, JoinsItsParts) {
  ContactGeometry contact = round_contact();
  contact.normal_velocity = -0.002;
  contact.tangential_velocity = {0.001, 0.0, 0.0};
  contact.rolling_velocity = {0.0, 3.0, 0.0};
  ContactHistory history;
  const ContactForces forces = contact_law(round_pair(), contact, 1e-6, history);
  const ContactStiffness k = hertz_stiffness(round_pair(), contact);
  const double f_n = 8e-5 + 0.002 * k.normal_damping;
  const double f_t = -160.0 * 1e-9 - 0.001 * k.tangential_damping;
  EXPECT_NEAR(forces.force.x, f_t, 1e-19);
  EXPECT_NEAR(forces.force.z, f_n, 1e-19);
  EXPECT_NEAR(forces.friction_arm.y, f_t, 1e-19);  // z x (f_t, 0, f_n) = (0, f_t, 0)
  EXPECT_NEAR(forces.rolling_moment.y, 160.0 * 1.6e-7 * 3.0 * 1e-6, 1e-25);
  EXPECT_NEAR(history.spring.x, 1e-9, 1e-24);
}

TEST(ContactLaw, WithoutTimeTheHistoryStays) {
  Draw draw(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const ContactGeometry contact = random_contact(draw);
    ContactHistory history = {without_normal_part(1e-12 * draw.direction(), contact.normal), 1e-20 * draw.direction()};
    const ContactHistory before = history;
    PairParameters pair = round_pair();
    pair.damping_ratio = 0.0;  // so that the normal force cannot vanish and cut
    contact_law(pair, contact, 0.0, history);
    EXPECT_NEAR(norm(history.spring - before.spring), 0.0, 1e-27);  // projected once more
    EXPECT_EQ(history.rolling, before.rolling);
  }
}

// Actio = reactio: seen from the other body every vector changes its sign, and negation is exact.
TEST(ContactLaw, TheSameBitsFromEitherBody) {
  Draw draw(3);
  int cut = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    ContactGeometry contact = random_contact(draw);
    ContactHistory history = {draw.vector(1e-6), draw.vector(1e-9)};
    ContactHistory mirrored = {-history.spring, -history.rolling};
    const Vec3 stretched = without_normal_part(history.spring + 1e-6 * contact.tangential_velocity, contact.normal);
    const ContactForces forces = contact_law(round_pair(), contact, 1e-6, history);
    contact.normal = -contact.normal;
    contact.tangential_velocity = -contact.tangential_velocity;
    contact.rolling_velocity = -contact.rolling_velocity;
    const ContactForces other = contact_law(round_pair(), contact, 1e-6, mirrored);
    EXPECT_EQ(other.force, -forces.force);
    EXPECT_EQ(other.friction_arm, forces.friction_arm);
    EXPECT_EQ(other.rolling_moment, -forces.rolling_moment);
    EXPECT_EQ(mirrored.spring, -history.spring);
    EXPECT_EQ(mirrored.rolling, -history.rolling);
    cut += norm(history.spring) < 0.999 * norm(stretched) ? 1 : 0;
  }
  EXPECT_GT(cut, 200);  // both sides of Coulomb's limit were seen
  EXPECT_LT(cut, 1800);
}

}  // namespace
}  // namespace repose::test
