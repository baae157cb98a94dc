#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "deck/resolved_deck.h"
#include "fields/find_contacts.h"
#include "fields/state.h"
#include "files/shared_file.h"
#include "output/checkpoint.h"
#include "output/collect_particles.h"
#include "output/snapshot.h"
#include "output/state_json.h"
#include "scene/particles/sphere_mass.h"
#include "support/scenes.h"

namespace repose::fields {
namespace {

constexpr double radius = 2e-4;

/// Grains over a floor, in a domain that repeats itself in x and y.
Deck bed_deck(double restitution) {
  test::Coefficients c;
  c.restitution_pp = c.restitution_pw = restitution;
  Deck deck = test::bare_deck(c, 2e-6);
  deck.domain = {{0.0, 0.0, -1e-3}, {8.5 * radius, 8.5 * radius, 0.01}};
  deck.domain.periodic = {Axis::x, Axis::y};
  deck.gravity = {0.0, 0.0, -9.81};
  deck.walls = {test::floor_at(0.0)};
  PhaseDeck phase;
  phase.name = "only";
  phase.until = PhaseUntil::steps;
  phase.steps = 1;
  deck.phases = {phase};
  return deck;
}

/// Layers of 4 x 4 grains, out of line by up to a third of a radius, each a little larger than the one before.
std::vector<test::Grain> layers(int count) {
  std::vector<test::Grain> grains;
  for (int k = 0; k < 16 * count; ++k) {
    const auto askew = [&](double frequency) { return 0.3 * radius * std::sin(frequency * (k + 1)); };
    const Vec3 place{(2.125 * (k % 4) + 1.0) * radius + askew(1.7), (2.125 * (k / 4 % 4) + 1.0) * radius + askew(2.9),
                     (2.5 * (k / 16) + 1.4) * radius + askew(4.1)};
    grains.push_back({place, {300.0 * askew(5.3), 300.0 * askew(0.7), 0.0}, {}, (0.85 + 0.001 * k) * radius});
  }
  return grains;
}

/// What a checkpoint of the simulation tells.
State state_of(Simulation& simulation) {
  StateWriter state;
  state("simulation", simulation);
  const std::string path = testing::TempDir() + "fields_contacts_test.hdf";
  write_checkpoint(simulation.comm(), path,
                   {.step = simulation.steps(),
                    .time_s = simulation.time(),
                    .deck = resolved_deck(simulation.deck()),
                    .build = {},
                    .state_hash = "",
                    .state = state.json().dump()},
                   simulation.particles(), simulation.contact_memory());
  const std::string bytes = read_whole_file(path);
  std::remove(path.c_str());
  return read_state(bytes, path, {}, [](const std::string&) { return std::string(); });
}

/// What a snapshot of the simulation tells. `read_file` reads the files of its deck.
State snapshot_of(const Simulation& simulation, const ReadFile& read_file) {
  const Communicator& comm = simulation.comm();
  SnapshotHeader header;
  header.step = simulation.steps();
  header.time_s = simulation.time();
  header.deck = resolved_deck(simulation.deck());
  header.inserted = header.inside = simulation.inserted();
  for (const MaterialDeck& m : simulation.deck().materials) header.materials.push_back(m.name);
  const std::string path = testing::TempDir() + "fields_contacts_snapshot.hdf";
  write_snapshot(comm, path,
                 collect_particles(comm, simulation.materials(), simulation.particles(), simulation.planned()), header);
  const std::string bytes = read_whole_file(path);
  std::remove(path.c_str());
  return read_state(bytes, path, {}, read_file);
}

/// The force of all contacts on each grain, by its place in the domain.
std::map<std::tuple<double, double, double>, Vec3> force_on_grains(const State& state, const ContactForces& contacts) {
  std::map<std::tuple<double, double, double>, Vec3> sum;
  const auto at = [&](const Vec3& place) -> Vec3& {
    const Vec3 inside = state.particles.periodic.wrapped(place);
    return sum[{inside.x, inside.y, inside.z}];
  };
  for (const ContactForce& c : contacts.pairs) {
    at(c.centre) += c.force;
    at(c.other) += -c.force;
  }
  for (const ContactForce& c : contacts.walls) at(c.centre) += c.force;
  return sum;
}

TEST(FieldsContacts, OfACheckpointGiveTheForcesOfTheRun) {
  Deck deck = bed_deck(1.0);  // no dashpots: their velocities would be those of half a step ago
  MotionDeck lift;
  lift.type = MotionType::translation;
  lift.velocity = {0.0, 0.0, 0.1};
  deck.walls[0].motions = {lift};
  deck.walls.push_back(test::floor_at(1.55e-3));  // what bounces without loss is squeezed
  deck.walls[1].name = "lid";
  deck.walls[1].normal = {0.0, 0.0, -1.0};
  test::Scene scene(deck, layers(3));
  scene.simulation().begin_phase("only");
  scene.run(4000);
  const State state = state_of(scene.simulation());
  EXPECT_NEAR(state.walls[0].placement.shift.z, 8e-4, 1e-15);
  const ContactForces contacts = find_contacts(state, "a.hdf");
  EXPECT_GT(contacts.pairs.size(), 10U);
  EXPECT_GT(contacts.walls.size(), 3U);
  const auto forces = force_on_grains(state, contacts);
  const Particles& particles = scene.simulation().particles();
  std::size_t across = 0;
  for (const ContactForce& c : contacts.pairs) {
    across +=
        c.other == particles.periodic.wrapped(c.other) && c.centre == particles.periodic.wrapped(c.centre) ? 0U : 1U;
  }
  EXPECT_GT(across, 2U);
  double greatest = 0.0;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const Vec3 place = particles.position(i);
    const auto found = forces.find({place.x, place.y, place.z});
    const Vec3 force = found == forces.end() ? Vec3{} : found->second;
    const ForceSum& sum = particles.sum[i];
    const double unit = 1.0 / particles.record[i].force_scale;
    const Vec3 of_run = unit * Vec3{static_cast<double>(sum.force[0]), static_cast<double>(sum.force[1]),
                                    static_cast<double>(sum.force[2])};
    EXPECT_LT(norm(force - of_run), 1e-11 * norm(of_run) + 20.0 * unit) << i;
    greatest = std::max(greatest, norm(of_run));
    touching += found == forces.end() ? 0U : 1U;
  }
  EXPECT_GT(touching, 20U);
  EXPECT_GT(greatest, 1e-6);
}

TEST(FieldsContacts, OfASettledBedCarryTheWeightOfEachGrain) {
  test::Scene scene(bed_deck(0.3), layers(4));
  scene.simulation().begin_phase("only");
  scene.run(100000);
  const State state = state_of(scene.simulation());
  const ContactForces contacts = find_contacts(state, "a.hdf");
  const auto forces = force_on_grains(state, contacts);
  ASSERT_EQ(forces.size(), state.particles.owned);
  double weight_of_all = 0.0;
  for (std::size_t i = 0; i < state.particles.owned; ++i) {
    const ParticleRecord& p = state.particles.record[i];
    const double weight = 9.81 * sphere_mass(p.radius, 3592.0);
    const Vec3 force = forces.at({p.position.x, p.position.y, p.position.z});
    EXPECT_LT(norm(force - Vec3{0.0, 0.0, weight}), 1e-4 * weight) << i << " moves at " << norm(p.velocity);
    weight_of_all += weight;
  }
  Vec3 floor;
  for (const ContactForce& c : contacts.walls) {
    floor += c.force;
    EXPECT_EQ(c.other.z, 0.0);
  }
  EXPECT_NEAR(floor.z, weight_of_all, 1e-5 * weight_of_all);
}

// Two held grains that stick in one another and in the floor, and a grain that has fallen on one of them.
TEST(FieldsContacts, OfHeldGrainsAreThoseWithOthersAloneInASnapshotToo) {
  const std::string columns = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
  const ReadFile read_file = [&](const std::string& file) {
    if (file == "free.csv") return columns + "4e-4,4e-4,4.9e-4,0,0,-0.1,0,0,0,2e-4,grain\n";
    return columns + "4e-4,4e-4,1e-4,0,0,0,0,0,0,2e-4,grain\n7.6e-4,4e-4,1e-4,0,0,0,0,0,0,2e-4,grain\n";
  };
  Deck deck = bed_deck(0.3);
  for (const char* file : {"free.csv", "held.csv"}) {
    ParticlesDeck block;
    block.type = ParticlesType::csv;
    block.file = file;
    deck.particles.push_back(block);
  }
  deck.particles[1].fixed = true;
  const Communicator world(MPI_COMM_WORLD);
  Simulation simulation(world, deck, read_file, best_vector_level());
  const ContactForces of_checkpoint = find_contacts(state_of(simulation), "a.hdf");
  const ContactForces of_snapshot = find_contacts(snapshot_of(simulation, read_file), "b.hdf");
  EXPECT_EQ(of_snapshot.walls.size(), 0U);
  ASSERT_EQ(of_snapshot.pairs.size(), 1U);
  ASSERT_EQ(of_checkpoint.pairs.size(), 1U);
  const Vec3& force = of_checkpoint.pairs[0].force;  // its dashpot knows that the other does not give way
  EXPECT_LT(norm(of_snapshot.pairs[0].force - force), 1e-10 * norm(force));
}

TEST(FieldsContacts, OfASnapshotLeaveOutWallsThatComeAndGoWithOthers) {
  Deck deck = bed_deck(0.3);
  for (const char* name : {"lid", "roof"}) {
    deck.walls.push_back(test::floor_at(5e-3));
    deck.walls.back().name = name;
    deck.walls.back().normal = {0.0, 0.0, -1.0};
  }
  deck.walls[1].moves_with = "floor";
  deck.phases[0].remove_walls = {"floor"};
  test::Scene scene(deck, layers(1));
  const State state = snapshot_of(scene.simulation(), {});
  EXPECT_EQ(state.unknown_walls, (std::vector<std::string>{"floor", "lid"}));
}

TEST(FieldsContacts, WithoutHistoryAreNormal) {
  test::Scene scene(bed_deck(0.3), layers(4));
  scene.run(5000);
  State state = state_of(scene.simulation());
  const ContactForces whole = find_contacts(state, "a.hdf");
  state.memory = {Csr<PairMemory>::empty(state.particles.owned), Csr<WallMemory>::empty(state.particles.owned)};
  state.remembers = false;
  const ContactForces normal = find_contacts(state, "a.hdf");
  ASSERT_EQ(normal.pairs.size(), whole.pairs.size());
  ASSERT_EQ(normal.walls.size(), whole.walls.size());
  double tangential = 0.0;
  const auto compare = [&](const std::vector<ContactForce>& a, const std::vector<ContactForce>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Vec3 branch = a[k].centre - a[k].other;
      EXPECT_LT(norm(cross(a[k].force, branch)), 1e-14 * norm(a[k].force) * norm(branch));
      EXPECT_NEAR(dot(a[k].force, branch), dot(b[k].force, branch),
                  1e-10 * norm(b[k].force) * norm(branch) + 1e-20);  // units of force sums
      tangential = std::max(tangential, norm(cross(b[k].force, branch)) / (norm(b[k].force) * norm(branch)));
    }
  };
  compare(normal.pairs, whole.pairs);
  compare(normal.walls, whole.walls);
  EXPECT_GT(tangential, 0.01);
}

}  // namespace
}  // namespace repose::fields
