#include "campaign/level_runs.h"

#include <filesystem>
#include <iterator>

namespace repose {
namespace {

/// Into the list, as those of a level.
void append(std::vector<StudyRun>& runs, std::vector<StudyRun> more, const CalibrationDeck& deck, std::size_t level) {
  for (StudyRun& run : more) {
    run.level = level;
    if (!deck.levels.empty()) run.name = deck.levels[level].name + "/" + run.name;
  }
  runs.insert(runs.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<StudyRun> level_runs(const CalibrationDeck& deck, const std::vector<std::string>& overrides,
                                 std::span<const LevelPoint> points) {
  std::vector<StudyRun> runs;
  for (std::size_t level = 0; level < deck.level_count(); ++level) {
    StudyDeck study = study_of_level(deck, level);
    study.set.insert(study.set.end(), overrides.begin(), overrides.end());
    std::vector<std::vector<double>> own;
    for (const LevelPoint& point : points) {
      if (point.level == level) own.push_back(point.values);
    }
    append(runs, runs_at(study, own), deck, level);
  }
  return runs;
}

std::vector<StudyRun> level_runs_in(const std::string& directory, const CalibrationDeck& deck) {
  if (deck.levels.empty()) return runs_in(directory, deck.study);
  std::vector<StudyRun> runs;
  for (std::size_t level = 0; level < deck.levels.size(); ++level) {
    const std::string folder = directory + "/" + deck.levels[level].name;
    if (std::filesystem::exists(folder)) append(runs, runs_in(folder, study_of_level(deck, level)), deck, level);
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
