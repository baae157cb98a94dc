// Writes what the fuzzers begin with: fuzz_seeds INPUT_FOLDER FOLDER makes FOLDER/TARGET/* and the dictionary
// FOLDER/deck.dict.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

#include "deck/resolved_deck.h"
#include "support/input_decks.h"
#include "support/meshes.h"
#include "unit/import_samples.h"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Into an empty folder: a seed of an earlier build must not stay.
class Seeds {
 public:
  explicit Seeds(fs::path folder) : folder_(std::move(folder)) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void add(const std::string& name, const std::string& input) const {
    std::ofstream(folder_ / name, std::ios::binary) << input;
  }

 private:
  fs::path folder_;
};

void add_decks(const fs::path& input, const Seeds& seeds) {
  for (const auto& entry : fs::directory_iterator(input)) {
    if (repose::test::is_deck_of_a_run(entry.path())) seeds.add(entry.path().filename(), text_of(entry.path()));
  }
  seeds.add("overrides", text_of(input / "discharge_quick.toml") +
                             "\n--set particles.0.mass=0.05 g\n--set phase.settle.max_time=0.3\n--set run.title=a");
}

/// The files of input/ whose names begin so.
void add_inputs(const fs::path& input, const std::string& begin, const Seeds& seeds) {
  for (const auto& entry : fs::directory_iterator(input)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin)) seeds.add(name, text_of(entry.path()));
  }
}

void add_studies(const fs::path& input, const Seeds& seeds) {
  add_inputs(input, "calibrate_", seeds);
  add_inputs(input, "sensitivity_", seeds);
  seeds.add("search",
            "base = \"a\"\n[[parameter]]\nname = \"a\"\nkey = \"pair.0.restitution\"\nmin = 0\nmax = 1\n"
            "[[observable]]\nfigure = \"pile_height_m\"\nlaboratory = 1\ndeviation = 1\nscale = \"logarithm\"\n"
            "[[level]]\nname = \"small\"\nset = [\"time.step=1e-6\"]\n[[level]]\nname = \"large\"\n"
            "[[point]]\nvalues = [0.5]\nlevel = \"large\"\n"
            "[adaptive]\nstart = 5\nbatch = 2\nbudget = 11\nhalf_width = 0.1\n");
  seeds.add(
      "list",
      "base = \"a\"\n[[parameter]]\nname = \"a\"\nkey = \"time.step\"\nmin = 0\nmax = 1\n[[point]]\nvalues = [0.5]\n"
      "[[observable]]\nfigure = \"pile_height_m\"\nlaboratory = 1\ndeviation = 1\n");
}

void add_particle_lists(const Seeds& seeds) {
  seeds.add("full",
            "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n1,2,3,4,5,6,7,8,9,0.5,steel\n-1e-3,+2,0,0,0,0,0,0,0,0.1,glass\n");
  seeds.add("short", "\xEF\xBB\xBF# grains\r\nx, y, z, radius, material\r\n\r\n0,0,1e-3,2.2e-4,glass\r\n");
}

void add_size_analyses(const Seeds& seeds) {
  seeds.add("cumulative", "diameter_um,cumulative_mass\n200,0\n400,40\n700,100\n");
  seeds.add("differential", "# laser\n\"diameter_mm\", share_number\n0.2,0\n0.4,2\n0.7,3\n");
}

void add_meshes(const Seeds& seeds) {
  const auto body = repose::test::box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  seeds.add("ascii", repose::test::ascii_stl(body));
  seeds.add("binary", repose::test::binary_stl(body));
}

void add_scripts(const Seeds& seeds) {
  seeds.add("script",
            repose::test::falling +
                "variable i loop 2\nlabel l\nif \"$i > 1\" then \"run $(2*v_i)\" else \"run 1\"\nnext i\njump SELF "
                "l\ngroup g type 1\nset group g diameter 0.1\ndelete_atoms group g\nunfix ins\n");
  seeds.add("walls",
            "units cgs\nfix m all mesh/surface file a.stl type 1 scale 2 rotate axis 0 1 0 angle 9 move 1 2 3 "
            "surface_vel 1 0 "
            "0\nfix v all move/mesh mesh m rotate origin 0 0 0 axis 0 0 1 period 2\nfix w all wall/gran model hooke "
            "tangential no_history rolling_friction cdt mesh n_meshes 1 meshes m\n");
  seeds.add("data",
            "grains\n\n1 atoms\n1 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n1 1 0.1 2500 0.5 0.5 "
            "0.5\n\nVelocities\n\n1 0 0 1 0 0 0\n");
  seeds.add(
      "dump",
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id type "
      "xs ys zs radius mass vx vy vz\n1 1 0.5 0.5 0.5 0.1 0.01 0 0 1\n");
}

void add_snapshots(const Seeds& seeds) {
  const std::string vectors =
      "/particles/position f64 2x3 = 0.1 0 -1e-3 1 2 3\n/particles/velocity f64 2x3 = 0 0 0 0 0 -1\n"
      "/particles/angular_velocity f64 2x3 = 0 0 0 1 0 0\n";
  seeds.add("plain", vectors +
                         "/particles/radius f64 2 = 1e-4 2e-4\n/particles/material i32 2 = 0 1\n"
                         "@materials text 2 = glass steel\n");
  seeds.add("deflated",
            "/particles/position f64 1x3 chunk 1 deflate = 0.1 0 -1e-3\n"
            "/particles/velocity f64 1x3 chunk 1 = 0 0 0\n/particles/angular_velocity f32 1x3 = 0 0 0\n"
            "/particles/radius f32 1 chunk 1 deflate = 1e-4\n/particles/material i64 1 = 0\n"
            "@materials text 1 = steel\n/particles/id i64 1 = 7\n/particles/mass f64 1 = 1e-6\n");
}

void add_checkpoints(const Seeds& seeds) {
  seeds.add("contacts",
            "@repose_checkpoint i64 = 1\n@step i64 = 700\n@time_s f64 = 0.01\n@state_hash text 1 = 0f\n"
            "@deck text 1 = x\n@build_version text 1 = 1\n@build_commit text 1 = c\n/state i8 2 = 123 125\n"
            "/particles/id i64 2 = 0 1\n/particles/material i32 2 = 0 0\n/particles/position f64 2x3 = 0 0 0 1 0 0\n"
            "/particles/velocity f64 2x3 = 0 0 0 1 0 0\n/particles/spin f64 2x3 = 0 0 0 1 0 0\n"
            "/particles/radius f64 2 = 0.5 0.5\n/particles/force_sum i64 2x3 = 1 2 3 -1 -2 -3\n"
            "/particles/torque_sum i64 2x3 = 0 0 0 0 0 0\n/particles/pair_contacts i64 2 = 1 1\n"
            "/particles/wall_contacts i64 2 = 0 1\n/pair_contacts/partner i64 2 = 1 0\n"
            "/pair_contacts/history f64 2x6 = 0 0 1 0 0 0 0 0 1 0 0 0\n/wall_contacts/wall i32 1 = 0\n"
            "/wall_contacts/feature i32 1 = 3\n/wall_contacts/history f64 1x6 = 0 0 0 0 0 1\n");
}

void add_states(const Seeds& seeds) {
  seeds.add("all",
            R"({"all": {"left": {"particles": [1, 0, 0, 0, 2, 0], "mass": [5, 0, 0, 0, 9, 0], "named_particles": [1],
"named_mass": [5]}, "discharge": {"samples": [{"time": 0.1, "mass": 2e-3}]}, "tilt_onset": {"start": [0, 0, 1e-3],
"material": 1, "cannot_turn": false, "bound": 1e-6, "last_tilt": 0.2, "last_way": 0.0, "onset": null},
"phases": [{"name": "fill", "steps": 100, "ended_by": "time"}],
"motions": [{"clocks": [{"steps": 7, "runs": true}, {"steps": 0, "runs": false}]}]}})");
}

void add_thermal_files(const Seeds& seeds) {
  std::string transient = "--file\ntime,temperature,power\n-2,0.001,0\n-1,0,0\n";
  std::string resistance = "--file\ntime,resistance\n";
  for (int i = 1; i < 40; ++i) {  // not far from that of a disc
    const double t = 0.125 * i;
    const double rise = 2.0 * std::sqrt(t) - 0.3 * t;
    transient += std::to_string(t) + "," + std::to_string(rise) + ",1.5\n";
    resistance += std::to_string(t) + "," + std::to_string(10.0 * (1.0 + 0.005 * rise)) + "\n";
  }
  seeds.add("transient", transient);
  seeds.add("resistance", resistance);
  seeds.add("repeats", "--file\nmass,angle\n21.9,32\n21.8,\n22,33\n");
  seeds.add("deck",
            "[[figure]]\ncolumn = \"a\"\nrelative_bound = 0.1\n[orifice]\ndiameter = \"5 mm\"\n"
            "expansion = \"1e-5 1/K\"\nhot = \"900 K\"\nsmallest_grain = \"0.2 mm\"\n--file\na\n1\n2\n");
}

/// Every word of `repose keys` that is a key, a section or a choice.
std::string dictionary() {
  std::set<std::string> words;
  std::string word;
  for (const char c : repose::deck_keys() + " ") {
    const bool is_part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (is_part) word += c;
    if (!is_part && word.size() > 2) words.insert(word);
    if (!is_part) word.clear();
  }
  std::string text;
  for (const std::string& w : words) text += "\"" + w + "\"\n";
  for (const char* more : {"1e308", "-1e-320", "9223372036854775807", "1000000000000", "nan", "inf", " mm",
                           "e99999999999 m", "rpm", "[[", "]]", "\\x0A--set "}) {
    text += std::string("\"") + more + "\"\n";
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const fs::path folder = argv[2];
  add_decks(argv[1], Seeds(folder / "deck"));
  add_inputs(argv[1], "validation", Seeds(folder / "validation"));
  add_studies(argv[1], Seeds(folder / "study"));
  add_particle_lists(Seeds(folder / "particle_csv"));
  add_size_analyses(Seeds(folder / "size_csv"));
  add_meshes(Seeds(folder / "stl"));
  add_scripts(Seeds(folder / "script"));
  add_snapshots(Seeds(folder / "snapshot"));
  add_checkpoints(Seeds(folder / "checkpoint"));
  add_states(Seeds(folder / "state"));
  add_thermal_files(Seeds(folder / "thermal"));
  std::ofstream(folder / "deck.dict") << dictionary();
  return 0;
}
