// The options of the contact law against values worked out by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "contact_samples.h"

namespace repose::test {
namespace {

PairParameters hooke_pair() {
  PairParameters pair = round_pair();
  pair.options.normal_law = NormalLaw::hooke;
  pair.coefficients.hooke_stiffness = 120.0;
  pair.coefficients.hooke_tangential_ratio = 0.25;
  pair.tangential_damping_ratio = 0.5;
  return pair;
}

TEST(Hooke, SpringsAndDashpotsByHand) {
  ContactGeometry contact = round_contact();
  const ContactStiffness k = hooke_stiffness(hooke_pair(), contact);
  EXPECT_EQ(k.normal, 120.0);
  EXPECT_EQ(k.tangential, 30.0);
  EXPECT_NEAR(k.normal_damping, 0.012, 1e-17);      // -2 beta sqrt(120 x 1.2e-6)
  EXPECT_NEAR(k.tangential_damping, 0.006, 1e-17);  // -2 beta sqrt(30 x 1.2e-6)
  contact.overlap = 0.0;
  EXPECT_EQ(hooke_stiffness(hooke_pair(), contact).normal, 0.0);
  EXPECT_EQ(hooke_stiffness(hooke_pair(), contact).normal_damping, 0.0);
}

TEST(Attraction, IsCutAtZero) {
  for (PairParameters pair : {round_pair(), hooke_pair()}) {
    ContactGeometry contact = round_contact();
    contact.normal_velocity = 0.1;
    const ContactStiffness k = GeneralLaw::stiffness(pair, contact, contact_radius(contact));
    const double pull = GeneralLaw::normal_force(pair, k, contact, contact_radius(contact));
    EXPECT_LT(pull, 0.0);
    EXPECT_EQ(pull, hertz_force(k, contact));
    pair.options.attraction = false;
    EXPECT_EQ(GeneralLaw::normal_force(pair, k, contact, contact_radius(contact)), 0.0);
    contact.normal_velocity = -0.1;
    EXPECT_EQ(GeneralLaw::normal_force(pair, k, contact, contact_radius(contact)), hertz_force(k, contact));
  }
}

/// A history along y at first, after its normal has turned from z towards y over `angle` in `steps` steps, without
/// sliding or rolling.
ContactHistory after_turning(const PairParameters& pair, double angle, int steps) {
  ContactHistory history = {{0.0, 1e-9, 0.0}, {0.0, 1e-13, 0.0}};
  ContactGeometry contact = round_contact();
  for (int k = 1; k <= steps; ++k) {
    const double a = angle * k / steps;
    contact.normal = {0.0, std::sin(a), std::cos(a)};
    contact.velocity_normal = contact.normal;
    contact_law_of<GeneralLaw>(pair, contact, 1e-6, history);
  }
  return history;
}

TEST(RotatedHistories, KeepTheirLengthAndStayTangential) {
  PairParameters pair = round_pair();
  pair.options.tangential_spring = TangentialSpring::rotated;
  pair.options.rolling_history = RollingHistory::rotated;
  const double angle = 0.5 * 3.141592653589793;
  for (const int steps : {3, 30, 3000}) {
    const ContactHistory h = after_turning(pair, angle, steps);
    EXPECT_NEAR(norm(h.spring), 1e-9, 1e-21) << steps;  // rounding of 3000 steps
    EXPECT_NEAR(h.spring.z, -1e-9, 1e-21) << steps;     // it has turned from y to -z
    EXPECT_NEAR(norm(h.rolling), 1e-13, 1e-25) << steps;
    EXPECT_NEAR(h.rolling.z, -1e-13, 1e-25) << steps;
  }
}

TEST(ProjectedAndFixedHistories, DoNot) {
  const double angle = 0.5 * 3.141592653589793;
  for (const int steps : {3, 30}) {
    const ContactHistory h = after_turning(round_pair(), angle, steps);
    EXPECT_NEAR(norm(h.spring), 1e-9 * std::pow(std::cos(angle / steps), steps), 1e-21) << steps;
    EXPECT_EQ(h.rolling, (Vec3{0.0, 1e-13, 0.0}));  // by now along the normal
  }
}

TEST(RotatedHistories, OfNothingAreNothing) {
  EXPECT_EQ(rotated_into_plane(Vec3{}, {0.0, 0.0, 1.0}), Vec3{});
  EXPECT_EQ(rotated_into_plane(Vec3{0.0, 0.0, 2.0}, {0.0, 0.0, 1.0}), Vec3{});  // along the normal
}

TEST(SynchronisedVerlet, TakesTheNormalOfHalfAStepAgo) {
  PairParameters pair = round_pair();
  const Vec3 apart = {0.0, 0.0, 1.0};
  const Vec3 velocity = {200.0, 0.0, 0.0};
  EXPECT_EQ(GeneralLaw::velocity_normal(pair, 0.01, apart, velocity, {0.0, 0.0, 1.0}), (Vec3{0.0, 0.0, 1.0}));
  pair.synchronised = true;
  const Vec3 n = GeneralLaw::velocity_normal(pair, 0.01, apart, velocity, {0.0, 0.0, 1.0});
  EXPECT_NEAR(n.x, -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(n.z, std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace repose::test
