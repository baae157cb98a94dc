// Measurements that could measure nothing.
#include <gtest/gtest.h>

#include "deck_cases.h"

namespace repose::test {
namespace {

TEST(DeckMeasurements, OfWhatDoesNotFall) {
  const auto with = [](const std::string& section, const std::string& keys) {
    std::string deck = example_deck.substr(0, example_deck.find("[measurement.discharge]"));
    return deck + "[measurement." + section + "]\n" + keys;
  };
  const std::string pile = with("angle_of_repose", "plate_height = -0.05\n");
  const std::string scattered = with("scattering", "plate_height = -0.05\narea_1_width = 0.01\narea_3_radius = 0.08\n");
  const std::string retained = with("retained_slope", "orifice_height = 0\nradius = 0.02\n");
  const std::string let_out = with("discharge", "orifice_height = 0\n");
  const std::string bed = with("bulk_density", "min = [0, 0, 0]\nmax = [0.01, 0.01, 0.01]\n");
  const std::string drum = with("surface_angle", "radius = 0.02\n");
  for (const std::string& deck : {pile, scattered, retained}) {
    expect_messages({{{}, fine},
                     {{"gravity=[0,0,-1.62]"}, fine},
                     {{"gravity=[0.1,0,-9]"}, "needs a gravity that points straight down, along -z; set \"gravity\""},
                     {{"gravity=[0,0,9.81]"}, "needs a gravity that points straight down, along -z; set \"gravity\""}},
                    deck);
  }
  expect_messages({{{}, fine},
                   {{"gravity=[5,0,-8]"}, fine},
                   {{"gravity=[0,0,0]"}, "needs a gravity that points down, towards -z; set \"gravity\""},
                   {{"gravity=[-9.81,0,0]"}, "needs a gravity that points down, towards -z; set \"gravity\""}},
                  let_out);
  expect_messages({{{}, fine}, {{"gravity=[0,0,0]"}, fine}}, bed);  // of grains that have grown, or are pressed
  for (const std::string& deck : {pile, scattered, retained, let_out}) {
    expect_messages({{{"domain.periodic=['z']", "time.expected_speed=1"},
                      "the height z must not be a periodic direction of the [domain]"}},
                    deck);
  }
  expect_messages({{{"domain.periodic=['y']"}, fine},
                   {{"domain.periodic=['x']"},
                    "a pile has no flanks along x, a periodic direction of the [domain]; only y may be one"}},
                  pile);
  expect_messages({{{"measurement.retained_slope.orifice_height=0.2"},
                    "\"orifice_height\" = 0.2 lies outside the [domain], from -0.1 to 0.1"}},
                  retained);
  expect_messages(
      {{{}, fine},
       {{"measurement.surface_angle.axis_direction=[0,0,-2]"},
        "\"axis_direction\" is along gravity; the axis of a drum lies across it"},
       {{"gravity=[0,0,0]"}, "there is no gravity, against which the slope of a bed is measured; set \"gravity\""}},
      drum);
}

TEST(DeckMeasurements, OnWallsThatDoNothing) {
  const auto shear = [](const std::string& wall, const std::string& height) {
    return Overrides{"measurement.shear={walls=['" + wall + "'], area=1e-4, direction=[1,0,0], phase='flow', " +
                     "plane_height=" + height + "}"};
  };
  const char* const no_mechanics = "phase \"flow\" is one without mechanics, in which nothing moves";
  expect_messages({
      {shear("floor", "0"), fine},
      {shear("floor", "0.2"), "\"plane_height\" = 0.2 lies outside the [domain], from -0.1 to 0.1"},
      {shear("flor", "0"), "unknown wall \"flor\"; the nearest is \"floor\""},
      {shear("gate", "0"), "wall \"gate\" is not there in phase \"flow\"; let a phase add it (add_walls)"},
      {all(still, shear("floor", "0")), no_mechanics},
  });

  const auto lid = [](const std::string& more) {
    return Overrides{"wall.gate.servo={direction=[0,0,-1], force=1, max_speed=0.1, max_way=0.02" + more + "}",
                     "phase.flow.remove_walls=[]"};
  };
  const auto bed = [](const std::string& height) {
    return Overrides{
        "measurement.compression={lid='gate', area=1e-4, load_phase='settle', unload_phase='flow', height=" + height +
        "}"};
  };
  expect_messages({
      {all(lid(""), bed("0.05")), fine},
      {all(lid(", phases=['flow']"), bed("0.05")), fine},
      {all(lid(", phases=['settle']"), bed("0.05")),
       "the [wall.servo] of wall \"gate\" does not act in phase \"flow\", so that the lid cannot go back; name it in "
       "its "
       "phases"},
      {all(lid(""), bed("0.05"), Overrides{"phase.flow.remove_walls=['gate']"}),
       "wall \"gate\" is not there in phase \"flow\"; let a phase add it (add_walls)"},
      {all(still, lid(""), bed("0.05")), no_mechanics},
  });

  const Overrides blade = {"measurement.flow_energy={walls=['tube'], phase='flow'}"};
  const auto turns = [](const std::string& more) {
    return Overrides{"wall.tube.motion=[{type='rotation', angular_velocity=1" + more + "}]"};
  };
  const char* const at_rest =
      "wall \"tube\" does not move in phase \"flow\"; name one in which the blade's [[wall.motion]] acts";
  expect_messages({
      {all(blade, turns("")), fine},
      {all(blade, turns(", phases=['flow']")), fine},
      {all(blade, turns(", phases=['settle']")), at_rest},
      {all(blade, Overrides{"wall.tube.moves_with=floor"},
           Overrides{"wall.floor.motion=[{type='rotation', angular_velocity=1, phases=['settle']}]"}),
       at_rest},
      {all(still, blade, turns("")), no_mechanics},
      {all(blade, turns(""), Overrides{"phase.flow.remove_walls=['gate', 'tube']"}),
       "wall \"tube\" is not there in phase \"flow\"; let a phase add it (add_walls)"},
  });
}

}  // namespace
}  // namespace repose::test
