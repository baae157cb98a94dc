#include "campaign/level_runs.h"

#include <filesystem>
#include <iterator>

namespace repose {
namespace {

/// What stands before the names of runs.
std::string folders_before(const CalibrationDeck& deck, std::size_t level, std::size_t experiment) {
  std::string folder;
  if (!deck.experiments.empty()) folder += deck.experiments[experiment].name + "/";
  if (!deck.levels.empty()) folder += deck.levels[level].name + "/";
  return folder;
}

/// Into the list, as those of a level of an experiment.
void append(std::vector<StudyRun>& runs, std::vector<StudyRun> more, const CalibrationDeck& deck, std::size_t level,
            std::size_t experiment) {
  for (StudyRun& run : more) {
    run.level = level;
    run.experiment = experiment;
    run.name = folders_before(deck, level, experiment) + run.name;
  }
  runs.insert(runs.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<StudyRun> level_runs(const CalibrationDeck& deck, const std::vector<std::string>& overrides,
                                 std::span<const LevelPoint> points) {
  std::vector<StudyRun> runs;
  for (std::size_t level = 0; level < deck.level_count(); ++level) {
    std::vector<std::vector<double>> own;
    for (const LevelPoint& point : points) {
      if (point.level == level) own.push_back(point.values);
    }
    for (std::size_t experiment = 0; experiment < deck.experiment_count(); ++experiment) {
      StudyDeck study = study_of_level(deck, level, experiment);
      study.set.insert(study.set.end(), overrides.begin(), overrides.end());
      append(runs, runs_at(study, own), deck, level, experiment);
    }
  }
  return runs;
}

std::vector<StudyRun> level_runs_in(const std::string& directory, const CalibrationDeck& deck) {
  std::vector<StudyRun> runs;
  for (std::size_t level = 0; level < deck.level_count(); ++level) {
    for (std::size_t experiment = 0; experiment < deck.experiment_count(); ++experiment) {
      const std::string below = folders_before(deck, level, experiment);
      const std::string folder = directory + "/" + below;
      if (!below.empty() && !std::filesystem::exists(folder)) continue;
      append(runs, runs_in(folder, study_of_level(deck, level, experiment)), deck, level, experiment);
    }
  }
  return runs;
}

std::vector<LevelPoint> at_every_level(const CalibrationDeck& deck, const std::vector<std::vector<double>>& points) {
  std::vector<LevelPoint> result;
  for (std::size_t level = 0; level < deck.level_count(); ++level) {
    for (const std::vector<double>& values : points) result.push_back({level, values});
  }
  return result;
}

}  // namespace repose
