// Decks of which each key is right and which yet cannot mean what they say.
#include <gtest/gtest.h>

#include "deck/calibration_deck.h"
#include "deck/directions.h"
#include "deck/read_deck.h"
#include "deck/sensitivity_deck.h"
#include "deck/validation_deck.h"
#include "deck_cases.h"

namespace repose::test {
namespace {

const std::string translation = "[{type='translation', velocity=[0,0,1]}]";
const Overrides hooke = {"contact.normal_law=hooke", "contact.hooke_characteristic_velocity=2 m/s"};
const Overrides all_still =
    all(still, Overrides{"phase.settle.mechanics=false", "phase.settle.until=time", "phase.settle.time=1"});

/// The example without the keys of a phase that ends by energy.
std::string settled_by_time() {
  std::string deck = example_deck;
  const std::string keys = "kinetic_energy = 1e-12\nmin_time = 0.1\n";
  return deck.replace(deck.find(keys), keys.size(), "");
}

/// The example with another end of its second phase.
std::string until(const std::string& keys) {
  std::string deck = example_deck;
  const std::string time = "until = \"time\"\ntime = 1\n";
  return deck.replace(deck.find(time), time.size(), "max_time = 1\n" + keys);
}

TEST(DeckContradictions, SharesOfTheTimeStepBelongToALaw) {
  expect_messages({
      {hooke, fine},
      {all(hooke, Overrides{"time.hooke_fraction=0.1", "time.rayleigh_fraction=0.2"}), fine},
      {{"time.rayleigh_fraction=0.4", "time.hertz_fraction=0.2"}, fine},
      {{"contact.normal_law=jkr", "time.hertz_fraction=0.2"}, fine},
      {{"time.rayleigh_fraction=1", "time.hertz_fraction=1", "time.hooke_fraction=1"}, fine},
      {all(hooke, Overrides{"time.rayleigh_fraction=0.4"}),
       "--set time.rayleigh_fraction=0.4: \"rayleigh_fraction\" belongs to contact.normal_law = \"hertz\" or \"jkr\"; "
       "give \"hooke_fraction\", or remove this"},
      {all(hooke, Overrides{"time.hertz_fraction=0.2"}),
       "\"hertz_fraction\" belongs to contact.normal_law = \"hertz\" or \"jkr\"; give \"hooke_fraction\", or remove "
       "this"},
      {{"time.hooke_fraction=0.1"},
       "\"hooke_fraction\" belongs to contact.normal_law = \"hooke\"; give \"rayleigh_fraction\" and "
       "\"hertz_fraction\", or remove this"},
  });
}

TEST(DeckContradictions, KeysWithoutEffect) {
  const std::string sizes = "particles.0.sizes={type='uniform', min_diameter=1e-3, max_diameter=3e-3}";
  std::string distributed = example_deck;
  const std::string diameter = "diameter = \"2 mm\"\n";
  distributed.replace(distributed.find(diameter), diameter.size(), "");
  expect_messages({{{sizes}, fine},
                   {{sizes, "particles.0.jitter=1.0"}, fine},
                   {{sizes, "particles.0.jitter=0.5"},
                    "\"jitter\" has no meaning with [particles.sizes], which fills at random; remove it"}},
                  distributed);
  expect_messages({
      {{"output.trace_every=5", "output.trace=false"}, fine},  // switched off
      {{"particles.0.fixed=true"}, fine},
      {{"particles.0.fixed=true", "particles.0.rotation_blocked=true"},
       "\"rotation_blocked\" is for particles that move freely, not for \"fixed\" ones or those on a "
       "[[particles.motion]]; remove it"},
      {{"particles.0.motion=" + translation, "particles.0.rotation_blocked=true"}, "[[particles.motion]]; remove it"},
      {all(still, Overrides{"particles.0.heating=100"}), fine},
      {all(still, Overrides{"particles.0.heating=100", "particles.0.isothermal=true"}),
       "\"heating\" has no effect on \"isothermal\" particles, which keep their temperature; remove one of the two"},
  });
}

TEST(DeckContradictions, NumbersBeyondCounting) {
  expect_messages({{{}, "it must be 1 <= x <= 1000000000000000"}},
                  until("until = \"steps\"\nsteps = 1000000000000001\n"));
  expect_messages({
      {{"particles.0.type=pour", "particles.0.rate=1", "particles.0.start_time=1e12"}, fine},
      {{"particles.0.type=pour", "particles.0.rate=1", "particles.0.start_time=1e13"},
       "it must be 0 <= x <= 1000000000000 (in s)"},
      {{"particles.0.type=pour", "particles.0.rate=1", "particles.0.interval=1e13"},
       "it must be 0 < x <= 1000000000000 (in s)"},
  });
}

TEST(DeckContradictions, AnExitWithinOneBefore) {
  const auto exits = [](const std::string& a, const std::string& b) {
    return Overrides{"exit=[{name='a', " + a + "}, {name='b', " + b + "}]"};
  };
  const char* const never =
      "all of exit \"b\" lies in exit \"a\", which comes first and counts what leaves; put \"b\" before \"a\"";
  expect_messages({
      {exits("face='z_min'", "face='z_max'"), fine},
      {exits("face='z_min', max=[0,0.1,0]", "face='z_min'"), fine},
      {exits("face='z_min', max=[0,0.1,0]", "face='z_min', min=[-0.1,-0.1,0], max=[0.01,0.01,0]"), fine},
      {exits("face='z_min'", "face='z_min', max=[0,0,0]"), never},
      {exits("face='z_min'", "face='z_min', max=[1,1,0]"), never},
      {exits("face='x_max', max=[0,0,0.1]", "face='x_max', max=[0,-0.05,0.05]"), never},
  });
}

TEST(DeckContradictions, PhasesThatWaitForWhatCannotHappen) {
  const std::string gate_force = "until = \"wall_force\"\nforce = 1\nwall = \"gate\"\n";
  const std::string absent =
      "wall \"gate\" is not there in this phase, so that no grain can press on it; add it "
      "(add_walls), or name another";
  expect_messages({{{}, absent.c_str()}, {{"phase.flow.remove_walls=[]"}, fine}}, until(gate_force));
  expect_messages({{{"wall.tube.moves_with=gate", "phase.flow.add_walls=['tube']", "wall.tube.present=false"}, fine}},
                  until(gate_force));
  expect_messages({{{}, absent.c_str()}}, until("until = \"wall_torque\"\ntorque = 1\nwall = \"gate\"\n"));
  expect_messages({{{"phase.settle.add_walls=['gat']"}, "unknown wall \"gat\"; the nearest is \"gate\""}},
                  until(gate_force));

  const std::string servo = "wall.gate.servo={direction=[0,0,-1], force=1, max_speed=0.1, max_way=0.01}";
  expect_messages({{{servo},
                    "\"until\" = servo: no wall whose [wall.servo] acts in this phase is there; add it "
                    "(add_walls)"},
                   {{servo, "phase.flow.remove_walls=[]"}, fine}},
                  until("until = \"servo\"\n"));

  const char* const nothing_moves =
      "waits for nothing: nothing moves in a phase without mechanics; give \"time\" or \"steps\"";
  expect_messages({{still, nothing_moves}}, until("until = \"kinetic_energy\"\nkinetic_energy = 1e-9\n"));
  expect_messages({{still, nothing_moves}}, until("until = \"wall_force\"\nforce = 1\nwall = \"floor\"\n"));
  expect_messages({{still, nothing_moves}}, until("until = \"tilt_onset\"\n"));
  expect_messages({{still, fine}});

  const Overrides tilts = {"tilt={angular_velocity=1, phases=['flow']}", "measurement.surface_angle.radius=0.02"};
  expect_messages({{tilts, fine},
                   {all(tilts, Overrides{"tilt.phases=['settle']"}),
                    "\"until\" = tilt_onset: the [tilt] does not act in this phase; name it in tilt.phases"}},
                  until("until = \"tilt_onset\"\n"));
}

TEST(DeckContradictions, TiltsThatTurnNothing) {
  const std::string tilt = "tilt.angular_velocity=1";
  expect_messages({
      {{tilt}, fine},
      {{"tilt.angular_velocity=0"}, "the tilt needs a rate other than zero"},
      {{tilt, "tilt.axis_direction=[0,0,3]"},
       "\"axis_direction\" is along gravity, which the [tilt] would leave as it is; tilt about another axis"},
      {{tilt, "tilt.phases=['flow', 'settle', 'flow']"}, "phase \"flow\" is named twice"},
      {all(still, Overrides{tilt}), fine},
      {all(still, Overrides{tilt, "tilt.phases=['flow']"}),
       "the tilt acts in phases without mechanics alone, in which nothing moves; name another phase, or remove it"},
      {{tilt, "domain.periodic=['y']"}, fine},
      {{tilt, "domain.periodic=['y']", "tilt.axis_direction=[1,0,0]"},
       "the [tilt] turns gravity towards the periodic direction y, along which the fall has no end; set "
       "time.expected_speed, or tilt about y"},
      {{tilt, "domain.periodic=['y']", "tilt.axis_direction=[1,0,0]", "time.expected_speed=1"}, fine},
      {all(hooke, Overrides{tilt, "domain.periodic=['y']", "tilt.axis_direction=[1,0,0]"}), fine},
      {{"tilt={angular_velocity=1}", "gravity=[0,0,0]"},
       "--set tilt={angular_velocity=1}: there is no gravity for a [tilt] to turn; set \"gravity\", or remove the "
       "[tilt]"},
  });
}

TEST(DeckContradictions, MotionsThatMoveNothing) {
  const std::string servo = "{direction=[0,0,-1], force=1, max_speed=0.1, max_way=0.01";
  const auto phases = [](const char* names) { return std::string("wall.floor.motion.0.phases=") + names; };
  const std::string moves = "wall.floor.motion=" + translation;
  const char* const unmoved =
      " acts in phases without mechanics alone, in which nothing moves; name another phase, or "
      "remove it";
  expect_messages({
      {{moves}, fine},
      {{moves, phases("['flow']")}, fine},
      {{moves, phases("['flow', 'flow']")}, "phase \"flow\" is named twice"},
      {all(still, Overrides{moves, phases("['flow']")}), unmoved},
      {all(still, Overrides{moves, phases("['flow', 'settle']")}), fine},
      {all(still, Overrides{"particles.0.motion=[{type='translation', velocity=[0,0,1], phases=['flow']}]"}), unmoved},
      {all(still, Overrides{"wall.floor.servo=" + servo + "}"}), fine},
      {all(still, Overrides{"wall.floor.servo=" + servo + ", phases=['flow']}"}), unmoved},
      {{"wall.floor.servo=" + servo + ", phases=['flow', 'flow']}"}, "phase \"flow\" is named twice"},
      {{"wall.floor.servo=" + servo + ", times=[0, 1], factors=[0, 0.1]}"}, fine},
      {{"wall.floor.servo=" + servo + ", times=[0, 1], factors=[0, 0]}"},
       "\"factors\" are all 0: the wall would never press; remove the [wall.servo]"},
      {{"wall.gate.motion=" + translation}, fine},
      {{"wall.gate.motion=" + translation, "phase.settle.add_walls=[]", "phase.flow.remove_walls=[]"},
       "wall \"gate\" is in no phase there to move; let a phase add it (add_walls)"},
      {{"wall.gate.servo=" + servo + "}", "phase.settle.add_walls=[]", "phase.flow.remove_walls=[]"},
       "wall \"gate\" is in no phase there to move; let a phase add it (add_walls)"},
      {{"wall.gate.motion=" + translation, "phase.settle.add_walls=['gat']"},
       "unknown wall \"gat\"; the nearest is \"gate\""},
      {{"wall.gate.motion=" + translation, "phase.settle.add_walls=[]", "phase.flow.remove_walls=[]",
        "wall.tube.moves_with=gate"},
       fine},
  });
  expect_messages({{all(all_still, Overrides{moves}), unmoved}, {all_still, fine}}, settled_by_time());
}

TEST(DeckContradictions, DirectionsAreParallelUpToTheRoundingOfTheirDigits) {
  EXPECT_TRUE(are_parallel({3.0, 4.0, 0.0}, {0.6, 0.8, 0.0}));
  EXPECT_TRUE(are_parallel({0.1, 0.2, 0.3}, {-0.3, -0.6, -0.9}));
  EXPECT_TRUE(are_parallel({1e200, 2e200, 0.0}, {1e-200, 2e-200, 0.0}));
  EXPECT_FALSE(are_parallel({1e-200, 0.0, 0.0}, {0.0, 1e-200, 0.0}));
  EXPECT_FALSE(are_parallel({1.0, 0.0, 0.0}, {1.0, 1e-9, 0.0}));
  EXPECT_TRUE(are_parallel({}, {1.0, 0.0, 0.0}));
  const std::string turns = "wall.floor.motion=[{type='rotation', angular_velocity=1, axis_direction=";
  expect_messages({
      {{"tilt={angular_velocity=1, axis_direction=[0.1,0.7,0]}",
        "measurement.surface_angle={radius=0.02, axis_direction=[0.3,2.1,0]}"},
       fine},
      {{turns + "[1e-14,1,0]}]", "domain.periodic=['y']"}, fine},
      {{turns + "[1e-3,1,0]}]", "domain.periodic=['y']"},
       "moves along or turns away from the periodic direction y of the [domain]"},
      {{"wall.floor.servo={type='rotation', torque=1, max_angular_velocity=1, max_angle=9, axis_direction=[0,1,1e-14]}",
        "domain.periodic=['y']"},
       fine},
  });
}

TEST(DeckContradictions, ADeckOfARunIsNoFileOfAStudy) {
  const auto expect = [](const std::string& message, const auto& read, const std::string& text) {
    EXPECT_EQ(deck_error([&] { read(text, "heap.toml"); }), message);
  };
  expect("heap.toml: no file for repose calibrate, but a deck of a run; `repose keys calibrate` lists its keys",
         read_calibration_deck, example_deck);
  expect("heap.toml: no file for repose sensitivity, but a deck of a run; `repose keys sensitivity` lists its keys",
         read_sensitivity_deck, example_deck);
  expect("heap.toml: no file for repose validate, but a deck of a run; `repose keys validate` lists its keys",
         read_validation_deck, example_deck);
  expect("heap.toml: no file for repose calibrate, but one for repose validate; `repose keys calibrate` lists its keys",
         read_calibration_deck, "[[case]]\nname = \"a\"\n");
  expect(
      "heap.toml: no file for repose sensitivity, but one for repose calibrate; `repose keys sensitivity` lists its "
      "keys",
      read_sensitivity_deck, "[[parameter]]\nname = \"a\"\n[[observable]]\nfigure = \"b\"\n");
  expect(
      "heap.toml: no file for repose validate, but one for repose sensitivity; `repose keys validate` lists its keys",
      read_validation_deck, "figures = [\"b\"]\n[[parameter]]\nname = \"a\"\n");
}

// Results of a version that did not refuse what does not go together can still be read.
TEST(DeckContradictions, AreNoneOfADeckThatWasRun) {
  const std::vector<std::string> still = {"tilt={angular_velocity=0, axis_direction=[0,0,1]}"};
  EXPECT_NE(message_of(example_deck, still).find("which the [tilt] would leave as it is"), std::string::npos);
  EXPECT_EQ(read_written_deck(example_deck, "deck.toml", still).tilt.angular_velocity, 0.0);
}

TEST(DeckContradictions, OverridesKnowEverySectionThatCanBeRepeated) {
  for (const std::string section : {"exit", "phase.0.heat", "wall.0.motion", "particles.0.motion"}) {
    const std::string set_text = section + ".0.name=a";
    EXPECT_EQ(message_of(example_deck, {set_text}), "--set " + set_text + ": the deck has no [[" + section + "]]");
  }
  EXPECT_EQ(message_of(example_deck, {"wall.0.heat.name=a"}).find("the deck has no"), std::string::npos);
}

}  // namespace
}  // namespace repose::test
