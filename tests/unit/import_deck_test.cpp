// What becomes of the commands of a script. The decks are read by the program's own reader.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "deck_error.h"
#include "import/import_script.h"
#include "import_samples.h"
#include "scene/walls/motion.h"

namespace repose {
namespace {

using Files = std::map<std::string, std::string>;

struct Imported {
  Deck deck;
  ImportedDeck imported;
};

Imported import_files(const Files& files, const std::string& dump = "") {
  ImportedDeck imported = import_script("in.x", test::reader_of(files), {}, dump);
  Deck deck = read_deck(imported.deck, "x.toml", {});
  return {std::move(deck), std::move(imported)};
}

Imported import_text(const std::string& script) {
  return import_files({{"in.x", script}, {"face.stl", test::triangle_stl}, {"parts/face.stl", test::triangle_stl}});
}

std::string error_of(const std::string& script) {
  return test::deck_error([&] { import_text(script); });
}

/// `falling` with a text in place of another.
std::string with(std::string script, const std::string& old, const std::string& fresh) {
  const std::size_t at = script.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return script.replace(at, old.size(), fresh);
}
std::string with(const std::string& old, const std::string& fresh) { return with(test::falling, old, fresh); }

/// `falling` with lines before its run.
std::string before_run(const std::string& lines) { return with("run 1000\n", lines + "run 1000\n"); }

const WallDeck& wall(const Deck& deck, const std::string& name) {
  const auto found =
      std::find_if(deck.walls.begin(), deck.walls.end(), [&](const WallDeck& w) { return w.name == name; });
  if (found == deck.walls.end()) throw DeckError("no wall " + name);
  return *found;
}

TEST(ImportDeck, TranslatesTheWhole) {
  const auto [deck, imported] = import_text(test::falling);
  EXPECT_TRUE(imported.missing.empty());
  EXPECT_EQ(deck.gravity, (Vec3{0.0, 0.0, -9.81}));
  EXPECT_EQ(deck.domain.max, (Vec3{0.1, 0.1, 0.4}));
  EXPECT_EQ(deck.run.seed, 10037U);
  ASSERT_EQ(deck.materials.size(), 1U);
  EXPECT_EQ(deck.materials[0].name, "type1");
  EXPECT_EQ(deck.materials[0].youngs_modulus, 5e6);
  EXPECT_EQ(deck.materials[0].density, 2000.0);
  ASSERT_EQ(deck.pairs.size(), 1U);
  EXPECT_EQ(deck.pairs[0].restitution, 0.6);
  EXPECT_EQ(deck.pairs[0].sliding_friction, 0.3);
  EXPECT_EQ(deck.pairs[0].rolling_friction, 0.0);
  EXPECT_EQ(deck.contact, ContactDeck{});
  EXPECT_EQ(wall(deck, "floor").type, WallType::plane);
  ASSERT_EQ(deck.particles.size(), 1U);
  EXPECT_EQ(deck.particles[0].type, ParticlesType::fill);
  EXPECT_EQ(deck.particles[0].count, 50);
  EXPECT_EQ(deck.particles[0].sizes.diameters, std::vector<double>{0.008});
  EXPECT_EQ(deck.particles[0].velocity, (Vec3{0.0, 0.0, -0.5}));
  EXPECT_EQ(deck.time.step, 1e-5);
  ASSERT_EQ(deck.phases.size(), 1U);
  EXPECT_EQ(deck.phases[0].steps, 1000);
}

TEST(ImportDeck, NamesTheLineOfEachPart) {
  const std::string deck = import_text(test::falling).imported.deck;
  for (const std::string line :
       {"[domain]  # in.x:5", "[[wall]]  # in.x:13", "[[particles]]  # in.x:17", "[[phase]]  # in.x:20",
        "restitution = 0.6  # in.x:8", "#   in.x:19: fix move all nve/sphere: grains move by themselves"}) {
    EXPECT_NE(deck.find(line + "\n"), std::string::npos) << line << "\n" << deck;
  }
}

TEST(ImportDeck, KnowsCentimetresAndGrams) {
  std::string script = with("units si", "units cgs");
  const auto [deck, imported] = import_text(script);
  EXPECT_DOUBLE_EQ(deck.domain.max.z, 0.004);
  EXPECT_DOUBLE_EQ(deck.materials[0].youngs_modulus, 5e5);  // dyn/cm2 are tenths of Pa
  EXPECT_DOUBLE_EQ(deck.materials[0].density, 2e6);         // g/cm3
  EXPECT_DOUBLE_EQ(deck.gravity.z, -0.0981);
  EXPECT_DOUBLE_EQ(deck.particles[0].velocity.z, -0.005);
}

TEST(ImportDeck, LetsTheDomainGrowWhereTheBoxDoes) {
  const auto [deck, imported] = import_text(with("boundary f f f", "boundary p f mf"));
  EXPECT_EQ(deck.domain.periodic, std::vector<Axis>{Axis::x});
  EXPECT_EQ(deck.domain.max.z, 0.4);
  EXPECT_LT(deck.domain.min.z, -0.4);
}

TEST(ImportDeck, TranslatesContactModels) {
  const auto contact = [](const std::string& model, const std::string& more = "", const std::string& settings = "") {
    std::string script = with("pair_style gran model hertz tangential history", "pair_style gran " + model + settings);
    script.replace(script.find("model hertz tangential history primitive"), 30, model);
    script.replace(script.find("zplane 0"), 8, "zplane 0" + settings);  // LIGGGHTS has them behind the geometry
    const auto [deck, imported] = import_text(script.insert(script.find("pair_style"), more));
    EXPECT_TRUE(imported.missing.empty());
    return deck;
  };
  const std::string rolling = "fix r all property/global coefficientRollingFriction peratomtypepair 1 0.2\n";
  const std::string viscous = "fix v all property/global coefficientRollingViscousDamping peratomtypepair 1 0.1\n";
  Deck deck = contact("model hertz tangential no_history rolling_friction cdt", rolling);
  EXPECT_EQ(deck.contact.tangential_spring, TangentialSpring::none);
  EXPECT_EQ(deck.contact.rolling_model, RollingModel::cdt);
  EXPECT_EQ(deck.pairs[0].rolling_friction, 0.2);
  deck = contact("model hertz tangential history rolling_friction epsd", rolling + viscous,
                 " limitForce on tangential_damping off");
  EXPECT_EQ(deck.contact.rolling_model, RollingModel::epsd);
  EXPECT_EQ(deck.pairs[0].rolling_viscous_damping, 0.1);
  EXPECT_FALSE(deck.contact.attraction);
  EXPECT_FALSE(deck.contact.restitution_correction);
  EXPECT_EQ(deck.contact.tangential_damping, TangentialDamping::none);
  deck = contact("model hooke tangential history", "fix c all property/global characteristicVelocity scalar 2\n");
  EXPECT_EQ(deck.contact.normal_law, NormalLaw::hooke);
  EXPECT_EQ(deck.contact.hooke_characteristic_velocity, 2.0);
  EXPECT_EQ(deck.contact.tangential_damping, TangentialDamping::normal);
  EXPECT_EQ(deck.pairs[0].hooke_tangential_ratio, 1.0);
  deck = contact("model hertz tangential off");
  EXPECT_EQ(deck.pairs[0].sliding_friction, 0.0);
}

TEST(ImportDeck, TranslatesStiffnesses) {
  std::string script = with("model hertz tangential history\n", "model hooke/stiffness tangential history\n");
  script.replace(script.find("model hertz"), 11, "model hooke/stiffness");
  for (const std::string pair : {"kn 1 4000", "kt 1 1000", "gamman 1 600", "gammat 1 300"}) {
    const std::size_t blank = pair.find(' ');
    script.insert(script.find("pair_style"), "fix s" + pair.substr(0, blank) + " all property/global " +
                                                 pair.substr(0, blank) + " peratomtypepair" + pair.substr(blank) +
                                                 "\n");
  }
  const Deck deck = import_text(script).deck;
  EXPECT_EQ(deck.pairs[0].hooke_stiffness, 4000.0);
  EXPECT_EQ(deck.pairs[0].hooke_tangential_ratio, 0.25);
  EXPECT_EQ(deck.pairs[0].hooke_damping_rate, 600.0);
  EXPECT_EQ(deck.pairs[0].hooke_tangential_damping_rate, 300.0);
}

TEST(ImportDeck, GivesWallsThatDoNotCohereAMaterialOfTheirOwn) {
  std::string script = with("pair_style gran model hertz tangential history",
                            "pair_style gran model hertz tangential history cohesion sjkr");
  script.insert(0, "fix c all property/global cohesionEnergyDensity peratomtypepair 1 3e5\n");
  const Deck deck = import_text(script).deck;
  ASSERT_EQ(deck.pairs.size(), 2U);
  EXPECT_EQ(deck.contact.cohesion, Cohesion::sjkr);
  EXPECT_EQ(deck.pairs[0].cohesion_energy_density, 3e5);
  EXPECT_EQ(deck.pairs[1].materials[1], "type1_wall");
  EXPECT_EQ(deck.pairs[1].cohesion_energy_density, 0.0);
  EXPECT_EQ(wall(deck, "floor").material, "type1_wall");
}

TEST(ImportDeck, PlacesMeshesAsTheScriptDoes) {
  // Moved, scaled and turned twice in this order, its corners must come to lie where the same steps by hand take them.
  const auto [deck, imported] =
      import_text(before_run("fix cad all mesh/surface file parts/face.stl type 1 move 1 2 3 scale 0.01 rotate axis 1 "
                             "0 0 angle 90 rotate axis 0 0 1 angle 90\n"
                             "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"));
  const WallDeck& mesh = wall(deck, "cad");
  EXPECT_EQ(mesh.file, "face.stl");
  ASSERT_EQ(imported.files.size(), 1U);
  EXPECT_EQ(imported.files[0].second, test::triangle_stl);
  const double angle = mesh.rotate_angle * std::numbers::pi / 180.0;
  const Vec3 axis = (1.0 / norm(mesh.rotate_axis)) * mesh.rotate_axis;
  for (const Vec3& x : {Vec3{0.0, 0.0, 1.0}, Vec3{1.0, 0.0, 1.0}, Vec3{0.0, 1.0, 1.0}}) {
    const Vec3 moved = 0.01 * (x + Vec3{1.0, 2.0, 3.0});
    const Vec3 about_x = {moved.x, -moved.z, moved.y};
    const Vec3 expected = {-about_x.y, about_x.x, about_x.z};
    const Vec3 turned =
        std::cos(angle) * x + std::sin(angle) * cross(axis, x) + ((1.0 - std::cos(angle)) * dot(axis, x)) * axis;
    EXPECT_LT(norm(mesh.scale * turned + mesh.translate - expected), 1e-15);
  }
}

TEST(ImportDeck, MovesMeshesInTheirRuns) {
  const Deck deck =
      import_text(test::falling +
                  "fix cad all mesh/surface file face.stl type 1 surface_vel 0 1 0\n"
                  "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\nrun 10\n"
                  "fix m1 all move/mesh mesh cad linear 0 0 0.1\nrun 20\nunfix m1\n"
                  "fix m2 all move/mesh mesh cad rotate origin 0 0 1 axis 0 1 0 period 0.5\nrun 30\nunfix w\nrun 40\n")
          .deck;
  const WallDeck& mesh = wall(deck, "cad");
  EXPECT_FALSE(mesh.present);
  ASSERT_EQ(mesh.motions.size(), 3U);
  EXPECT_EQ(mesh.motions[0].type, MotionType::conveyor);
  EXPECT_EQ(mesh.motions[1].velocity, (Vec3{0.0, 0.0, 0.1}));
  EXPECT_EQ(mesh.motions[1].phases, std::vector<std::string>{"run_3"});
  EXPECT_DOUBLE_EQ(mesh.motions[2].angular_velocity, 4.0 * std::numbers::pi);
  EXPECT_EQ(mesh.motions[2].phases, (std::vector<std::string>{"run_4", "run_5"}));
  ASSERT_EQ(deck.phases.size(), 5U);
  EXPECT_EQ(deck.phases[1].add_walls, std::vector<std::string>{"cad"});
  EXPECT_EQ(deck.phases[4].remove_walls, std::vector<std::string>{"cad"});
}

/// A mesh that is a wall, in a script before its run.
std::string with_mesh(const std::string& moves, const std::string& later = "") {
  return before_run(
             "fix cad all mesh/surface file face.stl type 1\n"
             "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n" +
             moves) +
         later;
}

TEST(ImportDeck, PutsMotionsThatBeginTogetherWithinTheFirst) {
  const auto [deck, imported] =
      import_text(with_mesh("fix m1 all move/mesh mesh cad linear 0.1 0 0\n"
                            "fix m2 all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 1 period 1\n"));
  EXPECT_TRUE(imported.missing.empty());
  // After a quarter of a turn the centre is where the translation has taken it, doc/fix_move_mesh.txt.
  constexpr double dt = 1e-3;
  Motions motions(wall(deck, "cad").motions);
  motions.begin_phase("run_1");
  for (int step = 0; step < 250; ++step) motions.step();
  EXPECT_LT(norm(motions.placement(dt).place({}) - Vec3{0.025, 0.0, 0.0}), 1e-12);
  EXPECT_LT(norm(motions.placement(dt).place({1.0, 0.0, 0.0}) - Vec3{0.025, 1.0, 0.0}), 1e-12);
}

TEST(ImportDeck, ListsMotionsThatNoDeckPutsTogetherSo) {
  const auto missing = [](const std::string& moves, const std::string& later = "") {
    return import_text(with_mesh(moves, later)).imported.missing;
  };
  const std::string turn = "fix m1 all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 1 period 1\n";
  const std::string move = "fix m2 all move/mesh mesh cad ";
  ASSERT_EQ(missing(turn + move + "linear 0.1 0 0\n").size(), 1U);
  EXPECT_EQ(text(missing(turn + move + "linear 0.1 0 0\n")[0]),
            "in.x:23: fix m2 move/mesh: LIGGGHTS puts it and fix m1 together as a deck cannot say");
  EXPECT_EQ(missing(turn + move + "wiggle amplitude 0 0.01 0 period 1\n").size(), 1U);
  EXPECT_EQ(missing(turn + move + "rotate origin 0 0 0 axis 1 0 0 period 1\n").size(), 1U);
  EXPECT_EQ(missing(turn, move + "rotate origin 0.1 0 0 axis 0 0 1 period 1\nrun 10\n").size(), 1U);
  for (const std::string alike :
       {"linear 0 0 0.1\n", "wiggle amplitude 0 0 0.01 period 1\n", "rotate origin 0.1 0 0 axis 0 0 1 period 1\n"}) {
    EXPECT_TRUE(missing(turn + move + alike).empty()) << alike;
  }
  EXPECT_TRUE(missing(turn, move + "linear 0 0 0.1\nrun 10\n").empty());
  EXPECT_TRUE(missing(turn, "unfix m1\n" + move + "linear 0.1 0 0\nrun 10\n").empty());
}

TEST(ImportDeck, ExpectsTheSpeedOfWallsThatTurn) {
  // 62.8 rad/s, 0.1 sqrt 2 m from the axis at the farthest corner of the box, rounded up to two digits.
  const Deck deck =
      import_text(with_mesh("fix m all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 1 period 0.1\n")).deck;
  EXPECT_NEAR(deck.time.expected_speed, 8.9, 1e-9);
}

TEST(ImportDeck, PlacesCylindersAsLiggghtsDoes) {
  const auto axis = [](const std::string& shape) {
    return wall(import_text(with("zplane 0", shape)).deck, "floor").axis_origin;
  };
  EXPECT_EQ(axis("xcylinder 0.05 0.01 0.02"), (Vec3{0.0, 0.01, 0.02}));
  EXPECT_EQ(axis("ycylinder 0.05 0.1 0.02"), (Vec3{0.02, 0.0, 0.1}));  // Cylinder<1>: z, then x
  EXPECT_EQ(axis("zcylinder 0.05 0.01 0.02"), (Vec3{0.01, 0.02, 0.0}));
}

TEST(ImportDeck, ShearsPrimitives) {
  const auto shear = [](const std::string& shape) {
    return wall(import_text(with("zplane 0", shape)).deck, "floor").motions.at(0);
  };
  EXPECT_EQ(shear("zplane 0 shear x 2").velocity, (Vec3{2.0, 0.0, 0.0}));
  EXPECT_EQ(shear("zcylinder 0.05 0 0 shear z 2").type, MotionType::conveyor);
  const MotionDeck spin = shear("zcylinder 0.05 0.01 0.02 shear x 2");
  EXPECT_EQ(spin.type, MotionType::rotation);
  EXPECT_EQ(spin.axis_origin, (Vec3{0.01, 0.02, 0.0}));
  EXPECT_EQ(spin.axis_direction, (Vec3{0.0, 0.0, 1.0}));
  EXPECT_EQ(spin.angular_velocity, 2.0);
  EXPECT_EQ(error_of(with("zplane 0", "ycylinder 0.05 0 0 shear x 2")),
            "in.x:13: a ycylinder does not spin in LIGGGHTS 3.8: its shear mixes x and z");
  EXPECT_EQ(error_of(before_run("fix cad all mesh/surface file face.stl type 1\n"
                                "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad shear x "
                                "1\n")),
            "in.x:21: shear is that of a primitive; a mesh has surface_vel");
}

TEST(ImportDeck, JoinsRunsBetweenWhichNothingChanges) {
  const Deck deck = import_text(test::falling + "run 1 pre no\nrun 2000 upto\nunfix ins\nrun 5\n").deck;
  ASSERT_EQ(deck.phases.size(), 2U);
  EXPECT_EQ(deck.phases[0].steps, 2000);
  EXPECT_EQ(deck.phases[1].steps, 5);
}

TEST(ImportDeck, PoursStreamsThroughTheirFace) {
  std::string script = with("insert/pack seed 10037 distributiontemplate d insert_every once &\n",
                            "insert/stream seed 10037 distributiontemplate d nparticles 400 particlerate 5000 &\n");
  script.replace(script.find("region fill particles_in_region 50"), 34, "insertion_face face extrude_length 0.05");
  script.insert(0, "fix face all mesh/surface file face.stl type 1 scale 0.1 move 0 0 0.1\n");
  const Deck deck = import_text(script + "unfix ins\nrun 2000\n").deck;
  ASSERT_EQ(deck.particles.size(), 1U);
  EXPECT_EQ(deck.particles[0].type, ParticlesType::pour);
  EXPECT_EQ(deck.particles[0].face, "face");
  EXPECT_EQ(deck.particles[0].particle_rate, 5000.0);
  EXPECT_DOUBLE_EQ(deck.particles[0].interval, 80e-5);  // a twentieth of the way of 8 mm at 0.5 m/s
  EXPECT_EQ(deck.particles[0].count, 50);               // what comes until the unfix
  EXPECT_FALSE(wall(deck, "face").present);
}

TEST(ImportDeck, FillsAgainAsOftenAsTheRegionEmpties) {
  // At 1.5 m/s 0.1 m are behind a grain after 0.1 s: the region is empty when the next 50 come.
  const std::string script = with("insert_every once", "insert_every 10000");
  const std::string fast = [&] {
    std::string text = script;
    return text.replace(text.find("vel constant 0 0 -0.5"), 21, "vel constant 0 0 -1.5");
  }();
  const auto [deck, imported] = import_text(fast + "run 30001 upto\n");
  ASSERT_EQ(imported.missing.size(), 1U);
  EXPECT_EQ(
      imported.missing[0].reason,
      "each 10000 steps LIGGGHTS fills the region up again; here it is taken as empty by then, and 200 grains come "
      "in all");
  ASSERT_EQ(deck.particles.size(), 2U);
  EXPECT_EQ(deck.particles[0].count, 50);
  EXPECT_EQ(deck.particles[1].count, 150);
  EXPECT_DOUBLE_EQ(deck.particles[1].interval, 0.1);
  EXPECT_NEAR(deck.particles[1].particle_rate, 500.0, 1e-3);
  // At rest it would still be full: what LIGGGHTS then adds has no counterpart.
  std::string slow = script;
  slow.replace(slow.find("gravity 9.81"), 12, "gravity 0");
  EXPECT_EQ(import_text(slow + "run 30001 upto\n").imported.missing.size(), 1U);
  // Nor does a region empty that stands on the floor, on a wall within it or in a drum.
  for (const std::string wall : {"zplane 0.05", "zplane 0.043", "zplane 0.1", "ycylinder 0.1 0.15 0"}) {
    std::string held = fast;
    const auto [other, listed] = import_text(held.replace(held.find("zplane 0"), 8, wall) + "run 30001 upto\n");
    std::int64_t grains = 0;
    for (const ParticlesDeck& particles : other.particles) grains += particles.count;
    EXPECT_EQ(grains, 50) << wall;
    ASSERT_EQ(listed.missing.size(), 1U) << wall;
    EXPECT_EQ(listed.missing[0].reason,
              "each 10000 steps LIGGGHTS fills the region up again; here its 50 grains come once, as they find room");
  }
}

std::string notes_of(const ImportedDeck& imported) {
  std::string notes;
  for (const Note& note : imported.missing) notes += text(note) + "\n";
  return notes;
}

/// A further pack of the region of `falling`.
std::string second_pack(const std::string& more) {
  return "fix ins2 all insert/pack seed 10039 distributiontemplate d insert_every once vel constant 0 0 -0.5 region " +
         more + "\n";
}

TEST(ImportDeck, FillsUpToATarget) {
  const auto [deck, imported] = import_text(before_run(second_pack("fill particles_in_region 80")));
  EXPECT_EQ(notes_of(imported), "");
  ASSERT_EQ(deck.particles.size(), 2U);
  EXPECT_EQ(deck.particles[0].count, 50);
  EXPECT_EQ(deck.particles[1].count, 30);
  EXPECT_EQ(deck.particles[1].type, ParticlesType::pour);  // fills must not overlap
  EXPECT_EQ(import_text(before_run(second_pack("fill particles_in_region 50"))).deck.particles.size(), 1U);
  // 50 grains of 8 mm are 13.4 cm3, 1.34 % of the region.
  const double volume = 50.0 * std::numbers::pi / 6.0 * std::pow(0.008, 3);
  EXPECT_EQ(import_text(before_run(second_pack("fill volumefraction_region 0.05"))).deck.particles[1].count,
            std::llround(50.0 * (0.05e-3 - volume) / volume));
  const auto later =
      import_text(test::falling + "unfix ins\n" + second_pack("fill particles_in_region 80") + "run 50\n");
  EXPECT_EQ(later.deck.particles[1].count, 80);
  EXPECT_DOUBLE_EQ(later.deck.particles[1].interval, 25 * 1e-5);  // the first batch comes before the script ends
  EXPECT_EQ(notes_of(later.imported),
            "in.x:22: fix ins2 insert/pack: LIGGGHTS counts the grains of fix ins that are in its region by then, and "
            "adds what is lacking; here all 80 come\n");
}

TEST(ImportDeck, InsertsAtARateBeforeTheScriptEnds) {
  std::string script = with("insert/pack", "insert/rate/region");
  const auto replace = [&](const std::string& one, const std::string& two) { script = with(script, one, two); };
  replace("insert_every once", "nparticles 40 particlerate 1e5 insert_every 1000");
  replace(" particles_in_region 50", "");
  EXPECT_DOUBLE_EQ(import_text(script).deck.particles.at(0).interval, 500 * 1e-5);
  replace("insert_every 1000", "insert_every 100");
  EXPECT_DOUBLE_EQ(import_text(script).deck.particles.at(0).interval, 100 * 1e-5);
}

TEST(ImportDeck, CountsTheGrainsOfListsInTheRegion) {
  const std::string single = "create_atoms 1 single 0 0 0.1\nset atom 1 diameter 0.008 density 2000\n";
  std::string script = test::falling;
  const auto [deck, imported] = import_text(script.insert(script.find("fix ins"), single));
  EXPECT_EQ(notes_of(imported), "");
  ASSERT_EQ(deck.particles.size(), 2U);
  EXPECT_EQ(deck.particles[1].count, 49);
}

TEST(ImportDeck, ListsRegionsThatAreTooFull) {
  // 1500 grains of 8 mm are 40.2 % of 1 l.
  const auto [deck, imported] =
      import_text(with("region fill particles_in_region 50", "region fill all_in yes particles_in_region 1500"));
  EXPECT_EQ(deck.particles.at(0).type, ParticlesType::pour);
  EXPECT_EQ(notes_of(imported),
            "in.x:17: fix ins insert/pack: the region would be 40 % full: LIGGGHTS inserts as many grains as find a "
            "place; here all 1500 come, as they find room\n");
}

TEST(ImportDeck, EnlargesRegionsInWhichCentresLie) {
  const auto region = [](const std::string& shape, const std::string& wall = "zplane 0", const std::string& more = "") {
    std::string script = with("block -0.05 0.05 -0.05 0.05 0.05 0.15", shape);
    script.replace(script.find("zplane 0"), 8, wall);
    script.replace(script.find("region fill part"), 11, more + "region fill");
    const auto [deck, imported] = import_text(script);
    EXPECT_EQ(notes_of(imported), "");
    return deck.particles.at(0);
  };
  const std::string block = "block -0.05 0.05 -0.1 0.05 0.05 0.15";
  ParticlesDeck grown = region(block);
  EXPECT_EQ(grown.min, (Vec3{-0.05 - 0.004, -0.1, 0.05 - 0.004}));
  EXPECT_EQ(grown.max, (Vec3{0.05 + 0.004, 0.05 + 0.004, 0.15 + 0.004}));
  EXPECT_EQ(region(block, "zplane 0.05").min.z, 0.05);
  EXPECT_EQ(region(block, "zplane 0.048").min.z, 0.048);
  EXPECT_EQ(region(block, "zplane 0", "all_in yes ").min.z, 0.05);
  const std::string cylinder = "cylinder z 0 0 0.04 0.05 0.15";
  grown = region(cylinder);
  EXPECT_EQ(grown.radius, 0.044);
  EXPECT_EQ(grown.centre.z, 0.05 - 0.004);
  EXPECT_DOUBLE_EQ(grown.height, 0.108);
  EXPECT_DOUBLE_EQ(region(cylinder, "zcylinder 0.041 0 0").radius, 0.041);
}

TEST(ImportDeck, ListsRegionsThatAMeshMayEnd) {
  const auto imported = [](const std::string& fill) {
    return import_text(with("region fill block -0.05 0.05 -0.05 0.05 0.05 0.15",
                            "fix cad all mesh/surface file face.stl type 1\n"
                            "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"
                            "region fill block " +
                                fill));
  };
  const Imported narrow = imported("-0.05 0.05 -0.03 0.03 0.05 0.15");
  EXPECT_EQ(narrow.deck.particles.at(0).min.z, 0.05);
  EXPECT_EQ(notes_of(narrow.imported),
            "in.x:19: fix ins insert/pack: without all_in yes LIGGGHTS places centres up to the bounds of the region; "
            "here whole grains are in it\n");
  EXPECT_EQ(notes_of(imported("-0.05 0.05 -0.05 0.05 0.05 0.15").imported), "");
}

TEST(ImportDeck, DividesADistributionByMaterials) {
  const std::string script =
      with("fix d all particledistribution/discrete 10009 1 t 1.0\n",
           "fix t2 all particletemplate/sphere 10061 atom_type 1 density constant 4000 radius constant 0.002\n"
           "fix d all particledistribution/discrete 10009 2 t 0.5 t2 0.5\n");
  const Deck deck = import_text(script).deck;
  ASSERT_EQ(deck.particles.size(), 2U);
  EXPECT_EQ(deck.particles[1].material, "type1_2");
  // Equal masses: 8 times smaller and twice as dense are 4 to 1 by number.
  EXPECT_EQ(deck.particles[0].count, 10);
  EXPECT_EQ(deck.particles[1].count, 40);
}

TEST(ImportDeck, RefusesAPairThatIsNoPairTheOtherWayRound) {
  std::string script = with("create_box 1", "create_box 2");
  const auto replace = [&](const std::string& one, const std::string& two) { script = with(script, one, two); };
  replace("youngsModulus peratomtype 5e6", "youngsModulus peratomtype 5e6 5e6");
  replace("poissonsRatio peratomtype 0.4", "poissonsRatio peratomtype 0.4 0.4");
  replace("Restitution peratomtypepair 1 0.6", "Restitution peratomtypepair 2 0.6 0.6 0.6 0.6");
  replace("coefficientFriction peratomtypepair 1 0.3", "coefficientFriction peratomtypepair 2 0.3 0.1 0.9 0.3");
  replace("type 1 zplane", "type 2 zplane");
  EXPECT_EQ(error_of(script),
            "in.x:9: coefficientFriction of types 1 and 2 is 0.1, of 2 and 1 it is 0.9: the matrix must be symmetric");
}

TEST(ImportDeck, KeepsWhatTheFirstRunHasAndListsTheRest) {
  const auto [deck, imported] =
      import_text(test::falling +
                  "fix m4 all property/global coefficientFriction peratomtypepair 1 0.9\n"
                  "pair_style gran model hertz tangential off\nfix g all gravity 1 vector 0 0 -1\ntimestep 1e-6\n"
                  "run 5 every 1 \"print x\"\n");
  EXPECT_EQ(deck.pairs[0].sliding_friction, 0.3);
  EXPECT_EQ(deck.gravity.z, -9.81);
  EXPECT_EQ(deck.time.step, 1e-5);
  EXPECT_EQ(deck.phases[0].steps, 1005);
  ASSERT_EQ(imported.missing.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(imported.missing[k].place.line, 21 + k);
}

TEST(ImportDeck, AddsUpGravity) {
  EXPECT_EQ(import_text(before_run("fix g2 all gravity 5 vector 1 0 0\n")).deck.gravity, (Vec3{5.0, 0.0, -9.81}));
  EXPECT_EQ(import_text(before_run("fix g all gravity 5 vector 1 0 0\n")).deck.gravity, (Vec3{5.0, 0.0, 0.0}));
  const auto [deck, imported] = import_text(before_run("fix g2 all gravity 5 vector 1 0 0\nunfix g2\n"));
  EXPECT_EQ(deck.gravity, (Vec3{0.0, 0.0, -9.81}));
  EXPECT_TRUE(imported.missing.empty());
  EXPECT_EQ(notes_of(import_text(test::falling + "unfix g\nrun 5\n").imported),
            "in.x:21: unfix g: gravity lasts for the whole run\n");
}

TEST(ImportDeck, CountsStepsAsLiggghtsDoes) {
  EXPECT_EQ(import_text(with("run 1000", "run 1555.9")).deck.phases[0].steps, 1555);
  const std::string reset = test::falling + "reset_timestep 5000\nunfix ins\n";
  EXPECT_EQ(import_text(reset + "run 6000 upto\n").deck.phases.at(1).steps, 1000);
  const auto [deck, imported] =
      import_text(reset + second_pack("fill start 5500 particles_in_region 5") + "run 6000 upto\n");
  EXPECT_DOUBLE_EQ(deck.particles.at(1).start_time, 1500e-5);
}

TEST(ImportDeck, PassesOverWhatOnlyWrites) {
  const auto [deck, imported] = import_text(
      before_run("shell mkdir post\nthermo_log t.txt\nfix h all ave/histo 10 1 10 -1 1 20 vx mode vector file h.txt\n"
                 "fix st all store/state 0 x y z\nfix sf all store/force\nfix sp all ave/spatial 10 1 10 z lower 0.1 "
                 "vx file p\n"));
  EXPECT_EQ(notes_of(imported), "");
  EXPECT_EQ(error_of(before_run("shell cd post\n")), "in.x:20: shell cd: nothing in a script is executed");
}

TEST(ImportDeck, TakesTheIntervalOfSnapshotsFromDumpsOfGrainsAlone) {
  const std::string contacts =
      "compute fc all pair/gran/local pos id force\ncompute fw all wall/gran/local id force\n"
      "compute cn all coord/gran\ndump d1 all local 50 f.txt c_fc[1] c_fc[2]\n";
  const std::string others = "dump d2 all mesh/vtk 20 m.vtk stress\ndump d3 all euler/vtk 30 e.vtk\n";
  const auto [deck, imported] =
      import_text(before_run(contacts + others + "dump d4 all custom/vtk 100 p.vtk id x y z\ndump d5 all xyz 10 x\n"));
  EXPECT_DOUBLE_EQ(deck.output.snapshot_interval, 100 * 1e-5);
  EXPECT_TRUE(deck.output.contacts);
  EXPECT_TRUE(deck.output.walls);
  EXPECT_EQ(notes_of(imported), "");
  const std::string written =
      "contacts are written with their forces beside each snapshot with output.contacts = true\n";
  for (const std::string& line : std::vector<std::string>{
           "contacts = true  # dump local; beside each snapshot\n", "walls = true  # dump mesh; beside each snapshot\n",
           "in.x:20: compute fc all pair/gran/local pos id force: " + written,
           "in.x:21: compute fw all wall/gran/local id force: " + written,
           "in.x:22: compute cn all coord/gran: contacts are counted in series.csv, not for each grain\n",
           "in.x:23: dump d1 all local 50 f.txt c_fc[1] c_fc[2]: " + written,
           "in.x:24: dump d2 all mesh/vtk 20 m.vtk stress: the walls are written beside each snapshot with "
           "output.walls = true; forces are in walls.csv, for each wall, not for each triangle\n",
           "in.x:27: dump d5 all xyz 10 x: snapshots have all of the grains, as often as the first dump says\n"}) {
    EXPECT_NE(imported.deck.find(line), std::string::npos) << line << "\n" << imported.deck;
  }
}

TEST(ImportDeck, WritesContactsAndWallsWhereADumpDoes) {
  const auto output = [](const std::string& lines) { return import_text(before_run(lines)).deck.output; };
  EXPECT_EQ(output("dump d all mesh/stl 20 m.stl\n").snapshot_interval, 0.0);
  EXPECT_TRUE(output("dump d all mesh/stl 20 m.stl\n").walls);
  const std::string of_walls = "compute fw all wall/gran/local force\n";
  EXPECT_TRUE(output(of_walls + "dump d all local/gran/vtk 20 f.vtk fw\n").contacts);
  EXPECT_FALSE(output(of_walls).contacts);
  EXPECT_FALSE(output(of_walls + "dump d all local 20 f.txt index c_other[1]\n").contacts);
  EXPECT_FALSE(output("dump d all custom 20 p.txt id c_fw\n").walls);
}

TEST(ImportDeck, NamesTheLineOfAMeshThatIsNotThere) {
  try {
    import_text(
        before_run("fix cad all mesh/surface file none.stl type 1\n"
                   "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"));
    ADD_FAILURE() << "no error";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()), "in.x:20: fix cad: none.stl: cannot open");
  }
}

TEST(ImportDeck, ListsMeshesWhoseSurfaceTurns) {
  const auto [deck, imported] = import_text(
      before_run("fix cad all mesh/surface file face.stl type 1 surface_ang_vel origin 0 0 0 axis 0 0 1 omega 10\n"
                 "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"));
  ASSERT_EQ(imported.missing.size(), 1U);
  EXPECT_EQ(imported.missing[0].reason, "LIGGGHTS gives the surface a velocity and leaves the mesh; here it turns");
}

TEST(ImportDeck, ReplacesAFixByOneOfTheSameName) {
  const Deck deck =
      import_text(test::falling +
                  "fix floor all wall/gran model hertz tangential history primitive type 1 zplane -0.1\nrun 5\n")
          .deck;
  ASSERT_EQ(deck.walls.size(), 2U);
  EXPECT_EQ(deck.phases[1].remove_walls, std::vector<std::string>{"floor"});
  EXPECT_EQ(deck.phases[1].add_walls, std::vector<std::string>{"floor_2"});
  EXPECT_EQ(error_of(before_run("region fill block 0 1 0 1 0 1 units box\n")),
            "in.x:20: \"fill\" is in use above and would become another; give this one another name");
  EXPECT_EQ(import_text(before_run("region fill delete\n")).deck.particles.size(), 1U);
}

TEST(ImportDeck, ListsWhatNothingUses) {
  const std::string deck = import_text(before_run("fix k all property/global k_finnie peratomtypepair 1 1.0\n"
                                                  "fix cad all mesh/surface file face.stl type 1\n"))
                               .imported.deck;
  EXPECT_NE(deck.find("#   in.x:20: fix property/global k_finnie: the contact model does not use it\n"),
            std::string::npos)
      << deck;
  EXPECT_NE(deck.find("#   in.x:21: fix cad mesh/surface: neither a wall nor an insertion face\n"), std::string::npos)
      << deck;
  EXPECT_EQ(deck.find("face.stl\""), std::string::npos);
}

TEST(ImportDeck, ListsWhatHasNoCounterpart) {
  const auto missing =
      import_text(before_run("fix drag all viscous 0.1\nfix w all adapt 1 atom diameter v_d\n")).imported.missing;
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].command, "fix drag all viscous 0.1");
  EXPECT_EQ(missing[0].place.line, 20U);
  EXPECT_EQ(missing[0].reason, "there is no drag");
  EXPECT_EQ(missing[1].reason, "only diameters that grow by a factor have a counterpart");
}

TEST(ImportDeck, ComparesTheGroupsOfFixesWithThoseOfInsertedGrains) {
  const auto missing = [](const std::string& old, const std::string& fresh) {
    std::string script = with(old, fresh);
    return import_text(script.insert(script.find("fix ins"), "group some region fill\n")).imported.missing;
  };
  const auto one = [&](const std::string& old, const std::string& fresh) {
    const auto notes = missing(old, fresh);
    return notes.size() == 1 ? text(notes[0]) : std::to_string(notes.size()) + " notes";
  };
  EXPECT_EQ(one("fix g all gravity", "group some empty\nfix g some gravity"),
            "in.x:13: fix g some gravity 9.81 vector 0 0 -1: it acts on group some there, here on all grains");
  EXPECT_EQ(one("fix move all", "fix move some"),
            "in.x:18: fix ins: no fix nve/sphere has its grains in its group; here they move");
  EXPECT_TRUE(missing("fix ins all", "fix ins some").empty());
  std::string same = with("fix ins all", "group some region fill\nfix ins some");
  EXPECT_TRUE(import_text(same.replace(same.find("fix move all"), 12, "fix move some")).imported.missing.empty());
  EXPECT_EQ(error_of(with("fix g all", "fix g none")), "in.x:12: no group \"none\" is defined above; there are: all");
}

TEST(ImportDeck, DoesNotPassOverCommandsThatChangeTheSimulation) {
  const auto missing = import_text(before_run("neigh_modify delay 0 exclude type 1 1\n")).imported.missing;
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].reason, "all grains touch one another");
  EXPECT_TRUE(import_text(before_run("neigh_modify delay 0 exclude none\ndimension 3\n")).imported.missing.empty());
  EXPECT_EQ(error_of(before_run("dimension 2\n")), "in.x:20: grains are spheres in three dimensions");
  EXPECT_EQ(error_of(test::falling + "clear\n"),
            "in.x:21: a deck is one simulation; make a script of its own of what comes after clear");
  const Deck deck = import_text(before_run("clear\n" + test::falling)).deck;  // its last run is that of `falling`
  EXPECT_EQ(deck.walls.size(), 1U);
}

TEST(ImportDeck, GrainsThatGrow) {
  const std::string grows =
      "variable rate equal 1.5^(2/(3.*10))\ncompute rad all property/atom radius\n"
      "variable d atom ${rate}*2.*c_rad\nfix grow all adapt 2 atom diameter v_d\n";
  const auto result = import_text(test::falling + grows + "run 10\nunfix grow\nrun 20\n");
  EXPECT_TRUE(result.imported.missing.empty());
  ASSERT_EQ(result.deck.phases.size(), 3U);
  EXPECT_FALSE(result.deck.phases[0].growth.enabled);
  EXPECT_TRUE(result.deck.phases[1].growth.enabled);
  EXPECT_NEAR(result.deck.phases[1].growth.factor, std::pow(1.5, 1.0 / 15.0), 1e-14);  // of 15 digits
  EXPECT_EQ(result.deck.phases[1].growth.every, 2);
  EXPECT_FALSE(result.deck.phases[2].growth.enabled);
  const auto reason = [](const std::string& formula) {
    const auto noted = import_text(before_run("compute rad all property/atom radius\nvariable d atom " + formula +
                                              "\nfix grow all adapt 2 atom diameter v_d\n"));
    return noted.imported.missing.size() == 1 ? noted.imported.missing[0].reason : "no note";
  };
  for (const char* formula : {"0.9*2*c_rad", "2.*c_rad+0.001", "2.1*c_other", "vx"})
    EXPECT_EQ(reason(formula), "only diameters that grow by a factor have a counterpart") << formula;
}

const std::string carries_heat =
    "fix k all property/global thermalConductivity peratomtype 100.\n"
    "fix c all property/global thermalCapacity peratomtype 10.\n"
    "fix heat all heat/gran initial_temperature 300.\n";

TEST(ImportDeck, HeatOfGrainsAndWalls) {
  std::string script = with("zplane 0", "zplane 0 temperature 350");
  script.insert(script.find("run 1000"), carries_heat);
  const auto [deck, imported] = import_text(
      script + "region half block 0 INF INF INF INF INF units box\nset region half property/atom Temp 800.\nrun 50\n" +
      "set region half property/atom heatSource 1.5\nset group all property/atom heatSource -2\nrun 50\nunfix ins\n"
      "run 50\n");
  EXPECT_TRUE(imported.missing.empty());
  EXPECT_EQ(deck.materials[0].conductivity, 100.0);
  EXPECT_EQ(deck.materials[0].specific_heat, 10.0);
  EXPECT_EQ(deck.heat.temperature, 300.0);
  EXPECT_EQ(deck.heat.every, 1);
  EXPECT_EQ(deck.heat.conductance, ContactConductance::intersection);
  EXPECT_TRUE(wall(deck, "floor").heat.enabled);
  EXPECT_EQ(wall(deck, "floor").heat.temperature, 350.0);
  ASSERT_EQ(deck.phases.size(), 4U);
  EXPECT_TRUE(deck.phases[0].heat.empty());
  ASSERT_EQ(deck.phases[1].heat.size(), 1U);
  EXPECT_EQ(deck.phases[1].heat[0].temperature, 800.0);
  EXPECT_EQ(deck.phases[1].heat[0].min, (Vec3{0.0, -0.1, 0.0}));
  EXPECT_EQ(deck.phases[1].heat[0].max, deck.domain.max);
  for (const std::size_t later : {2U, 3U}) {
    ASSERT_EQ(deck.phases[later].heat.size(), 2U);
    EXPECT_EQ(deck.phases[later].heat[0].power, 1.5);
    EXPECT_EQ(deck.phases[later].heat[1].power, -2.0);
  }
}

TEST(ImportDeck, HeatOfSoftenedGrainsAndInOtherUnits) {
  std::string script = before_run(carries_heat + "fix o all property/global youngsModulusOriginal peratomtype 5e8\n");
  script.replace(script.find("temperature 300."), 16, "temperature 300. area_correction yes");
  EXPECT_DOUBLE_EQ(import_text(script).deck.materials[0].stiffness_ratio, 0.01);
  script.replace(script.find("units si"), 8, "units cgs");
  const Deck cgs = import_text(script).deck;
  EXPECT_DOUBLE_EQ(cgs.materials[0].conductivity, 1e-3);
  EXPECT_DOUBLE_EQ(cgs.materials[0].specific_heat, 1e-3);
}

TEST(ImportDeck, HeatThatIsNotLikeThat) {
  const auto reason = [](const std::string& more) {
    const auto noted = import_text(before_run(carries_heat + more)).imported.missing;
    return noted.size() == 1 ? noted[0].reason : "no note";
  };
  EXPECT_EQ(reason("set group all property/atom charge 1\n"), "grains have no charge");
  EXPECT_EQ(reason("set type 1 property/atom Temp 1\n"), "the heat of grains is set by region, or of all");
  EXPECT_EQ(reason("region c cylinder z 0 0 0.1 0 1\nset region c property/atom Temp 1\n"),
            "the heat of grains is set in blocks alone");
  EXPECT_EQ(reason("unfix heat\n"), "heat/gran lasts for the whole run");
  EXPECT_EQ(reason("fix h2 all heat/gran/radiation initial_temperature 3\n"),
            "of fix heat/gran conduction alone has a counterpart");
  EXPECT_EQ(error_of(before_run("fix heat all heat/gran initial_temperature 300.\n")),
            "in.x:20: fix heat/gran needs fix property/global thermalCapacity, which is not there");
  EXPECT_EQ(error_of(before_run(carries_heat + "set region none property/atom Temp 1\n")),
            "in.x:23: no region \"none\" is defined above; there are: box, fill");
}

TEST(ImportDeck, RefusesWithTheLineAndTheReason) {
  EXPECT_EQ(error_of("units lj\n"), "in.x:1: units lj: only si and cgs are known");
  EXPECT_EQ(error_of("atom_style bond\n"),
            "in.x:1: atom_style bond: only grains that are spheres (granular, sphere) have a counterpart");
  EXPECT_EQ(error_of("run 5\n"), "in.x:1: a run before any timestep");
  EXPECT_EQ(error_of("timestep 1e-5\n"),
            "in.x:1: the script ends, and no create_box or read_data has said what is simulated");
  EXPECT_EQ(error_of(with("peratomtype 5e6", "peratomtype five")),
            "in.x:6: \"five\" where a number is expected (youngsModulus)");
  EXPECT_EQ(error_of(with("peratomtype 5e6", "peratomtype 5e6 6e6")), "in.x:6: 2 values of youngsModulus for 1 types");
  EXPECT_EQ(error_of(with("coefficientFriction", "coefficientFrictio")),
            "in.x:10: the model needs fix property/global coefficientFriction, which is not there");
  EXPECT_EQ(error_of(with("model hertz tangential history\n", "model luding tangential history\n")),
            "in.x:10: normal model \"luding\" has no counterpart; known are hertz, hooke, hooke/stiffness");
  EXPECT_EQ(error_of(with("zplane 0", "zcone 0")),
            "in.x:13: a wall that is a \"zcone\"; planes and cylinders across x, y and z are known");
  EXPECT_EQ(error_of(with("region fill particles", "region full particles")),
            "in.x:17: no region \"full\" is defined above; there are: box, fill");
  EXPECT_EQ(error_of(with("peratomtype 0.4", "peratomtype 0.5")),
            "in.x:7: as a deck it is refused: x.toml:16:17: \"poisson_ratio\" = 0.5 is out of range; it must be 0 <= x "
            "< 0.5");
  EXPECT_EQ(error_of(before_run("read_restart old\n")),
            "in.x:20: read_restart: binary restart files are read by the program that wrote them alone; give a dump "
            "(--dump)");
}

TEST(ImportDeck, SaysWhatIsToBeWrittenByHand) {
  EXPECT_EQ(
      error_of(before_run("fix cad all mesh/surface/stress/servo file face.stl type 1 com 0 0 0 ctrlPV force axis "
                          "0 0 -1 target_val 5 vel_max 1 kp 5\n")),
      "in.x:20: fix mesh/surface/stress/servo: write the mesh as a [[wall]] with [wall.servo] by hand "
      "(docs/user-guide.md#wall)");
  EXPECT_EQ(error_of(before_run("fix cad all mesh/surface/stress/6dof file face.stl type 1\n")),
            "in.x:20: fix mesh/surface/stress/6dof: a mesh that the grains move has no counterpart");
  EXPECT_EQ(
      error_of(with("radius constant 0.004", "radius uniform 0.003 0.004")),
      "in.x:14: a radius that is uniform: write [particles.sizes] by hand, or several templates of constant radius");
  EXPECT_EQ(error_of(with("density constant 2000", "density uniform 2000 2500")),
            "in.x:14: a density that is uniform: only constant ones have a counterpart");
}

TEST(ImportDeck, TakesATimeStepThatIsLongerThanUsual) {
  const auto [deck, imported] = import_text(with("timestep 1e-5", "timestep 1e-4"));
  EXPECT_EQ(deck.time.step, 1e-4);
  EXPECT_GT(deck.time.hertz_fraction + deck.time.rayleigh_fraction, 0.3);
  ASSERT_EQ(imported.warnings.size(), 1U);
  EXPECT_TRUE(imported.missing.empty());
  const std::string warning = text(imported.warnings[0]);
  EXPECT_TRUE(warning.starts_with("in.x:11: timestep: it takes 0.")) << warning;
  EXPECT_TRUE(warning.ends_with("; shares above 0.2 and 0.1 can keep beds from resting")) << warning;
  EXPECT_TRUE(import_text(test::falling).imported.warnings.empty());
}

TEST(ImportDeck, NamesTheDeck) {
  EXPECT_EQ(deck_name("a/in.chute"), "chute.toml");
  EXPECT_EQ(deck_name("chute.in"), "chute.toml");
  EXPECT_EQ(deck_name("in."), "deck.toml");
}

}  // namespace
}  // namespace repose
