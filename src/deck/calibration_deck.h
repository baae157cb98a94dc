#pragma once

#include <string>
#include <vector>

#include "deck/study_deck.h"

namespace repose {

/// The scale on which the surface of an observable is built.
enum class ObservableScale { linear, square_root, logarithm };

/// What a laboratory has measured over something: a mean and the deviation of one measurement at each x, which rises.
struct LaboratoryCurve {
  std::vector<double> x, y, deviation;
};

/// A figure or a curve of the runs, and what the laboratory has.
struct ObservableDeck {
  std::string figure;              ///< its name in tables; as read, the key of summary.json
  double laboratory = unset;       ///< in the unit of the figure
  double deviation = unset;        ///< standard deviation of one measurement
  std::int64_t repeats = 1;        ///< measurements of which `laboratory` is the mean
  bool deviation_is_known = true;  ///< false: estimated from these very repeats
  ObservableScale scale = ObservableScale::linear;
  bool flowing_only = false;       ///< plugged runs have no mass to compare either
  double discrepancy = 0.0;        ///< standard deviation of what the model cannot be expected to meet, in that unit
  double discrepancy_share = 0.0;  ///< or over the laboratory's value
  std::string key;                 ///< of summary.json
  std::size_t experiment = 0;
  // Of a curve:
  std::string name;                   ///< as read
  std::string curve;                  ///< path of its file, relative to that of the deck; empty: this is no curve
  std::string series;                 ///< table that a run writes, with the columns
  std::string x, y;                   ///< of the runs' curve
  std::string phase;                  ///< from whose begin x counts, and whose rows they are; empty: all rows
  double correlation_length = unset;  ///< of the laboratory's deviations, in the unit of x
  std::int64_t components = 4;        ///< at most
  LaboratoryCurve laboratory_curve;   ///< what the file has, once it is read

  bool is_curve() const { return !curve.empty(); }
  /// Of what the runs measure, in the words of their files.
  const std::string& measured() const { return is_curve() ? y : key.empty() ? figure : key; }
  /// In the unit of the figure.
  double model_deviation() const;
};

/// Parameters to run at, in the order of the [[parameter]] sections.
struct PointDeck {
  std::vector<double> values;
  std::string level;  ///< name of that at which a search runs it; empty: all
};

/// A search that decides on its points as it goes.
struct AdaptiveDeck {
  bool enabled = false;     ///< true when the deck has the section
  std::int64_t start = 0;   ///< points of the first design
  std::int64_t batch = 0;   ///< points decided at a time
  std::int64_t budget = 0;  ///< points in all; 0: not given
  double budget_core_hours = unset;
  double core_speed = 8e6;    ///< particle-steps per second of a core, by which core-hours are counted
  double half_width = unset;  ///< of the widest confidence interval over its range, at which it is narrow enough
};

/// A level of the model: the same test made cheaper, or the one that counts, which is the last.
struct LevelDeck {
  std::string name;
  std::string base;                ///< path of the deck; empty: that of the study
  std::vector<std::string> set;    ///< after those of the study
  std::int64_t seeds = 0;          ///< at each point; 0: as the study
  std::int64_t ranks_per_run = 0;  ///< 0: as the study
  std::int64_t start = 0;          ///< points of the first design; 0: as [adaptive]
};

/// What an experiment changes at a level of the model.
struct ExperimentLevelDeck {
  std::string name;              ///< of the level
  std::string base;              ///< path of the deck; empty: that of the experiment
  std::vector<std::string> set;  ///< after those of the level
  std::int64_t seeds = 0;        ///< at each point; 0: as the level
};

/// One test of several that share the parameters.
struct ExperimentDeck {
  std::string name;
  std::string base;              ///< path of its deck; empty: that of the study
  std::vector<std::string> set;  ///< after those of the study
  std::int64_t seeds = 0;        ///< at each point; 0: as the study
  std::vector<ObservableDeck> observables;
  std::vector<ExperimentLevelDeck> levels;
};

/// Runs over a grid of parameters, and what their figures should come to.
struct CalibrationDeck {
  StudyDeck study;
  double confidence = 0.95;
  std::vector<PointDeck> points;            ///< instead of a grid, or beside the first design of a search
  std::vector<ObservableDeck> observables;  ///< those of all experiments, one after the other
  std::vector<LevelDeck> levels;            ///< the cheapest first; empty: one, which is the study
  AdaptiveDeck adaptive;
  std::vector<ExperimentDeck> experiments;  ///< empty: one, which is the study

  std::size_t level_count() const { return levels.empty() ? 1 : levels.size(); }
  std::size_t experiment_count() const { return experiments.empty() ? 1 : experiments.size(); }
};

/// The study of one experiment at one level: its base, settings and seeds in place of the whole's.
StudyDeck study_of_level(const CalibrationDeck& deck, std::size_t level, std::size_t experiment = 0);

/// Points of the first design of a level.
std::int64_t start_of_level(const CalibrationDeck& deck, std::size_t level);

/// The points of the list that a search runs at a level beside its first design.
std::vector<std::vector<double>> points_of_level(const CalibrationDeck& deck, std::size_t level);

/// All its keys, for a person.
std::string calibration_keys();

/// Reads and checks it. DeckError, with the place, on the first mistake.
CalibrationDeck read_calibration_deck(const std::string& text, const std::string& path);

/// The points of the list or of the grid, the last parameter the fastest; empty with [adaptive].
std::vector<std::vector<double>> points_of(const CalibrationDeck& deck);

}  // namespace repose
