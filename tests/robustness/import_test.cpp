// Scripts that are damaged at random: each is imported or refused in one line that says where, and nothing crashes.
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "import/import_script.h"
#include "unit/import_samples.h"

namespace repose {
namespace {

constexpr int damaged_scripts = 500;

/// Much of what scripts are made of.
const std::string whole =
    std::string(
        "variable r equal 0.004\nvariable k loop 2\nif \"${r} > 0\" then \"variable y equal 5e6\" else \"quit\"\n"
        "fix k all property/global thermalConductivity peratomtype 100\n"
        "fix c all property/global thermalCapacity peratomtype 10\n"
        "fix heat all heat/gran initial_temperature 300\n") +
    test::falling +
    "include more\nlabel again\nrun 10\nnext k\njump SELF again\n"
    "fix cad all mesh/surface file face.stl type 1 scale 0.1 rotate axis 1 0 0 angle 90 move 0 0 0.1 surface_vel 0.1 0 "
    "0 temperature 350\n"
    "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"
    "fix m all move/mesh mesh cad wiggle amplitude 0 0 0.001 period 0.1\nrun 10\nunfix m\n"
    "fix in all mesh/surface/planar file face.stl type 1 scale 0.1\n"
    "fix ins2 all insert/stream seed 10091 distributiontemplate d nparticles 20 massrate 0.1 vel constant 0 0 -1 &\n"
    "  insertion_face in extrude_length 0.02\nset region fill property/atom Temp 800\n"
    "set group all property/atom heatSource 0.1\nrun 20\ndump d all custom 100 f id x y z\nthermo 100\n";

const std::string more =
    "create_atoms 1 single 0.08 0.08 0.05\nset atom 1 diameter 0.008 density 2000\ngroup g id 1\nfix f g freeze\n";

const std::vector<std::string> odd_words = {"",       "nan",        "1e999", "-1",   "0",      "1e300",    "INF",
                                            "${",     "$(",         "\"",    "&",    "#",      "all",      "type",
                                            "mesh",   "fix",        "run",   "v_r",  "$k",     "\xff\x01", "1e-300",
                                            "$(1/0)", "2147483648", "0x10",  "upto", "region", "vector",   "EDGE"};

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string to(std::string text) {
    const std::size_t wounds = 1 + below(3);
    for (std::size_t k = 0; k < wounds && !text.empty(); ++k) wound(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  void wound(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(8));
        break;
      case 2:
        text.resize(at);
        break;
      case 3: {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end == std::string::npos ? end : end - at + 1);
        text.insert(below(text.size()), line);
        break;
      }
      default: {  // another word
        const std::size_t begin = text.find_first_of(" \n", at);
        if (begin == std::string::npos) break;
        const std::size_t end = std::min(text.find_first_of(" \n", begin + 1), text.size());
        text.replace(begin + 1, end - begin - 1, odd_words[below(odd_words.size())]);
      }
    }
  }

  std::mt19937 random_;
};

TEST(DamagedScripts, AreImportedOrRefusedInOneLine) {
  // The line of the script or of a file that it names; or, of a whole that fits no deck, the script; or a file.
  const std::regex says_where(
      R"(^((in\.x|more)(:\d+: |: as a deck it is refused: |: includes itself).*|.+: cannot open)$)");
  int refused = 0;
  std::map<std::string, std::string> files = {{"face.stl", test::triangle_stl}, {"more", more}};
  files["in.x"] = whole;
  ASSERT_NO_THROW(import_script("in.x", test::reader_of(files), {}, ""));
  for (int k = 0; k < damaged_scripts; ++k) {
    Damage damage(static_cast<unsigned>(k));
    files["in.x"] = k % 10 == 9 ? whole : damage.to(whole);
    files["more"] = k % 10 == 9 ? damage.to(more) : more;
    try {
      import_script("in.x", test::reader_of(files), {}, "");
    } catch (const Error& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      EXPECT_TRUE(std::regex_search(said, says_where)) << k << ": " << said;
      EXPECT_LT(said.size(), 2000U) << said;
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << k << ": " << error.what() << "\n" << files["in.x"];
    }
  }
  EXPECT_GT(refused, damaged_scripts / 3);
  EXPECT_LT(refused, damaged_scripts);
}

}  // namespace
}  // namespace repose
