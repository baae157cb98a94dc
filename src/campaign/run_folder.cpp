#include "campaign/run_folder.h"

#include <array>
#include <filesystem>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/json_text.h"
#include "files/shared_file.h"
#include "run/checkpoints.h"
#include "run/summary_figures.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* failure_file = "/failed.json";

Json read_json(const std::string& path) {
  Json json = Json::parse(read_whole_file(path), nullptr, false);
  if (!json.is_object()) throw FileError(fmt::format("{}: is damaged; remove its folder to run it again", path));
  return json;
}

/// `json[key]`, which files of this program have. FileError when it is missing or of another type.
template <class T>
T value_of(const Json& json, const char* key, const std::string& path) {
  try {
    return json.at(key).get<T>();
  } catch (const Json::exception&) {
    throw FileError(fmt::format("{}: \"{}\" is missing or wrong; remove the folder to run it again", path, key));
  }
}

RunRecord record_of_summary(const std::string& path, std::span<const std::string> figures) {
  const Json summary = read_json(path);
  RunRecord record;
  const bool plugged = summary.contains("plugged") && summary["plugged"].is_boolean() && summary["plugged"].get<bool>();
  record.state = plugged ? RunState::plugged : RunState::done;
  for (const std::string& figure : figures) record.figures.push_back(figure_in(summary, figure));
  for (const Json& phase : value_of<Json>(summary, "phases", path)) {
    if (value_of<std::string>(phase, "ended_by", path) == "max_time") {
      record.overdue.push_back(value_of<std::string>(phase, "name", path));
    }
  }
  record.state_hash = value_of<std::string>(summary, "state_hash", path);
  record.wall_seconds = value_of<double>(summary, "wall_seconds", path);
  record.ranks = value_of<int>(summary, "ranks", path);
  record.restarts = value_of<std::int64_t>(summary, "restarts", path);
  const Json::json_pointer grains("/particles/inserted");
  if (summary.contains("steps") && summary["steps"].is_number() && summary.contains(grains) &&
      summary[grains].is_number()) {
    record.particle_steps = summary["steps"].get<double>() * summary[grains].get<double>();
  }
  return record;
}

}  // namespace

const char* to_string(RunState state) {
  constexpr std::array names = {"waiting", "running", "done", "plugged", "failed"};
  return names.at(static_cast<std::size_t>(state));
}

RunRecord read_run_folder(const std::string& folder, std::span<const std::string> figures) {
  const std::string summary = folder + "/summary.json";
  if (std::filesystem::exists(summary)) return record_of_summary(summary, figures);
  RunRecord record;
  record.figures.resize(figures.size());
  const std::string failure = folder + failure_file;
  record.has_checkpoint = std::filesystem::exists(folder) && !checkpoints_in(folder).empty();
  if (!std::filesystem::exists(failure)) return record;
  const Json json = read_json(failure);
  record.failure = static_cast<ExitCode>(value_of<int>(json, "code", failure));
  record.reason = value_of<std::string>(json, "reason", failure);
  if (record.failure == ExitCode::physics) record.state = RunState::failed;
  return record;
}

std::string folder_of(const std::string& directory, const StudyRun& run) { return directory + "/runs/" + run.name; }

std::vector<RunRecord> read_run_folders(const std::string& directory, std::span<const StudyRun> runs,
                                        std::span<const RunFigure> figures) {
  std::vector<RunRecord> records;
  for (const StudyRun& run : runs) {
    std::vector<std::string> own;
    for (const RunFigure& figure : figures) {
      if (figure.experiment == run.experiment) own.push_back(figure.key);
    }
    RunRecord& record = records.emplace_back(read_run_folder(folder_of(directory, run), own));
    auto found = record.figures.begin();
    std::vector<std::optional<double>> all;
    for (const RunFigure& figure : figures) {
      all.push_back(figure.experiment == run.experiment ? *found++ : std::nullopt);
    }
    record.figures = std::move(all);
  }
  return records;
}

void write_failure(const std::string& folder, ExitCode code, const std::string& reason) {
  const Json json = {{"status", "failed"}, {"code", static_cast<int>(code)}, {"reason", reason}};
  create_output_directory(folder);
  write_text_file(folder + failure_file, json_text(json));
}

void remove_failure(const std::string& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder + failure_file, ignored);
}

}  // namespace repose
