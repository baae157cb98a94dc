// A script of LIGGGHTS up to the scene that it describes, and the same bytes as a data file and as a dump.
#include <cmath>

#include "import/grain_list.h"
#include "import/script.h"
#include "import/translate.h"
#include "target.h"

namespace repose::fuzz {

namespace {

void check_grains(const GrainList& list) {
  for (const Grain& grain : list.grains) {
    expect(grain.radius > 0.0 && std::isfinite(grain.radius), "a radius is positive");
    expect(grain.density >= 0.0 && std::isfinite(grain.density), "a density is finite");
    expect(std::isfinite(norm(grain.position)) || norm(grain.position) > 1e150, "a position is finite");
  }
}

}  // namespace

bool accepts(std::string_view input) {
  const std::string text(input);
  const ReadFile read_file = [&](const std::string&) { return text; };
  const std::string no_dump;
  Translation to(read_file, no_dump);
  bool accepted = is_done([&] {
    constexpr std::size_t most_commands = 1000;  // those that only jump count too
    read_script(
        "in.x", read_file, {}, [&](const ScriptCommand& command) { translate(to, command); }, most_commands);
  });
  for (const auto parse : {parse_data_file, parse_dump}) {
    accepted = is_done([&] { check_grains(parse(text, "grains", cgs_units)); }) || accepted;
  }
  return accepted;
}

}  // namespace repose::fuzz
