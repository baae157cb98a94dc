// Grains of data files and dumps, and the commands that change them.
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "import/grain_list.h"
#include "import/import_script.h"
#include "import_samples.h"
#include "scene/insertion/particle_csv.h"

namespace repose {
namespace {

const std::string data =
    "grains\n\n3 atoms\n2 atom types\n0 2 xlo xhi\n0 2 ylo yhi\n0 2 zlo zhi\n\nAtoms # granular\n\n"
    "1 1 0.2 2500 0.5 0.5 0.5 0 0 0\n2 2 0.4 1000 1.5 0.5 0.5\n7 1 0.2 2500 0.5 1.5 0.5\n\nVelocities\n\n2 1 2 3 4 5 "
    "6\n";

const std::string dump =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id type x y z "
    "radius\n1 1 9 9 9 1\n"
    "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-1 1\n0 2\n0 1\n"
    "ITEM: ATOMS id type xs ys zs vx vy vz diameter mass \n4 1 0.5 0.5 0.5 1 2 3 0.2 0.01\n2 1 0 1 0 0 0 0 0.2 0.02\n";

TEST(ImportGrains, ReadsADataFile) {
  const GrainList list = parse_data_file(data, "data", si_units);
  ASSERT_EQ(list.grains.size(), 3U);
  EXPECT_EQ(list.types, 2);
  EXPECT_EQ(list.box->max, (Vec3{2.0, 2.0, 2.0}));
  EXPECT_EQ(list.grains[1].radius, 0.2);
  EXPECT_EQ(list.grains[1].density, 1000.0);
  EXPECT_EQ(list.grains[1].velocity, (Vec3{1.0, 2.0, 3.0}));
  EXPECT_EQ(list.grains[1].spin, (Vec3{4.0, 5.0, 6.0}));
  EXPECT_DOUBLE_EQ(parse_data_file(data, "data", cgs_units).grains[0].density, 2.5e6);
}

TEST(ImportGrains, ReadsTheLastSnapshotOfADump) {
  const GrainList list = parse_dump(dump, "dump", si_units);
  ASSERT_EQ(list.grains.size(), 2U);
  EXPECT_EQ(list.grains[0].id, 2);
  EXPECT_EQ(list.grains[0].position, (Vec3{-1.0, 2.0, 0.0}));
  EXPECT_EQ(list.grains[1].position, (Vec3{0.0, 1.0, 0.5}));
  EXPECT_EQ(list.grains[1].velocity, (Vec3{1.0, 2.0, 3.0}));
  EXPECT_NEAR(list.grains[1].density, 0.01 / (4.0 / 3.0 * std::numbers::pi * 1e-3), 1e-12);
}

TEST(ImportGrains, SaysWhereAFileIsWrong) {
  const auto error = [](const std::string& text, auto read) -> std::string {
    try {
      read(text, "f", si_units);
    } catch (const DeckError& failure) {
      return failure.what();
    }
    return "no error";
  };
  EXPECT_EQ(error("x\n\n2 atoms\n\nAtoms\n\n1 1 0.1 2500 0 0 0\n", parse_data_file),
            "f:7: 1 atoms of the 2 that the file declares");
  EXPECT_EQ(error("x\n\n1 atoms\n\nAtoms\n\n1 1 0.1 2500 0 0\n", parse_data_file),
            "f:7: the line ends before position");
  EXPECT_EQ(error("x\n\n1 atoms\n\nAtoms\n\n1 1 nan 2500 0 0 0\n", parse_data_file),
            "f:7: \"nan\" where a number is expected (diameter)");
  EXPECT_EQ(error("x\n", parse_data_file), "f:1: no data file: no line says how many atoms there are");
  EXPECT_EQ(error("x\n", parse_dump), "f:1: no dump: there are no ITEM: ATOMS with lines behind");
  EXPECT_EQ(error("ITEM: NUMBER OF ATOMS\n5\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n", parse_dump),
            "f:3: the file ends before its 5 atoms");
  EXPECT_EQ(error("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z\n1 0 0 0\n", parse_dump),
            "f:3: a dump without radius or diameter");
}

const std::string all_move = "fix i all nve/sphere\n";

/// A script with the grains of `data`, changed by some lines, and moved by some.
ImportedDeck import_data(const std::string& lines, const std::string& dump_file = "",
                         const std::string& integrator = all_move) {
  const std::string script =
      "units si\nboundary f f f\nread_data data\n"
      "fix m1 all property/global youngsModulus peratomtype 5e6 5e6\nfix m2 all property/global poissonsRatio "
      "peratomtype 0.4 0.4\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.6 0.6 0.6 0.5\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 2 0.1 0.2 0.2 0.4\n"
      "pair_style gran model hertz tangential history\ntimestep 1e-5\n"
      "region left block INF 1 INF INF INF INF units box\n" +
      lines + integrator + "run 10\n";
  const std::map<std::string, std::string> files = {{"in.x", script}, {"data", data}, {"dump", dump}};
  return import_script("in.x", test::reader_of(files), {}, dump_file);
}

NewParticles grains_of(const ImportedDeck& imported, const std::string& file) {
  const Deck deck = read_deck(imported.deck, "x.toml", {});
  for (const auto& [name, bytes] : imported.files) {
    if (name == file) return parse_particle_csv(bytes, name, deck.materials);
  }
  throw DeckError("no " + file);
}

TEST(ImportGrains, BecomeAListOfTheDeck) {
  const ImportedDeck imported = import_data("");
  EXPECT_TRUE(imported.missing.empty());
  const NewParticles grains = grains_of(imported, "grains.csv");
  ASSERT_EQ(grains.size(), 3U);
  EXPECT_EQ(grains.material, (std::vector<int>{0, 1, 0}));
  const Deck deck = read_deck(imported.deck, "x.toml", {});
  ASSERT_EQ(deck.pairs.size(), 3U);
  EXPECT_EQ(deck.pairs[1].sliding_friction, 0.2);
  EXPECT_EQ(deck.pairs[2].restitution, 0.5);
}

TEST(ImportGrains, AreSetDeletedAndFrozen) {
  const ImportedDeck imported = import_data(
      "group two type 2\nset group two diameter 0.3 density 500\nvelocity two set NULL 0 -1\n"
      "create_atoms 1 single 1.5 1.5 1.5\nset atom 8 diameter 0.2 density 2500\ngroup new id 8\nfix f new freeze\n"
      "delete_atoms region left\n");
  EXPECT_TRUE(imported.missing.empty());
  const NewParticles grains = grains_of(imported, "grains.csv");
  ASSERT_EQ(grains.size(), 1U);
  EXPECT_EQ(grains.radius[0], 0.15);
  EXPECT_EQ(grains.velocity[0], (Vec3{1.0, 0.0, -1.0}));
  const NewParticles fixed = grains_of(imported, "grains_fixed.csv");
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_EQ(fixed.position[0], (Vec3{1.5, 1.5, 1.5}));
  EXPECT_TRUE(read_deck(imported.deck, "x.toml", {}).particles[1].fixed);
}

std::string notes_of(const ImportedDeck& imported) {
  std::string notes;
  for (const Note& note : imported.missing) notes += text(note) + "\n";
  return notes;
}

TEST(ImportGrains, StandStillUnlessTheirGroupMoves) {
  const std::string mobile = "group mobile type 1\n";
  const ImportedDeck still =
      import_data("set type 2 vx 0 vy 0 vz 0 omegax 0 omegay 0 omegaz 0\n" + mobile, "", "fix i mobile nve/sphere\n");
  EXPECT_EQ(notes_of(still), "");
  EXPECT_EQ(grains_of(still, "grains.csv").material, (std::vector<int>{0, 0}));
  EXPECT_EQ(grains_of(still, "grains_fixed.csv").material, (std::vector<int>{1}));
  EXPECT_EQ(notes_of(import_data(mobile, "", "fix i mobile nve/sphere\n")),
            "in.x:12: fix i mobile nve/sphere: grains that stand still here have a velocity there\n");
  const ImportedDeck both =
      import_data(mobile + "group base subtract all mobile\nfix b base nve/sphere\n", "", "fix i mobile nve/sphere\n");
  EXPECT_EQ(notes_of(both), "");
  EXPECT_EQ(notes_of(import_data(mobile, "", "fix i mobile nve/sphere\nunfix i\n" + all_move)), "");
  EXPECT_EQ(grains_of(both, "grains.csv").size(), 3U);
  // What moves from the second run on is fixed in all.
  EXPECT_EQ(notes_of(import_data("set type 2 vx 0 vy 0 vz 0 omegax 0 omegay 0 omegaz 0\n" + mobile, "",
                                 "fix i mobile nve/sphere\nrun 10\nfix i all nve/sphere\n")),
            "in.x:15: fix i all nve/sphere: grains that stand still in the first run do so in all\n");
}

TEST(ImportGrains, KeepTheirGroupsWhenTheirTypeChanges) {
  const ImportedDeck imported = import_data("group a type 1\nset group a type 2\nfix f a freeze\n");
  EXPECT_EQ(notes_of(imported), "");
  EXPECT_EQ(grains_of(imported, "grains_fixed.csv").size(), 2U);
  EXPECT_EQ(grains_of(imported, "grains.csv").size(), 1U);
}

TEST(ImportGrains, AreInGroupsOfGroups) {
  const auto frozen = [](const std::string& group) {
    const std::string rest = "set group all vx 0 vy 0 vz 0 omegax 0 omegay 0 omegaz 0\n";
    const std::string groups = "group one type 1\ngroup low id 1:2\ngroup old id 7\ngroup new id 1\n";
    return grains_of(import_data(rest + groups + group + "fix f g freeze\n"), "grains_fixed.csv").position;
  };
  const Vec3 first{0.5, 0.5, 0.5}, second{1.5, 0.5, 0.5}, seventh{0.5, 1.5, 0.5};
  EXPECT_EQ(frozen("group g union new old\n"), (std::vector<Vec3>{first, seventh}));
  EXPECT_EQ(frozen("group g intersect one low\n"), (std::vector<Vec3>{first}));
  EXPECT_EQ(frozen("group g subtract low one\n"), (std::vector<Vec3>{second}));
  EXPECT_EQ(frozen("group g id 1 2 7\ngroup g subtract g low\n"), (std::vector<Vec3>{seventh}));
  EXPECT_EQ(frozen("group g id 1:7\ngroup g clear\ngroup g type 2:3\n"), (std::vector<Vec3>{second}));
  EXPECT_THROW(frozen("group g variable v\n"), DeckError);
}

TEST(ImportGrains, AreComparedWithTheGroupsOfFixes) {
  EXPECT_EQ(notes_of(import_data("group one type 1\nfix g one gravity 9.81 vector 0 0 -1\n"
                                 "fix w one wall/gran model hertz tangential history primitive type 1 zplane 0\n")),
            "in.x:12: fix g one gravity 9.81 vector 0 0 -1: it acts on group one there, here on all grains\n"
            "in.x:13: fix w one wall/gran model hertz tangential history primitive type 1 zplane 0: it acts on group "
            "one there, here on all grains\n");
  // Those that stand still have no weight anywhere.
  EXPECT_EQ(notes_of(import_data("set group all vx 0 vy 0 vz 0 omegax 0 omegay 0 omegaz 0\ngroup one type 1\n"
                                 "fix g one gravity 9.81 vector 0 0 -1\n",
                                 "", "fix i one nve/sphere\n")),
            "");
}

TEST(ImportGrains, ComeFromADumpInstead) {
  const ImportedDeck imported = import_data("boundary m m m\ngroup one type 1\nfix f one freeze\n", "dump");
  const NewParticles grains = grains_of(imported, "grains.csv");
  ASSERT_EQ(grains.size(), 2U);
  EXPECT_EQ(grains.position[1], (Vec3{0.0, 1.0, 0.5}));
  EXPECT_EQ(notes_of(imported),
            "in.x:3: read_data data: the grains of dump are there instead\n"
            "in.x:13: fix f one freeze: the grains of dump are there instead\n");
}

/// A script that goes on from a restart file, of two types in one of which the dump has grains.
ImportedDeck import_restart(const std::string& lines, const std::string& dump_file) {
  const std::string script =
      "units si\nboundary f f f\nread_restart old.restart\n"
      "fix m1 all property/global youngsModulus peratomtype 5e6 5e6\nfix m2 all property/global poissonsRatio "
      "peratomtype 0.4 0.4\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.6 0.6 0.6 0.5\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 2 0.1 0.2 0.2 0.4\n"
      "pair_style gran model hertz tangential history\ntimestep 1e-5\n" +
      lines + all_move + "run 15 upto\n";
  std::string inner = dump;
  inner.replace(inner.find("2 1 0 1 0 "), 10, "2 1 0.1 0.9 0.1 ");
  const std::map<std::string, std::string> files = {{"in.x", script}, {"dump", inner}};
  return import_script("in.x", test::reader_of(files), {}, dump_file);
}

TEST(ImportGrains, ComeFromADumpInPlaceOfARestart) {
  const ImportedDeck imported = import_restart("group two id 2\nset group two vx 3\n", "dump");
  EXPECT_EQ(notes_of(imported), "in.x:3: read_restart old.restart: the grains of dump are there instead\n");
  const NewParticles grains = grains_of(imported, "grains.csv");
  ASSERT_EQ(grains.size(), 2U);
  EXPECT_EQ(grains.velocity[0], (Vec3{3.0, 0.0, 0.0}));
  const Deck deck = read_deck(imported.deck, "x.toml", {});
  EXPECT_EQ(deck.domain.min, (Vec3{-1.0, 0.0, 0.0}));
  EXPECT_EQ(deck.domain.max, (Vec3{1.0, 2.0, 1.0}));
  EXPECT_EQ(deck.phases.at(0).steps, 10);  // from step 5 on
  // What is inserted behind it comes as well; a box of its own stays.
  const Deck more = read_deck(
      import_restart("region big block -2 2 -2 4 -2 4 units box\ncreate_box 2 big\n"
                     "fix t all particletemplate/sphere 1 atom_type 2 density constant 2000 radius constant 0.1\n"
                     "fix d all particledistribution/discrete 1 1 t 1\nfix ins all insert/pack seed 1 "
                     "distributiontemplate d insert_every once all_in yes region big particles_in_region 9\n",
                     "dump")
          .deck,
      "x.toml", {});
  EXPECT_EQ(more.domain.max, (Vec3{2.0, 4.0, 4.0}));
  ASSERT_EQ(more.particles.size(), 2U);
  EXPECT_EQ(more.particles[1].count, 7);
  EXPECT_THROW(import_restart("", ""), DeckError);
}

}  // namespace
}  // namespace repose
