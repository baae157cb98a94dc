#pragma once

#include <string>
#include <vector>

#include "deck/study_deck.h"

namespace repose {

/// One run of a study.
struct StudyRun {
  std::vector<double> values;  ///< of the parameters
  std::int64_t seed = 0;
  std::string name;                    ///< of its folder, from the values and the seed alone
  std::vector<std::string> overrides;  ///< of the base deck
  std::size_t level = 0;               ///< of the model
  std::size_t experiment = 0;
  std::int64_t ranks = 1;  ///< that work on it, at least
};

/// All seeds at each point, point after point. A point that stands there again gets the next seeds.
std::vector<StudyRun> runs_at(const StudyDeck& study, const std::vector<std::vector<double>>& points);

/// The runs that have folders in `directory`, told by their names, in the order of their values and seeds. Other
/// folders are passed over. FileError when the directory cannot be read.
std::vector<StudyRun> runs_in(const std::string& directory, const StudyDeck& study);

}  // namespace repose
