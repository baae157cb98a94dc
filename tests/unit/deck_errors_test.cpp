#include <gtest/gtest.h>

#include "base/error.h"
#include "deck/overrides.h"
#include "deck/parse_toml.h"
#include "deck/read_deck.h"
#include "deck_example.h"

namespace repose {
namespace {

/// The example deck with one text, which must occur exactly once, replaced.
std::string with(const std::string& old_text, const std::string& new_text) {
  std::string deck = example_deck;
  const std::size_t at = deck.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  EXPECT_EQ(deck.find(old_text, at + 1), std::string::npos) << old_text << " is there twice";
  return deck.replace(at, old_text.size(), new_text);
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_deck(text, "deck.toml", overrides);
  } catch (const DeckError& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "no error";
}

struct Edit {
  const char* old_text;
  const char* new_text;
  const char* message;  ///< behind "deck.toml:"
};

void expect_messages(const std::vector<Edit>& edits) {
  for (const Edit& edit : edits) {
    EXPECT_EQ(message_of(with(edit.old_text, edit.new_text)), std::string("deck.toml:") + edit.message);
  }
}

TEST(DeckErrors, TheExampleHasNone) { EXPECT_EQ(message_of(example_deck), "no error"); }

TEST(DeckErrors, Syntax) {
  expect_messages({
      {"step = 1e-6", "step = 1e-6\nstep = 2e-6",
       "61:8: TOML syntax: Error while parsing key-value pair: cannot redefine existing floating-point 'step'; give it "
       "once"},
      {"[time]", "[domain]",
       "59:1: TOML syntax: Error while parsing table header: cannot redefine existing table 'domain'; give it once"},
      {"[[wall]]\nname = \"floor\"", "[[wall.motion]]\ntype = \"translation\"\n[[wall]]\nname = \"floor\"",
       "31:1: TOML syntax: Error while parsing table header: cannot redefine existing table 'wall' as array-of-tables; "
       "give it once; a section such as [[wall.motion]] stands behind the [[wall]] it belongs to"},
      {"step = 1e-6", "step = 1 us",
       "60:10: TOML syntax: Error while parsing key-value pair: expected a comment or whitespace, saw 'u'; one key per "
       "line, and a value with a unit is a text, as \"5 mm\""},
      {"type = \"disc\"", "type = disc",
       "43:8: TOML syntax: Error while parsing value: could not determine value type; a text needs quotes"},
      {"[time]", "[time", "59:6: TOML syntax: Error while parsing table header: expected ']', saw '\\n'"},
  });
}

TEST(DeckErrors, UnknownKeys) {
  expect_messages({
      {"density = 2500", "densty = 2500",
       "9:1: unknown key \"densty\" in [[material]]; the nearest key is \"density\""},
      {"[time]", "[tyme]", "59:2: unknown key \"tyme\" in the deck; the nearest key is \"time\""},
      {"[measurement.discharge]", "[measurement.discharg]",
       "76:14: unknown key \"discharg\" in [measurement]; the nearest key is \"discharge\""},
      {"plate_height = -0.05", "plate_heigth = -0.05",
       "80:1: unknown key \"plate_heigth\" in [measurement.angle_of_repose]; the nearest key is \"plate_height\""},
      {"max = [0.1, 0.1, \"100 mm\"]", "max = [0.1, 0.1, 0.1]\ngravity = [0, 0, -1]",
       "4:1: unknown key \"gravity\" in [domain]; it belongs before the first section"},
      {"step = 1e-6", "step = 1e-6\nrun.sed = 1", "61:1: unknown key \"run\" in [time]; the nearest key is \"step\""},
  });
}

TEST(DeckErrors, MissingKeysAndSections) {
  expect_messages({
      {"density = 2500\n", "", "5:1: [[material]] lacks \"density\" (density of the solid)"},
      {"centre = [0, 0, 0]\nradius = 0.02\n", "", "41:1: [[wall]] lacks \"centre\" (centre), \"radius\" (radius)"},
      {"kinetic_energy = 1e-12\n", "",
       "62:1: [[phase]] lacks \"kinetic_energy\" (ends when the mean translational energy per particle is below)"},
      {"max_time = 2\n", "", "62:1: [[phase]] lacks \"max_time\" (ends the phase whatever its condition says)"},
      {"count = 100\n", "", "49:1: [[particles]] lacks \"mass\" or \"count\"; give one of them"},
      {"until = \"time\"\n", "", "70:1: [[phase]] lacks \"until\" (what ends the phase)"},
  });
  EXPECT_EQ(
      message_of(""),
      "deck.toml:1:1: the deck lacks \"domain\" (the box that is simulated; a particle that leaves it is counted and "
      "gone), \"material\" (a solid), \"pair\" (contact of two materials, in either order), \"particles\" (a block of "
      "spheres), \"phase\" (a stage of the run; the phases follow each other)");
}

TEST(DeckErrors, KeysOfAnotherType) {
  expect_messages({
      {"point = [0, 0, -0.05]", "point = [0, 0, -0.05]\nradius = 1",
       "34:1: \"radius\" of [[wall]] is only allowed with type = disc; remove it"},
      {"count = 100", "file = \"a.csv\"",
       "53:1: \"file\" of [[particles]] is only allowed with type = csv, snapshot; remove it"},
      {"count = 100", "max = [1, 1, 1]", "53:1: \"max\" of [[particles]] is only allowed with region = box; remove it"},
      {"time = 1\n", "time = 1\nsteps = 5\n",
       "74:1: \"steps\" of [[phase]] is only allowed with until = steps; remove it"},
      {"time = 1\n", "time = 1\nmin_time = 1\n",
       "74:1: \"min_time\" of [[phase]] is only allowed with until = kinetic_energy, servo, wall_force, wall_torque; "
       "remove it"},
      {"plate_height = -0.05", "plate_height = -0.05\ncamera_height = 0",
       "81:1: \"camera_height\" of [measurement.angle_of_repose] is only allowed with camera = perspective; remove it"},
  });
}

TEST(DeckErrors, Types) {
  expect_messages({
      {"poisson_ratio = 0.25", "poisson_ratio = \"0.25\"",
       "8:17: \"poisson_ratio\" must be a number, not the text \"0.25\""},
      {"density = 2500", "density = true",
       "9:11: \"density\" must be a number in kg/m3 or a text with a unit such as \"1 kg/m3\", not true"},
      {"density = 2500", "density = 2020-01-01",
       "9:11: \"density\" must be a number in kg/m3 or a text with a unit such as \"1 kg/m3\", not a date or time"},
      {"count = 100", "count = 1e2", "53:9: \"count\" must be an integer, not the number 100"},
      {"present = false", "present = 0", "45:11: \"present\" must be true or false, not the number 0"},
      {"name = \"settle\"", "name = 7", "63:8: \"name\" must be a text in quotes, not the number 7"},
      {"[0, 0, -0.05]", "[0, 0]", "33:9: \"point\" must be [x, y, z], not a list of 2"},
      {"[0, 0, -0.05]", "0.05", "33:9: \"point\" must be [x, y, z], not the number 0.05"},
      {"[0, 0, -0.05]", "[0, [], 1]",
       "33:13: \"point.1\" must be a number in m or a text with a unit such as \"1 m\", not a list of 0"},
      {"[0.02, -0.05]", "[0.02]", "39:25: \"points.1\" must be [r, z], not a list of 1"},
      {"[[0.02, 0.05], [0.02, -0.05]]", "3", "39:10: \"points\" must be a list of [r, z], not the number 3"},
      {"[\"glass\", \"glass\"]", "[\"glass\"]", "18:13: \"materials\" must be [text, text], not a list of 1"},
      {"add_walls = [\"gate\"]", "add_walls = \"gate\"",
       "68:13: \"add_walls\" must be a list of texts, not the text \"gate\"; write [\"gate\"]"},
      {"[measurement.discharge]", "[[measurement.discharge]]",
       "76:1: \"measurement.discharge\" is a list of 1; it must be the section [measurement.discharge]"},
      {"type = \"disc\"", "type = \"disk\"",
       "43:8: \"disk\" is no type; it must be one of profile, plane, disc, rectangle, mesh; the nearest is \"disc\""},
  });
}

TEST(DeckErrors, ValueInsteadOfSection) {
  EXPECT_EQ(message_of("time = 1e-6\n" + with("[time]\nstep = 1e-6\n", "")),
            "deck.toml:1:8: \"time\" is the number 1e-06; it must be the section [time]");
}

TEST(DeckErrors, SingleInsteadOfRepeatedSection) {
  EXPECT_EQ(message_of("[domain]\nmin=[0,0,0]\nmax=[1,1,1]\n[material]\nname=\"a\"\n"),
            "deck.toml:4:1: \"material\" is a section; write [[material]], which can be repeated");
}

TEST(DeckErrors, RangesAndUnits) {
  expect_messages({
      {"poisson_ratio = 0.25", "poisson_ratio = 0.5",
       "8:17: \"poisson_ratio\" = 0.5 is out of range; it must be 0 <= x < 0.5"},
      {"restitution = 0.9", "restitution = 1.01",
       "19:15: \"restitution\" = 1.01 is out of range; it must be 0 <= x <= 1"},
      {"sliding_friction = 0.5", "sliding_friction = -0.5",
       "20:20: \"sliding_friction\" = -0.5 is out of range; it must be >= 0"},
      {"step = 1e-6", "step = 0", "60:8: \"step\" = 0 is out of range; it must be > 0 (in s)"},
      {"step = 1e-6", "step = inf", "60:8: \"step\" must be finite, not inf"},
      {"step = 1e-6", "step = \"1e999 s\"",
       "60:8: \"step\": \"1e999 s\" is too large or too small for a double; write a time with one of the units s, ms, "
       "us, ns"},
      {"step = 1e-6", "step = nan", "60:8: \"step\" must be finite, not nan"},
      {"count = 100", "count = 0", "53:9: \"count\" = 0 is out of range; it must be >= 1"},
      {"[0, 0, -0.05]", "[0, nan, 0]", "33:13: \"point.1\" must be finite, not nan"},
      {"\"2 mm\"", "\"2 mg\"",
       "52:12: \"diameter\": \"2 mg\" is not a length; write a length with one of the units m, km, cm, mm, um, nm"},
      {"\"100 mm\"", "\"100 mn\"",
       "3:18: \"max.2\": \"100 mn\" is not a length; write a length with one of the units m, km, cm, mm, um, nm"},
      {"step = 1e-6", "step = \"1e-6\"",
       "60:8: \"step\": \"1e-6\" has no unit; write a time with one of the units s, ms, us, ns"},
      {"orifice_height = 0", "orifice_height = 0\nplugged_share = 1.5",
       "78:17: \"plugged_share\" = 1.5 is out of range; it must be 0 <= x <= 1"},
  });
}

TEST(DeckErrors, NamesAndPairs) {
  expect_messages({
      {"name = \"steel\"", "name = \"glass\"", "12:8: there are two [[material]] \"glass\"; a name is used once"},
      {"name = \"tube\"", "name = \"floor\"", "36:8: there are two [[wall]] \"floor\"; a name is used once"},
      {"name = \"flow\"", "name = \"settle\"", "71:8: there are two [[phase]] \"settle\"; a name is used once"},
      {"name = \"flow\"", "name = \"1.flow\"",
       "71:8: \"1.flow\" is no name; begin with a letter, then letters, digits, _ or -"},
      {"materials = [\"steel\", \"glass\"]", "materials = [\"stel\", \"glass\"]",
       "24:14: unknown material \"stel\"; the nearest is \"steel\""},
      {"material = \"steel\"\npoint =", "material = \"stele\"\npoint =",
       "32:12: unknown material \"stele\"; the nearest is \"steel\""},
      {"material = \"glass\"", "material = \"gloss\"", "51:12: unknown material \"gloss\"; the nearest is \"glass\""},
      {"materials = [\"glass\", \"glass\"]", "materials = [\"glass\", \"steel\"]",
       "24:13: the pair of \"steel\" and \"glass\" is given twice; the order of the two does not matter"},
      {"materials = [\"glass\", \"glass\"]", "materials = [\"steel\", \"steel\"]",
       "51:12: no [[pair]] for \"glass\" and \"glass\", which can touch; add materials = [\"glass\", \"glass\"]"},
      {"materials = [\"steel\", \"glass\"]", "materials = [\"steel\", \"steel\"]",
       "32:12: no [[pair]] for \"glass\" and \"steel\", which can touch; add materials = [\"glass\", \"steel\"]"},
  });
}

TEST(DeckErrors, MixturesNeedTheirPairs) {
  const std::string two =
      example_deck +
      "[[particles]]\ntype = \"fill\"\nmaterial = \"steel\"\ndiameter = 0.002\ncount = 1\nregion = \"box\"\n"
      "min = [0, 0, 0]\nmax = [0.05, 0.05, 0.05]\n";
  EXPECT_EQ(message_of(two),
            "deck.toml:32:12: no [[pair]] for \"steel\" and \"steel\", which can touch; add materials = [\"steel\", "
            "\"steel\"]");
  const std::string pair =
      "[[pair]]\nmaterials = [\"steel\", \"steel\"]\nrestitution = 1\nsliding_friction = 0\nrolling_friction = 0\n";
  EXPECT_EQ(message_of(two + pair), "no error");
}

TEST(DeckErrors, Sizes) {
  const auto sizes = [](const std::string& keys) {
    std::string deck = with("diameter = \"2 mm\"\n", "");
    return message_of(deck.insert(deck.find("\n[time]"), "[particles.sizes]\n" + keys));
  };
  const std::string uniform = "type = \"uniform\"\nmin_diameter = 1e-3\nmax_diameter = 3e-3\n";
  EXPECT_EQ(sizes(uniform), "no error");
  EXPECT_EQ(message_of(with("diameter = \"2 mm\"\n", "")),
            "deck.toml:49:1: [[particles]] lacks \"diameter\" or \"sizes\"; give one of them");
  EXPECT_EQ(sizes("type = \"uniform\"\nmin_diameter = 1e-3\n"),
            "deck.toml:57:1: [particles.sizes] lacks \"max_diameter\" (what is larger is left out)");
  EXPECT_EQ(sizes("type = \"uniform\"\nmin_diameter = 3e-3\nmax_diameter = 1e-3\n"),
            "deck.toml:60:16: \"max_diameter\" = 0.001 must be greater than \"min_diameter\" = 0.003");
  EXPECT_EQ(sizes(uniform + "median = 2e-3\n"),
            "deck.toml:61:1: \"median\" of [particles.sizes] is only allowed with type = lognormal; remove it");
  EXPECT_EQ(sizes("type = \"classes\"\ndiameters = [1e-3, 2e-3]\nshares = [1]\n"),
            "deck.toml:60:10: 1 \"shares\" for 2 \"diameters\"; give one for each");
  EXPECT_EQ(sizes("type = \"classes\"\ndiameters = [2e-3, 2e-3]\nshares = [1, 1]\n"),
            "deck.toml:59:13: \"diameters\" must increase");
  EXPECT_EQ(sizes("type = \"classes\"\ndiameters = [2e-3]\nshares = [0]\n"), "deck.toml:60:10: \"shares\" are all 0");
}

TEST(DeckErrors, Pours) {
  expect_messages({
      {"type = \"fill\"", "type = \"pour\"",
       "49:1: [[particles]] lacks \"rate\" or \"particle_rate\"; give one of them"},
      {"type = \"fill\"", "type = \"pour\"\nrate = 1\nparticle_rate = 1",
       "52:17: \"rate\" and \"particle_rate\" are both given; remove one"},
      {"type = \"fill\"", "type = \"pour\"\nrate = \"1 g\"",
       "51:8: \"rate\": \"1 g\" is not a mass per time; write a mass per time with one of the units kg/s, t/s, g/s, "
       "mg/s"},
      {"region = \"cylinder\"\ncentre = [0, 0, 0]\nradius = 0.015\nheight = 0.05",
       "region = \"disc\"\ncentre = [0, 0, 0]\nradius = 0.015",
       "54:10: a disc has no volume to fill; only type = \"pour\" can use it"},
  });
}

TEST(DeckErrors, Lattices) {
  expect_messages({
      {"type = \"fill\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\ncount = 100",
       "type = \"lattice\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\nlattice = \"face_centred\"\nspacing = 0.0025",
       "54:11: \"spacing\" = 0.0025 puts the nearest sites at 0.00176777, less than the diameter 0.002"},
      {"type = \"fill\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\ncount = 100",
       "type = \"lattice\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\nspacing = 0.0025\ncounts = [1, 2, 3]",
       "55:1: \"region\" of [[particles]] is only allowed with type = fill, pour, or lattice without counts; remove "
       "it"},
  });
}

TEST(DeckErrors, Shapes) {
  expect_messages({
      {"max = [0.1, 0.1, \"100 mm\"]", "max = [0.1, -0.1, 0.1]",
       "3:7: \"max\" must be greater than \"min\" in x, y and z"},
      {"[[0.02, 0.05], [0.02, -0.05]]", "[[0.02, 0.05]]", "39:10: \"points\" needs at least 2 points [r, z], not 1"},
      {"[0.02, -0.05]", "[-0.02, -0.05]", "39:25: r = -0.02 is negative; r is the distance from the axis"},
      {"[0.02, -0.05]", "[\"20 mm\", 0.05]", "39:25: this point repeats the one before; a segment needs a length"},
      {"[[0.02, 0.05], [0.02, -0.05]]", "[[0, 0.05], [0, -0.05]]",
       "39:22: this segment lies on the axis and has no surface; remove one of its points"},
      {"[[0.02, 0.05], [0.02, -0.05]]", "[[0.02, 0.05], [0.02, -0.05]]\naxis_direction = [0, 0, 0]",
       "40:18: \"axis_direction\" has length zero; it needs a direction"},
      {"radius = 0.02", "radius = 0.02\nnormal = [0, 0, 0]", "48:10: \"normal\" has length zero; it needs a direction"},
      {"type = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, -0.05]",
       "type = \"rectangle\"\nmaterial = \"steel\"\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [1, 1, 0]",
       "35:10: \"edge_v\" is not perpendicular to \"edge_u\""},
      {"type = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, -0.05]",
       "type = \"rectangle\"\nmaterial = \"steel\"\ncorner = [0, 0, 0]\nedge_u = [0, 0, 0]\nedge_v = [1, 1, 0]",
       "34:10: \"edge_u\" has length zero; it needs a direction"},
      {"diameter = \"2 mm\"", "diameter = \"31 mm\"", "52:12: \"diameter\" = 0.031 is larger than the region"},
      {"count = 100", "count = 100\nmass = 0.01", "53:9: \"mass\" and \"count\" are both given; remove one"},
      {"count = 100", "count = 100\nspacing = 0.0019", "54:11: \"spacing\" = 0.0019 is less than the diameter 0.002"},
      {"height = 0.05", "height = 0.2",
       "54:10: the region reaches to z = 0.2 m, beyond [domain] max = 0.1 m; enlarge the domain"},
      {"height = 0.05", "height = 28",
       "54:10: the region reaches to z = 28 m, beyond [domain] max = 0.1 m; enlarge the domain, or give the unit (\"28 "
       "mm\")"},
      {"height = 0.05", "height = 0.05\nradius_top = 0.2",
       "54:10: the region reaches to x = -0.2 m, beyond [domain] min = -0.1 m; enlarge the domain"},
      {"step = 1e-6", "[neighbours]\nskin = 0.1\ninner_skin = 0.2",
       "62:14: \"inner_skin\" = 0.2 must be at most \"skin\" = 0.1"},
      {"plate_height = -0.05", "plate_height = -0.05\nfit_to = 0.2",
       "81:10: \"fit_to\" = 0.2 must be greater than \"fit_from\" = 0.2"},
      {"plate_height = -0.05", "plate_height = 0", "79:1: \"max_height\" = 0 must be above \"plate_height\" = 0"},
      {"plate_height = -0.05", "plate_height = -15",
       "80:16: \"plate_height\" = -15 lies outside the [domain], from -0.1 to 0.1"},
  });
}

TEST(DeckErrors, Scattering) {
  const auto message = [](const std::string& keys) {
    return message_of(std::string(example_deck) +
                      "[measurement.scattering]\nplate_height = -0.05\narea_1_width = 0.01\n" + keys);
  };
  EXPECT_EQ(message("area_3_radius = 0.08\n"), "no error");
  EXPECT_EQ(message(""),
            "deck.toml:81:1: [measurement.scattering] lacks \"area_3_radius\" (radius of the outermost circle; area 3 "
            "is from "
            "there to the plate's edge)");
  EXPECT_EQ(message("area_3_radius = 0.15\n"),
            "deck.toml:84:17: 0.15 leaves nothing for area 3: the plate's farthest corner is 0.1414 from the axis");
  EXPECT_EQ(message("area_3_radius = 0.1\naxis = [0.1, 0.1, 0]\narea_3_widened = [0.28, 0.29]\n"),
            "deck.toml:86:25: 0.29 leaves nothing for area 3: the plate's farthest corner is 0.2828 from the axis");
  EXPECT_EQ(message("area_3_radius = 0.08\nplate_max = [0.1, -0.1, 0]\n"),
            "deck.toml:85:13: \"plate_max\" must be greater than \"plate_min\" in x and y");
  EXPECT_EQ(message("area_3_radius = 0.08\nmax_height = -0.05\n"),
            "deck.toml:85:14: \"max_height\" = -0.05 must be above \"plate_height\" = -0.05");
  EXPECT_EQ(message("area_3_radius = 0.08\nbase_share = 1\n").substr(0, 16), "deck.toml:85:14:");
}

TEST(DeckErrors, Phases) {
  expect_messages({
      {"min_time = 0.1", "min_time = 3", "66:12: \"min_time\" = 3 is beyond \"max_time\" = 2"},
      {"remove_walls = [\"gate\"]", "remove_walls = [\"floor\", \"gat\"]",
       "74:26: unknown wall \"gat\"; the nearest is \"gate\""},
      {"add_walls = [\"gate\"]\n", "",
       "73:17: wall \"gate\" is not there when this phase begins and cannot be removed"},
      {"remove_walls = [\"gate\"]", "remove_walls = [\"gate\", \"gate\"]",
       "74:25: wall \"gate\" is not there when this phase begins and cannot be removed"},
      {"add_walls = [\"gate\"]", "add_walls = [\"floor\"]",
       "68:14: wall \"floor\" is already there when this phase begins; set present = false, or remove it in an earlier "
       "phase"},
  });
}

TEST(DeckErrors, PeriodicDirections) {
  const std::string no_pile = example_deck.substr(0, example_deck.find("[measurement.angle_of_repose]"));
  const auto expect = [&](const std::vector<std::string>& overrides, const std::string& message) {
    EXPECT_EQ(message_of(no_pile, overrides), message);
  };
  expect({"domain.periodic=[\"x\", \"y\"]"}, "no error");
  expect({"domain.periodic=[\"x\", \"x\"]"}, "--set domain.periodic=[\"x\", \"x\"]: \"x\" is given twice");
  expect({"domain.periodic=[\"w\"]"},
         "--set domain.periodic=[\"w\"]: \"w\" is no periodic.0; it must be one of x, y, z; the nearest is \"x\"");
  expect({"domain.periodic=\"x\""},
         "--set domain.periodic=\"x\": \"periodic\" must be a list of choices, not the text \"x\"; write [\"x\"]");
  expect({"output.snapshot_times=\"0.25\""},
         "--set output.snapshot_times=\"0.25\": \"snapshot_times\" must be a list of numbers, not the text \"0.25\"; "
         "write [0.25]");
  expect(
      {"gravity=[1, 0, -9]", "domain.periodic=[\"x\"]"},
      "--set domain.periodic=[\"x\"]: gravity along x is not zero, so the fall along the periodic direction x has no "
      "end; set time.expected_speed");
  expect({"gravity=[1, 0, -9]", "domain.periodic=[\"x\"]", "time.expected_speed=2"}, "no error");
  expect({"gravity=[1, 0, -9]", "domain.periodic=[\"x\"]", "contact.normal_law=hooke",
          "contact.hooke_characteristic_velocity=2"},
         "no error");  // whose time step knows no speed
  EXPECT_EQ(message_of(example_deck, {"gravity=[0, 0, 0]", "domain.periodic=[\"z\"]"}),
            "deck.toml:76:1: the height z must not be a periodic direction of the [domain]");
}

TEST(DeckErrors, Exits) {
  const auto expect = [](const std::string& keys, const std::string& message) {
    EXPECT_EQ(message_of(std::string(example_deck) + "\n[[exit]]\n" + keys), message) << keys;
  };
  expect("name = \"hole\"\nface = \"z_min\"\nmin = [0, 0, 0]", "no error");
  expect("name = \"hole\"\nface = \"bottom\"",
         "deck.toml:84:8: \"bottom\" is no face; it must be one of x_min, x_max, y_min, y_max, z_min, z_max; the "
         "nearest is \"x_min\"");
  expect("name = \"hole\"", "deck.toml:82:1: [[exit]] lacks \"face\" (face of the domain)");
  expect("name = \"x_min\"\nface = \"x_min\"", "deck.toml:83:8: \"x_min\" is the name of a whole face; take another");
  expect("name = \"a\"\nface = \"x_min\"\n[[exit]]\nname = \"a\"\nface = \"x_max\"",
         "deck.toml:86:8: there are two [[exit]] \"a\"; a name is used once");
  expect("name = \"a\"\nface = \"x_min\"\nmin = [0, 0.05, 0]\nmax = [0, 0.05, 0.1]",
         "deck.toml:86:7: from 0.05 to 0.05 in y is no part of the domain's face");
  expect("name = \"a\"\nface = \"z_min\"\nmin = [0.1, 0, 0]",
         "deck.toml:82:1: from 0.1 to 0.1 in x is no part of the domain's face");
  EXPECT_EQ(message_of(std::string(example_deck) + "\n[[exit]]\nname = \"a\"\nface = \"y_max\"\n",
                       {"domain.periodic=[\"y\"]"}),
            "deck.toml:84:8: nothing leaves by \"y_max\": y is a periodic direction");
}

TEST(DeckErrors, TheFirstByPositionIsReported) {
  std::string deck = with("restitution = 0.9", "restitution = 9");
  deck.replace(deck.find("step = 1e-6"), 11, "stop = 1e-6");
  EXPECT_EQ(message_of(deck), "deck.toml:19:15: \"restitution\" = 9 is out of range; it must be 0 <= x <= 1");
}

TEST(DeckErrors, Overrides) {
  struct Bad {
    const char* set_text;
    const char* message;
  };
  const Bad cases[] = {
      {"time.step=abc", "\"step\": \"abc\" is not a number; write a time with one of the units s, ms, us, ns"},
      {"time.step=-1", "\"step\" = -1 is out of range; it must be > 0 (in s)"},
      {"time.stp=1", "unknown key \"stp\" in [time]; the nearest key is \"step\""},
      {"tyme.step=1", "unknown key \"tyme\" in the deck; the nearest key is \"time\""},
      {"measurement.discharg.plugged_share=1",
       "unknown key \"discharg\" in [measurement]; the nearest key is \"discharge\""},
      {"time.step.size=1", "\"time.step\" is a value and has no keys"},
      {"time.step", "write key=value, such as time.step=2e-6"},
      {"time..step=1", "the key has an empty part"},
      {"=1", "the key has an empty part"},
      {"material.glas.density=1", "there is no [[material]] \"glas\"; the nearest is \"glass\""},
      {"material.2.density=1", "there is no [[material]] \"2\"; the deck has 2, counted from 0"},
      {"material.glass.densty=1", "unknown key \"densty\" in [[material]]; the nearest key is \"density\""},
      {"material.density=1", "say which [[material]]: material.0.density=... or material.NAME.density=..."},
      {"pair.glass-brass.restitution=1", "there is no [[pair]] \"glass-brass\"; the nearest is \"glass-glass\""},
      {"particles.1.count=1", "there is no [[particles]] \"1\"; the deck has 1, counted from 0"},
      {"gravity=[0,0", "\"gravity\" must be [x, y, z], not the text \"[0,0\""},
      {"gravity=[0,0,\"9.81\"]",
       "\"gravity.2\": \"9.81\" has no unit; write an acceleration with one of the units m/s2, cm/s2, mm/s2"},
      {"wall.gate.material=stel", "unknown material \"stel\"; the nearest is \"steel\""},
      {"phase.flow.remove_walls=[\"tube\", \"gat\"]", "unknown wall \"gat\"; the nearest is \"gate\""},
      {"output=5", "\"output\" is the number 5; it must be the section [output]"},
      {"guards.max_overlap=0.6", "\"max_overlap\" = 0.6 is out of range; it must be 0 < x <= 0.5"},
      {"guards.max_overlap=1\nstep=2", "\"max_overlap\" must be a number, not the text \"1\nstep=2\""},
  };
  for (const Bad& c : cases) {
    const std::string message = std::string("--set ") + c.set_text + ": " + c.message;
    EXPECT_EQ(message_of(example_deck, {c.set_text}), one_line(message));
  }
}

TEST(DeckErrors, AMessageIsOneLineWhateverItQuotes) {
  EXPECT_EQ(
      message_of("\"a\\nb\\u001B[2J\" = 1\n" + example_deck).find("deck.toml:1:1: unknown key \"a?b?[2J\" in the deck"),
      0U);
}

// toml++ makes a table of each part of a key and takes them apart by recursion: 200000 of them end the process.
TEST(DeckErrors, AKeyOfManyPartsIsRefusedUnread) {
  std::string key = "a";
  for (int i = 0; i < 200000; ++i) key += ".a";
  const std::string message = "deck.toml: a key has more than 20 parts";
  EXPECT_EQ(message_of(key + " = 1\n"), message);
  EXPECT_EQ(message_of("[" + key + "]\n"), message);
  EXPECT_EQ(message_of("a = {b = \"\"\"x\"\"\"\", " + key + " = 1}\n"), message);
  EXPECT_EQ(message_of("a = 'b\\'\n" + key + " = 1\n"), message);
  EXPECT_NE(message_of(example_deck, {key + "=1"}).find(": a key has more than 20 parts"), std::string::npos);
  EXPECT_NE(message_of(example_deck, {"run.title={" + key + "=1}"}).find("more than 20 parts"), std::string::npos);
}

TEST(DeckErrors, ManyDotsElsewhereAreNoKey) {
  const std::string dots(100, '.');
  const std::string title = "# " + dots + "\n[run]\ntitle = \"\"\"\\\"\"\"" + dots + "\n" + dots + "\"\"\"\n";
  EXPECT_EQ(message_of(title + example_deck), "no error");
  EXPECT_EQ(message_of(example_deck, {"run.title='" + dots + "'"}), "no error");
}

TEST(DeckErrors, AnOverrideIsUtf8) {
  EXPECT_EQ(message_of(example_deck, {"run.title=Grie\xC3\x9F"}), "no error");
  EXPECT_EQ(message_of(example_deck, {"run.title=Grie\xDF"}), "--set run.title=Grie\xDF: write it in UTF-8");
}

TEST(DeckErrors, AnOverrideOfAStudyHasTheLineOfTheStudy) {
  const std::string study = "# pair.0.friktion\n[[parameter]]\nkey = \"pair.0.friktion\"\n";
  const std::vector<std::string> overrides = {"time.step=0", "pair.0.friktion=0.2", "time.step"};
  const auto told = [&](const std::string& message, const std::string& text) {
    return told_of_file(message, overrides, "study.toml", text);
  };
  EXPECT_EQ(told("--set pair.0.friktion=0.2: unknown key", study), "study.toml:3: pair.0.friktion=0.2: unknown key");
  EXPECT_EQ(told("--set time.step: write key=value", study + "set = [\"time.step\"]\n"),
            "study.toml:4: time.step: write key=value");
  EXPECT_EQ(told("--set time.step=0: out of range", "set = [\"time.step=1\",\n\"time.step=0\"]"),
            "study.toml:2: time.step=0: out of range");
  for (const std::string message : {"--set time.step=0: out of range", "--set pair.0.friktion=0.3: of the command line",
                                    "deck.toml:3: pair.0.friktion=0.2"}) {
    EXPECT_EQ(told(message, study), message);
  }
}

TEST(DeckErrors, AnOverrideHasOnePathHoweverItNamesASection) {
  const toml::table deck = parse_toml(example_deck, "deck.toml");
  const auto paths = [&](const std::vector<std::string>& overrides) { return override_paths(deck, overrides); };
  EXPECT_EQ(
      paths({"pair.1.restitution=0.5", "pair.glass-steel.restitution=0.5", "pair.01.restitution=0.5", " run . seed=3"}),
      (std::vector<std::string>{"pair.1.restitution", "pair.1.restitution", "pair.1.restitution", "run.seed"}));
}

TEST(DeckErrors, AnOverrideThatOpensASectionOwesItsKeys) {
  std::string deck = with("[measurement.discharge]\norifice_height = 0\n\n", "");
  EXPECT_EQ(message_of(deck, {"measurement.discharge.plugged_share=0.1"}),
            "--set measurement.discharge.plugged_share=0.1: [measurement.discharge] lacks \"orifice_height\" (z of the "
            "orifice; particles with their centre below it are discharged)");
}

TEST(DeckErrors, HeatAndWhatItNeeds) {
  const auto says = [](const std::vector<std::string>& overrides, const std::string& words) {
    EXPECT_NE(message_of(example_deck, overrides).find(words), std::string::npos)
        << message_of(example_deck, overrides);
  };
  says({"heat.every=1"}, "\"conductivity\" is missing; [heat] needs it");
  says({"particles.0.temperature=300"}, "there is no [heat], without which nothing has a temperature");
  says({"phase.1.mechanics=false"}, "there is no [heat]");
  std::vector<std::string> hot = {"heat.every=1"};
  for (const char* material : {"material.0", "material.1"}) {
    hot.push_back(std::string(material) + ".conductivity=2");
    hot.push_back(std::string(material) + ".specific_heat=800");
  }
  EXPECT_EQ(message_of(example_deck, hot), "no error");
  std::vector<std::string> growing = hot;
  growing.insert(growing.end(), {"phase.1.growth.factor=1.001", "phase.1.growth.every=40"});
  EXPECT_EQ(message_of(example_deck, growing), "no error");
  growing.push_back("phase.1.mechanics=false");
  says(growing, "nothing grows in a phase without mechanics");
  says({"phase.1.growth.every=40"}, "[phase.growth] lacks \"factor\"");
  const auto with_hot = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = hot;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  says(with_hot({"heat.radiation=true"}), "\"emissivity\" is missing; heat.radiation needs it");
  says(with_hot({"wall.0.heat={type='temperature', temperature=500, times=[0, 1], factors=[1]}"}),
       "1 values for 2 times; give one each");
  says(with_hot({"wall.0.heat={type='temperature', temperature=500, times=[1, 0], factors=[1, 1]}"}),
       "\"times\" must rise");
  says(with_hot({"material.0.heat_table={temperatures=[300], conductivities=[1], specific_heats=[800]}"}),
       "which it replaces; keep one");
  const auto box = [](const std::string& rest) { return "phase.1.heat=[{min=[0, 0, 0], max=[1, 1, 1]" + rest + "}]"; };
  says({box(", power=1")}, "there is no [heat]");
  says(with_hot({box("")}), "neither \"temperature\" nor \"power\" is given; give one");
  says(with_hot({"phase.1.heat=[{min=[0, 0, 0], max=[1, 0, 1], power=1}]"}),
       "\"max\" must be greater than \"min\" in x, y and z");
  EXPECT_EQ(message_of(example_deck, with_hot({box(", power=1, temperature=400")})), "no error");
}

TEST(DeckErrors, WallsThatMoveWithOthers) {
  const auto says = [&](const std::vector<std::string>& overrides, const std::string& words) {
    EXPECT_NE(message_of(example_deck, overrides).find(words), std::string::npos)
        << message_of(example_deck, overrides);
  };
  const std::string motion = "=[{type='translation', velocity=[0,0,1]}]";
  const std::vector<std::string> gate_with_floor = {"wall.0.motion" + motion, "wall.2.moves_with='floor'"};
  const auto and_also = [&](const std::string& more) {
    std::vector<std::string> all = gate_with_floor;
    all.push_back(more);
    return all;
  };
  EXPECT_EQ(message_of(example_deck, gate_with_floor), "no error");
  says({"wall.2.moves_with='flor'"}, "unknown wall \"flor\"; the nearest is \"floor\"");
  says({"wall.2.moves_with='gate'"}, "wall \"gate\" cannot move with itself; name the wall that moves it");
  says(and_also("wall.1.moves_with='gate'"), "wall \"gate\" moves with \"floor\" itself; name that one");
  says(and_also("wall.2.motion" + motion), "has no [[wall.motion]] of its own; remove one of the two");
  says(and_also("wall.2.servo={direction=[0,0,1], force=1, max_speed=0.1, max_way=1}"),
       "has no [wall.servo] of its own; remove one of the two");
  // The gate, which a phase adds, takes the tube along.
  const std::vector<std::string> tube_with_gate = {"wall.2.motion" + motion, "wall.1.moves_with='gate'",
                                                   "wall.1.present=false"};
  for (const char* const removed : {"['tube']", "['gate', 'tube']"}) {
    std::vector<std::string> all = tube_with_gate;
    all.push_back(std::string("phase.flow.remove_walls=") + removed);
    EXPECT_EQ(message_of(example_deck, all), "no error") << removed;
  }
}

TEST(DeckErrors, ServosThatTurnAndPhasesThatWaitForTorques) {
  const std::string start = "wall.0.servo={type='rotation', torque='2 mN m', max_angular_velocity='30 rpm', ";
  const auto says = [&](const std::vector<std::string>& overrides, const std::string& words) {
    EXPECT_NE(message_of(example_deck, overrides).find(words), std::string::npos)
        << message_of(example_deck, overrides);
  };
  EXPECT_EQ(message_of(example_deck, {start + "max_angle=90}"}), "no error");
  says({"wall.0.servo={type='rotation', torque=1, max_angular_velocity=1}"}, "[wall.servo] lacks \"max_angle\"");
  says({start + "max_angle=90, force=1}"}, "\"force\" of [wall.servo] is only allowed with type = translation");
  says({start + "max_angle=0}"}, "\"max_angle\" and \"min_angle\" are both 0: the wall could not turn");
  says({start + "max_angle=90, min_angle=1}"}, "min_angle");
  says({start + "max_angle=90, axis_direction=[0,0,0]}"}, "\"axis_direction\" has length zero");
  const std::string along_x = start + "max_angle=90, axis_direction=[1,0,0]}";
  says({along_x, "domain.periodic=['y']"}, "\"axis_direction\" is not along the periodic direction y of the [domain]");
  const auto waiting = [&](const std::string& keys) {
    return message_of(
        with("until = \"time\"\ntime = 1\n", "until = \"wall_torque\"\nmax_time = 1\ntorque = 1\n" + keys));
  };
  EXPECT_EQ(waiting("wall = \"floor\"\n"), "no error");
  EXPECT_NE(waiting("wall = \"flor\"\n").find("unknown wall \"flor\"; the nearest is \"floor\""), std::string::npos);
  EXPECT_NE(waiting("wall = \"floor\"\naxis_direction = [0, 0, 0]\n").find("\"axis_direction\" has length zero"),
            std::string::npos);
  EXPECT_NE(waiting("").find("\"wall\""), std::string::npos);
}

TEST(DeckErrors, ServosAndPhasesThatWaitForThem) {
  const std::string start = "wall.0.servo={direction=[0,0,-1], force='20 mN', max_speed=0.1, max_way=";
  const auto says = [&](const std::vector<std::string>& overrides, const std::string& words) {
    EXPECT_NE(message_of(example_deck, overrides).find(words), std::string::npos)
        << message_of(example_deck, overrides);
  };
  EXPECT_EQ(message_of(example_deck, {start + "0.01}"}), "no error");
  says({"wall.0.servo={direction=[0,0,0], force=1, max_speed=0.1, max_way=1}"}, "it needs a direction");
  says({"wall.0.servo={direction=[0,0,1], force=1, max_speed=0.1}"}, "[wall.servo] lacks \"max_way\"");
  says({start + "0}"}, "are both 0: the wall could not move");
  says({start + "0.01, min_way=0.001}"}, "min_way");
  says({start + "0.01, times=[0, 1]}"}, "\"factors\"");
  says({start + "0.01, times=[0, 1], factors=[1]}"}, "1 values for 2 times; give one each");
  says({start + "0.01, times=[1, 0], factors=[1, 1]}"}, "\"times\" must rise");
  says({start + "0.01, phases=['setle']}"}, "unknown phase \"setle\"; the nearest is \"settle\"");
  says({"wall.0.servo={direction=[0,1,-1], force=1, max_speed=0.1, max_way=1}", "domain.periodic=['y']"},
       "leads along the periodic direction y of the [domain]");
  const auto waiting = [&](const std::string& keys) { return with("until = \"time\"\ntime = 1\n", keys); };
  EXPECT_NE(
      message_of(waiting("until = \"servo\"\nmax_time = 1\n")).find("needs a [wall.servo] that acts in this phase"),
      std::string::npos);
  EXPECT_EQ(message_of(waiting("until = \"servo\"\nmax_time = 1\n"), {start + "0.01, phases=['flow']}"}), "no error");
  EXPECT_NE(message_of(waiting("until = \"servo\"\n")).find("\"max_time\""), std::string::npos);
  EXPECT_NE(message_of(waiting("until = \"wall_force\"\nwall = \"flor\"\nforce = 1\nmax_time = 1\n"))
                .find("unknown wall \"flor\"; the nearest is \"floor\""),
            std::string::npos);
}

TEST(DeckErrors, ShearCellsAndBedsUnderLids) {
  const auto says = [](const std::vector<std::string>& overrides, const std::string& words) {
    EXPECT_NE(message_of(example_deck, overrides).find(words), std::string::npos)
        << message_of(example_deck, overrides);
  };
  const auto cell = [](const std::string& keys) {
    return std::vector<std::string>{"measurement.shear={plane_height=0, phase='flow', " + keys + "}"};
  };
  const std::string box = "walls=['floor'], area='1 cm2', direction=";
  EXPECT_EQ(message_of(example_deck, cell(box + "[0,1,0]")), "no error");
  EXPECT_EQ(message_of(example_deck, cell("walls=['floor'], type='rotation', outer_radius=0.1")), "no error");
  says(cell(box + "[0,1,1]"), "is not horizontal");
  says(cell(box + "[0,0,0]"), "it needs a direction");
  says(cell("walls=['flor'], area=1, direction=[1,0,0]"), "unknown wall \"flor\"; the nearest is \"floor\"");
  says(cell("walls=[], area=1, direction=[1,0,0]"), "names none");
  says(cell("walls=['floor'], area=1, direction=[1,0,0], inner_radius=1"), "only allowed with type = rotation");
  says(cell("walls=['floor'], type='rotation', outer_radius=0.1, inner_radius=0.1"), "must be greater than");
  says({"measurement.shear={walls=['floor'], area=1, direction=[1,0,0], plane_height=0, phase='flw'}"},
       "unknown phase \"flw\"; the nearest is \"flow\"");
  const std::string lid = "wall.0.servo={direction=[0,0,-1], force=1, max_speed=0.1, max_way=0.05}";
  const auto bed = [](const std::string& phases) {
    return "measurement.compression={lid='floor', area='1 cm2', height=0.1, " + phases + "}";
  };
  EXPECT_EQ(message_of(example_deck, {lid, bed("load_phase='settle', unload_phase='flow'")}), "no error");
  says({bed("load_phase='settle', unload_phase='flow'")}, "wall \"floor\" has no [wall.servo] that presses");
  says({lid, bed("load_phase='settle', unload_phase='flw'")}, "unknown phase \"flw\"");
  says({lid, bed("load_phase='flow', unload_phase='settle'")},
       "phase \"settle\" does not come after \"load_phase\" = \"flow\"");
  says({lid, bed("load_phase='flow', unload_phase='flow'")}, "phase \"flow\" does not come after");
}

TEST(DeckErrors, FlowEnergyNeedsWallsThatMove) {
  const auto message = [](const std::string& walls, const std::string& phase,
                          const std::vector<std::string>& overrides = {}) {
    return message_of(
        std::string(example_deck) + "[measurement.flow_energy]\nwalls = " + walls + "\nphase = \"" + phase + "\"\n",
        overrides);
  };
  const std::string turns = "wall.1.motion=[{type='rotation', angular_velocity=1}]";
  EXPECT_EQ(message("[\"tube\"]", "flow", {turns}), "no error");
  EXPECT_EQ(message("[\"tube\"]", "flow"), "deck.toml:82:10: wall \"tube\" has no [[wall.motion]]: it does no work");
  EXPECT_EQ(message("[\"tub\"]", "flow"), "deck.toml:82:10: unknown wall \"tub\"; the nearest is \"tube\"");
  EXPECT_EQ(message("[]", "flow"), "deck.toml:82:9: \"walls\" names none; name those of the blade");
  EXPECT_EQ(message("[\"tube\"]", "flo", {turns}), "deck.toml:81:1: unknown phase \"flo\"; the nearest is \"flow\"");
  EXPECT_EQ(message("[\"tube\"]", "flow", {"wall.1.motion=[{type='conveyor', velocity=[1, 0, 0]}]"}),
            "deck.toml:82:10: wall \"tube\" is a conveyor, whose work is not measured; name walls that move "
            "themselves");
  const std::string both = "[\"tube\", \"gate\"]";
  EXPECT_EQ(message(both, "flow", {turns, "wall.2.motion=[{type='rotation', angular_velocity=1}]"}), "no error");
  EXPECT_EQ(message(both, "flow", {turns, "wall.2.moves_with=tube"}), "no error");
  EXPECT_EQ(message(both, "flow", {turns, "wall.2.motion=[{type='rotation', angular_velocity=2}]"}),
            "deck.toml:82:18: wall \"gate\" does not move as \"tube\" does; a blade is one body: let it move with that "
            "one (\"moves_with\")");
}

TEST(DeckErrors, TiltingBox) {
  const std::string deck = with("until = \"time\"\ntime = 1\n", "until = \"tilt_onset\"\nmax_time = 1\n") +
                           "[tilt]\nangular_velocity = 1\naxis_direction = [0, -2, 0]\n";
  const std::string surface = "[measurement.surface_angle]\nradius = 0.02\n";
  EXPECT_EQ(message_of(deck + surface), "no error");
  EXPECT_EQ(message_of(deck),
            "deck.toml:72:9: \"until\" = tilt_onset needs [measurement.tilt_onset], or a [tilt] and "
            "[measurement.surface_angle]");
  EXPECT_EQ(message_of(deck + surface + "axis_direction = [1, 0, 0]\n"),
            "deck.toml:86:18: is not along the axis of the [tilt], about which the slope of the bed changes");
}

}  // namespace
}  // namespace repose
