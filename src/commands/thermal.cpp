#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"
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

/// A figure that is none: what the deck or the files say is too far from anything physical for the formulas.
void check_finite(const Json& value, const std::string& name, const std::string& deck) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw DeckError(fmt::format("{}: {} would be {}: a figure of the input is too large or too small", deck, name,
                                value.get<double>()));
  }
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) check_finite(inner, name.empty() ? key : name + "." + key, deck);
}

/// What data a tool takes beside its deck.
enum class Data { none, beds, tables, two_tables };

/// Where what a tool finds goes.
enum class Result { text, tables };

/// One of the thermal tools (thermal/tools): it takes data and its deck as an option, like measure, or no data and its
/// deck as the argument.
class ThermalTool : public Command {
 public:
  using Tool = thermal::ToolResult (*)(const thermal::ToolInput& input);
  ThermalTool(std::string name, Data data, Tool tool, Result result)
      : name_(std::move(name)), data_(data), tool_(tool), result_(result) {}

  void declare(Options& options) override {
    if (data_ == Data::tables) options.arguments("FILE", files_, "data (CSV); several are allowed");
    if (data_ == Data::beds) options.arguments("FILE", files_, "snapshots (.hdf) or lists (CSV); several are allowed");
    if (data_ == Data::two_tables) options.arguments("FILES", files_, "two files (CSV)", 2, "A B");
    if (data_ == Data::none) {
      options.argument("DECK", deck_, "deck (TOML)");
    } else {
      options.option("--deck", deck_, "DECK", "deck (TOML)", Options::Need::must);
    }
    declare_overrides(options, overrides_);
    if (result_ == Result::tables) {
      options.option("--output", output_, "DIR", "directory of the tables and the JSON result", Options::Need::must);
    } else {
      options.option("--output", output_, "DIR", "directory of the JSON result");
    }
  }

  void carry_out(Process& process) override {
    std::string text;
    agree_after_root(process.ranks(), [&] {
      thermal::ToolInput input{{deck_, read_whole_file(deck_)}, overrides_, {}};
      for (const std::string& file : files_) input.files.push_back({file, read_whole_file(file)});
      const thermal::ToolResult result = tool_(input);
      check_finite(result.json, "", deck_);
      text = result.text;
      if (!output_.empty()) write(result);
    });
    process.say(text);
  }

 private:
  /// The tables first: the JSON appears when everything is there.
  void write(const thermal::ToolResult& result) const {
    create_output_directory(output_);
    for (const thermal::DataFile& table : result.tables) {
      write_text_file(fmt::format("{}/{}", output_, table.name), table.bytes);
    }
    Json json = result.json;
    json["deck"] = {{"file", deck_}, {"set", overrides_}, {"text", read_whole_file(deck_)}};
    json["build"] = json_of(build_info(""));
    write_text_file(fmt::format("{}/{}.json", output_, name_), json_text(json));
  }

  std::string name_;
  Data data_;
  Tool tool_;
  Result result_;
  std::string deck_;
  std::vector<std::string> overrides_;
  std::vector<std::string> files_;
  std::string output_;
};

std::unique_ptr<Command> tool(const char* name, Data data, ThermalTool::Tool run, Result result = Result::text) {
  return std::make_unique<ThermalTool>(name, data, run, result);
}

}  // namespace

std::unique_ptr<Command> thermal_bed_command() { return tool("bed", Data::none, thermal::bed_tool); }
std::unique_ptr<Command> thermal_network_command() { return tool("network", Data::beds, thermal::network_tool); }
std::unique_ptr<Command> thermal_tps_command() { return tool("tps", Data::tables, thermal::tps_tool); }
std::unique_ptr<Command> thermal_synthesise_command() {
  return tool("synthesise", Data::none, thermal::synthesise_tool, Result::tables);
}
std::unique_ptr<Command> thermal_sensor_command() { return tool("sensor", Data::none, thermal::sensor_tool); }
std::unique_ptr<Command> thermal_mixture_command() { return tool("mixture", Data::none, thermal::mixture_tool); }
std::unique_ptr<Command> compare_command() { return tool("compare", Data::two_tables, thermal::compare_tool); }

}  // namespace repose
