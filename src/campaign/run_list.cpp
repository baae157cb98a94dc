#include "campaign/run_list.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {
namespace {

StudyRun run_at(const StudyDeck& study, const std::vector<double>& values, std::int64_t seed) {
  StudyRun run{values, seed, "", study.set};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ParameterDeck& p = study.parameters[i];
    run.name += fmt::format("{}={},", p.name, values[i]);  // as short as gives the same number back
    run.overrides.push_back(fmt::format("{}={}", p.key, values[i]));
  }
  run.name += fmt::format("seed={}", seed);
  run.overrides.push_back(fmt::format("run.seed={}", seed));
  run.ranks = study.ranks_per_run;
  return run;
}

/// The number behind "name=", and `text` without both and the comma that follows. Empty when it does not begin so.
std::optional<double> take_number(std::string_view& text, const std::string& name) {
  const std::string_view begin = text.substr(0, name.size() + 1);
  if (begin != name + "=") return {};
  const std::size_t end = std::min(text.find(',', begin.size()), text.size());
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data() + begin.size(), text.data() + end, value);
  if (error != std::errc{} || rest != text.data() + end) return {};
  text.remove_prefix(std::min(end + 1, text.size()));
  return value;
}

std::optional<StudyRun> run_of_folder(std::string_view name, const StudyDeck& study) {
  std::string_view rest = name;
  std::vector<double> values;
  for (const ParameterDeck& p : study.parameters) {
    const std::optional<double> value = take_number(rest, p.name);
    if (!value) return {};
    values.push_back(*value);
  }
  const std::optional<double> seed = take_number(rest, "seed");
  if (!seed) return {};
  StudyRun run = run_at(study, values, static_cast<std::int64_t>(*seed));
  if (run.name != name) return {};
  return run;
}

}  // namespace

std::vector<StudyRun> runs_in(const std::string& directory, const StudyDeck& study) {
  std::error_code error;
  std::vector<StudyRun> runs;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    if (auto run = run_of_folder(entry.path().filename().string(), study)) runs.push_back(std::move(*run));
  }
  if (error) throw FileError(fmt::format("{}: cannot be read: {}", directory, error.message()));
  std::sort(runs.begin(), runs.end(), [](const StudyRun& a, const StudyRun& b) {
    return std::pair(a.values, a.seed) < std::pair(b.values, b.seed);
  });
  return runs;
}

std::vector<StudyRun> runs_at(const StudyDeck& study, const std::vector<std::vector<double>>& points) {
  std::vector<StudyRun> runs;
  std::map<std::vector<double>, std::int64_t> seen;
  for (const std::vector<double>& values : points) {
    const std::int64_t first = study.first_seed + study.seeds * seen[values]++;
    for (std::int64_t k = 0; k < study.seeds; ++k) runs.push_back(run_at(study, values, first + k));
  }
  return runs;
}

}  // namespace repose
