#include "measurement/contact_list.h"

#include <cmath>

#include <gtest/gtest.h>

#include "output/contacts_file.h"
#include "support/scenes.h"

namespace repose {
namespace {

constexpr double radius = 2e-4;

/// Grains that bounce without loss between a floor and a lid, in a domain that repeats itself in x and y: no dashpots,
/// whose velocities would be those of half a step ago.
Deck squeezed_deck() {
  test::Coefficients c;
  c.restitution_pp = c.restitution_pw = 1.0;
  Deck deck = test::bare_deck(c, 2e-6);
  deck.domain = {{0.0, 0.0, -1e-3}, {8.5 * radius, 8.5 * radius, 0.01}};
  deck.domain.periodic = {Axis::x, Axis::y};
  deck.walls = {test::floor_at(0.0), test::floor_at(1.55e-3)};
  deck.walls[1].name = "lid";
  deck.walls[1].normal = {0.0, 0.0, -1.0};
  MotionDeck lift;
  lift.type = MotionType::translation;
  lift.velocity = {0.0, 0.0, 0.1};
  deck.walls[0].motions = {lift};
  return deck;
}

std::vector<test::Grain> grains() {
  std::vector<test::Grain> all;
  for (int k = 0; k < 48; ++k) {
    const auto askew = [&](double frequency) { return 0.3 * radius * std::sin(frequency * (k + 1)); };
    const Vec3 place{(2.125 * (k % 4) + 1.0) * radius + askew(1.7), (2.125 * (k / 4 % 4) + 1.0) * radius + askew(2.9),
                     (2.5 * (k / 16) + 1.4) * radius + askew(4.1)};
    all.push_back({place, {300.0 * askew(5.3), 300.0 * askew(0.7), 0.0}, {}, (0.85 + 0.001 * k) * radius});
  }
  return all;
}

/// The force sums of the run by id, in N, and their units: x, y, z, unit of each particle, on every rank.
std::vector<double> forces_of_run(const Simulation& simulation) {
  std::vector<double> values(4 * static_cast<std::size_t>(simulation.inserted()));
  const Particles& particles = simulation.particles();
  for (std::size_t i = 0; i < particles.owned; ++i) {
    double* row = &values[4 * static_cast<std::size_t>(particles.id[i])];
    row[3] = 1.0 / particles.record[i].force_scale;
    for (std::size_t k = 0; k < 3; ++k) row[k] = static_cast<double>(particles.sum[i].force[k]) * row[3];
  }
  simulation.comm().sum_elements(std::span(values.begin(), values.end()));
  return values;
}

TEST(ContactList, GivesTheForcesOfTheRunOnEachParticle) {
  test::Scene scene(squeezed_deck(), grains());
  scene.simulation().begin_phase("only");
  scene.run(4000);
  const Simulation& s = scene.simulation();
  const std::vector<ListedContact> contacts =
      list_contacts(s.comm(), s.vector_level(), s.walls(), s.materials(), s.particles(), s.pairs(), s.wall_contacts());
  const std::vector<double> of_run = forces_of_run(s);
  if (!s.comm().is_root()) {
    EXPECT_TRUE(contacts.empty());
    return;
  }
  std::vector<Vec3> sum(of_run.size() / 4);
  int walls = 0;
  double tangential = 0.0;
  for (const ListedContact& c : contacts) {
    const Vec3 force = c.normal_force + c.tangential_force;
    sum[static_cast<std::size_t>(c.first)] += force;
    if (c.second >= 0) sum[static_cast<std::size_t>(c.second)] += -force;
    EXPECT_EQ(c.second >= 0, c.wall < 0);
    EXPECT_TRUE(c.second < 0 || c.first < c.second);
    EXPECT_LT(norm(c.centre - c.other), 2.0 * radius);
    EXPECT_GE(c.centre.x, 0.0);
    EXPECT_LT(c.centre.x, 8.5 * radius);
    walls += c.second < 0 ? 1 : 0;
    tangential = std::max(tangential, norm(c.tangential_force));
  }
  EXPECT_GT(walls, 3);
  EXPECT_GT(contacts.size(), 20U);
  EXPECT_GT(tangential, 1e-6);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Vec3 expected{of_run[4 * i], of_run[4 * i + 1], of_run[4 * i + 2]};
    EXPECT_LT(norm(sum[i] - expected), 1e-11 * norm(expected) + 40.0 * of_run[4 * i + 3]) << i;
  }
}

TEST(ContactList, WithoutContactsMakesAFile) {
  const std::string text = contacts_text({}, 0.5);
  EXPECT_NE(text.find("NumberOfPoints=\"0\""), std::string::npos);
  EXPECT_NE(text.find("NumberOfLines=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace repose
