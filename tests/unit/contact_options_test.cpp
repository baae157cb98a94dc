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

TEST(Hooke, IsAsDeepAsHertzAtTheCharacteristicVelocity) {
  PairParameters pair = hooke_pair();
  pair.options.hooke_characteristic_velocity = 0.3;
  const ContactGeometry contact = round_contact();
  const double k = hooke_stiffness(pair, contact).normal;
  const double energy = 0.5 * contact.mass_eff * 0.3 * 0.3;
  const double depth = std::sqrt(2.0 * energy / k);
  const double hertz = 8.0 / 15.0 * pair.youngs_modulus_eff * std::sqrt(contact.radius_eff) * std::pow(depth, 2.5);
  EXPECT_NEAR(hertz / energy, 1.0, 1e-14);
}

TEST(Hooke, TakesDampingRatesInPlaceOfTheRestitution) {
  PairParameters pair = hooke_pair();
  pair.coefficients.hooke_damping_rate = 5000.0;
  pair.coefficients.hooke_tangential_damping_rate = 2000.0;
  ContactGeometry contact = round_contact();
  EXPECT_NEAR(hooke_stiffness(pair, contact).normal_damping, 0.006, 1e-17);  // 5000 x 1.2e-6
  EXPECT_NEAR(hooke_stiffness(pair, contact).tangential_damping, 0.0024, 1e-17);
  contact.overlap = 0.0;
  EXPECT_EQ(hooke_stiffness(pair, contact).normal_damping, 0.0);
}

TEST(OddRoots, HaveTheirPowers) {
  for (double x = 1e-60; x < 1e60; x *= 1.37) {
    const double fifth = odd_root<5>(x);
    EXPECT_NEAR(fifth * fifth * fifth * fifth * fifth / x, 1.0, 5 * 4e-16) << x;
    EXPECT_NEAR(odd_root<3>(x) / std::cbrt(x), 1.0, 5e-16) << x;
  }
}

TEST(ViscousFriction, IsTheDashpotUpToCoulombsLimit) {
  PairParameters pair = round_pair();
  pair.options.tangential_spring = TangentialSpring::none;
  ContactGeometry contact = round_contact();
  contact.velocity_normal = contact.normal;
  const double c_t = hertz_stiffness(pair, contact).tangential_damping;
  const double limit = 0.5 * 8e-5;  // mu F_n
  for (const double share : {0.5, 2.0}) {
    contact.tangential_velocity = {0.6 * share * limit / c_t, 0.8 * share * limit / c_t, 0.0};
    ContactHistory history = {{1e-7, 0.0, 0.0}, {}};
    const Vec3 force = contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).force;
    EXPECT_NEAR(force.x, -0.6 * std::min(share, 1.0) * limit, 1e-18);
    EXPECT_NEAR(force.y, -0.8 * std::min(share, 1.0) * limit, 1e-18);
    EXPECT_EQ(history.spring, Vec3{});
  }
}

TEST(Cdt, HasTheSizeOfTheSpringsForceAndLeavesTorsionOut) {
  PairParameters pair = round_pair();
  pair.options.rolling_model = RollingModel::cdt;
  ContactGeometry contact = round_contact();
  contact.velocity_normal = contact.normal;
  contact.normal_velocity = -0.5;  // its dashpot does not count
  contact.rolling_velocity = {3.0, 0.0, 0.0};
  contact.twist = 4.0;
  ContactHistory history = {};
  const double size = 0.25 * 4e-4 * 8e-5;  // mu_r R k_n delta
  const Vec3 moment = contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).rolling_moment;
  EXPECT_NEAR(moment.x, 0.6 * size, 1e-23);
  EXPECT_EQ(moment.z, 0.0);
  EXPECT_EQ(history.rolling, Vec3{});
  contact.rolling_velocity = {};
  contact.twist = 0.0;
  EXPECT_EQ(contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).rolling_moment, Vec3{});
}

TEST(Epsd, AddsADashpotThatIsNotRememberedUntilTheLimit) {
  PairParameters pair = round_pair();
  pair.options.rolling_model = RollingModel::epsd;
  pair.coefficients.rolling_viscous_damping = 0.5;
  ContactGeometry contact = round_contact();
  contact.velocity_normal = contact.normal;
  contact.rolling_inertia = 5e-13;
  contact.rolling_velocity = {0.0, 10.0, 0.0};
  const double k_r = 2.25 * 80.0 * 1e-8;  // k_n = 80 N/m, mu_r R = 1e-4 m
  ContactHistory history = {};
  const Vec3 moment = contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).rolling_moment;
  EXPECT_NEAR(history.rolling.y, k_r * 1e-5, 1e-25);
  EXPECT_NEAR(moment.y, k_r * 1e-5 + std::sqrt(5e-13 * k_r) * 10.0, 1e-22);
  contact.rolling_velocity = {0.0, 1e5, 0.0};
  const Vec3 limited = contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).rolling_moment;
  EXPECT_NEAR(limited.y, 0.25 * 4e-4 * 8e-5, 1e-23);
  EXPECT_EQ(history.rolling, limited);
}

TEST(Cohesion, ActsOnTheCircleInWhichTheBodiesCut) {
  PairParameters pair = round_pair();
  pair.options.cohesion = Cohesion::sjkr;
  // radii 5 and 4, centres 6 apart: half a chord h with x = (36 + 25 - 16) / 12, h^2 = 25 - x^2
  const double x = 45.0 / 12.0;
  EXPECT_NEAR(cohesive_area_of_spheres(pair, 5.0, 4.0, 6.0, 3.0), pi * (25.0 - x * x), 1e-13);
  EXPECT_NEAR(cohesive_area_at_wall(pair, 5.0, 4.0, 1.0), pi * 9.0, 1e-13);
  EXPECT_EQ(cohesive_area_of_spheres(pair, 5.0, 4.0, 11.0, 0.0), 0.0);
  pair.options.cohesion = Cohesion::sjkr2;
  EXPECT_NEAR(cohesive_area_of_spheres(pair, 6.0, 3.0, 8.0, 1.0), 8.0 * pi, 1e-13);  // R_eff = 2
  EXPECT_NEAR(cohesive_area_at_wall(pair, 5.0, 4.0, 1.0), 10.0 * pi, 1e-13);
}

TEST(Cohesion, LimitsFrictionWhereItIsAsked) {
  PairParameters pair = round_pair();
  pair.options.cohesion = Cohesion::sjkr2;
  pair.coefficients.cohesion_energy_density = 1e3;
  ContactGeometry contact = round_contact();
  contact.cohesive_area = 2e-8;  // 2e-5 N of the spring's 8e-5
  contact.velocity_normal = contact.normal;
  for (const bool in_friction : {false, true}) {
    pair.options.cohesion_in_friction = in_friction;
    ContactHistory history = {{1e-3, 0.0, 0.0}, {}};  // slides
    const Vec3 force = contact_law_of<GeneralLaw>(pair, contact, 1e-6, history).force;
    EXPECT_NEAR(force.z, 6e-5, 1e-18);
    EXPECT_NEAR(force.x, -0.5 * (in_friction ? 6e-5 : 8e-5), 1e-18);
  }
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
