// Files of the thermal tools: a transient, or repeated measurements, and the deck of either.
#include <cmath>

#include "target.h"
#include "thermal/tools/compare_tool.h"
#include "thermal/tools/tps_tool.h"

namespace repose::fuzz {
namespace {

const char* const tps_deck =
    "[sensor]\ntype = \"disc\"\nradius = 0.0065\nresistance = 10.0\nresistance_coefficient = 0.005\n"
    "[evaluation]\npower = 1.0\nleave_out_first = 2\n[criteria]\navailable_depth = 0.02\n";

const char* const compare_deck = "[[figure]]\ncolumn = \"mass\"\nbound = 0.2\n";

void expect_finite(const thermal::Json& value) {
  if (value.is_number_float()) expect(std::isfinite(value.get<double>()), "a figure is finite");
  if (value.is_structured())
    for (const thermal::Json& inner : value) expect_finite(inner);
}

/// After a line with "--file" comes the file; before it the deck, or the name of one that is given.
bool runs(std::string_view input, thermal::ToolResult (*tool)(const thermal::ToolInput&), const char* given) {
  const std::size_t cut = input.find("--file\n");
  if (cut == std::string_view::npos) return false;
  const std::string deck = cut == 0 ? given : std::string(input.substr(0, cut));
  const thermal::DataFile file{"file.csv", std::string(input.substr(cut + 7))};
  thermal::ToolResult result;
  if (!is_done([&] { result = tool({{"deck.toml", deck}, {}, {file, file}}); })) return false;
  if (cut == 0) expect_finite(result.json);
  return true;
}

}  // namespace

bool accepts(std::string_view input) {
  const bool is_transient = runs(input, thermal::tps_tool, tps_deck);
  const bool is_comparison = runs(input, thermal::compare_tool, compare_deck);
  return is_transient || is_comparison;
}

}  // namespace repose::fuzz
