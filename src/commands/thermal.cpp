#include "commands/thermal.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/json_text.h"
#include "files/shared_file.h"
#include "output/build_info.h"
#include "thermal/tools/bed_tool.h"
#include "thermal/tools/compare_tool.h"
#include "thermal/tools/mixture_tool.h"
#include "thermal/tools/network_tool.h"
#include "thermal/tools/sensor_tool.h"
#include "thermal/tools/tps_tool.h"

namespace repose {
namespace {

using thermal::Json;

struct Tool {
  std::string_view name;
  thermal::ToolResult (*run)(const thermal::ToolInput& input);
};

constexpr Tool tools[] = {{"bed", thermal::bed_tool},         {"compare", thermal::compare_tool},
                          {"mixture", thermal::mixture_tool}, {"network", thermal::network_tool},
                          {"sensor", thermal::sensor_tool},   {"synthesise", thermal::synthesise_tool},
                          {"tps", thermal::tps_tool}};

/// A figure that is none: what the deck or the files say is too far from anything physical for the formulas.
void check_finite(const Json& value, const std::string& name, const std::string& deck) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw DeckError(fmt::format("{}: {} would be {}: a figure of the input is too large or too small", deck, name,
                                value.get<double>()));
  }
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) check_finite(inner, name.empty() ? key : name + "." + key, deck);
}

thermal::ToolResult result_of(const ThermalRequest& request) {
  thermal::ToolInput input{{request.deck, read_whole_file(request.deck)}, request.overrides, {}};
  for (const std::string& file : request.files) input.files.push_back({file, read_whole_file(file)});
  for (const Tool& tool : tools) {
    if (tool.name != request.tool) continue;
    thermal::ToolResult result = tool.run(input);
    check_finite(result.json, "", request.deck);
    return result;
  }
  throw DeckError(fmt::format("there is no thermal tool \"{}\"", request.tool));
}

/// The tables first: the JSON appears when everything is there.
void write(const ThermalRequest& request, const thermal::ToolResult& result) {
  create_output_directory(request.output);
  for (const thermal::DataFile& table : result.tables)
    write_text_file(fmt::format("{}/{}", request.output, table.name), table.bytes);
  Json json = result.json;
  json["deck"] = {{"file", request.deck}, {"set", request.overrides}, {"text", read_whole_file(request.deck)}};
  json["build"] = json_of(build_info(""));
  write_text_file(fmt::format("{}/{}.json", request.output, request.tool), json_text(json));
}

}  // namespace

std::string run_thermal_tool(const Communicator& comm, const ThermalRequest& request) {
  std::string text;
  agree_after_root(comm, [&] {
    const thermal::ToolResult result = result_of(request);
    text = result.text;
    if (!request.output.empty()) write(request, result);
  });
  return text;
}

}  // namespace repose
