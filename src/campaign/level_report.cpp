#include "campaign/level_report.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "calibration/level_likelihood.h"
#include "calibration/level_surface.h"
#include "calibration/posterior_estimate.h"
#include "calibration/standard_runs.h"
#include "campaign/observables.h"
#include "campaign/search.h"
#include "files/json_text.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

struct LevelRuns {
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;
};

/// Those of the levels from `first` to `last`.
LevelRuns runs_of_levels(std::size_t first, std::size_t last, std::span<const StudyRun> runs,
                         std::span<const RunRecord> records) {
  LevelRuns own;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].level < first || runs[i].level > last) continue;
    own.runs.push_back(runs[i]);
    own.records.push_back(records[i]);
  }
  return own;
}

LevelRuns runs_of_level(std::size_t level, std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  return runs_of_levels(level, level, runs, records);
}

/// Points of a level with a run for which `is_counted(run, record)` holds.
template <class IsCounted>
std::ptrdiff_t points_where(const LevelRuns& level, const IsCounted& is_counted) {
  std::set<std::vector<double>> points;
  for (std::size_t i = 0; i < level.runs.size(); ++i) {
    if (is_counted(level.runs[i], level.records[i])) points.insert(level.runs[i].values);
  }
  return std::ssize(points);
}

std::ptrdiff_t points_done(const LevelRuns& level) {
  return points_where(level, [](const StudyRun&, const RunRecord& record) { return is_complete(record.state); });
}

bool has_ended(const RunRecord& record) { return record.state != RunState::waiting; }

std::ptrdiff_t points_ended(const LevelRuns& level) {
  return points_where(level, [](const StudyRun&, const RunRecord& record) { return has_ended(record); });
}

std::ptrdiff_t runs_ended(const LevelRuns& level) {
  return std::count_if(level.records.begin(), level.records.end(), has_ended);
}

/// Whether a record has a value of observable `k` of the deck.
bool has_value(const CalibrationDeck& deck, const RunRecord& record, std::size_t k) {
  const ObservableDeck& o = deck.observables[k];
  if (!counts(record, o)) return false;
  if (record.figures.size() == deck.observables.size()) return record.figures[k].has_value();
  if (o.is_curve()) return true;
  const auto before = deck.observables.begin() + static_cast<std::ptrdiff_t>(k);
  const auto curves =
      std::count_if(deck.observables.begin(), before, [](const ObservableDeck& other) { return other.is_curve(); });
  return record.figures[k - static_cast<std::size_t>(curves)].has_value();
}

/// Points of a level at which an observable has a value.
std::ptrdiff_t points_with_value(const CalibrationDeck& deck, const LevelRuns& level, std::size_t k) {
  return points_where(level, [&](const StudyRun& run, const RunRecord& record) {
    return run.experiment == deck.observables[k].experiment && has_value(deck, record, k);
  });
}

OtherEstimate other_estimate(std::string what, Misfit misfit, double confidence) {
  Estimate found = estimate(misfit, confidence);
  return {std::move(what), std::move(misfit), std::move(found)};
}

/// Null without levels.
const LevelSurface* level_surface(const Misfit& misfit, Index observable) {
  return dynamic_cast<const LevelSurface*>(&misfit.surface(observable));
}

/// The name of the level whose runs say how those of a level above the first scatter: its own, or the one below it.
const std::string& scatter_from(const CalibrationDeck& deck, const LevelSurface& surface, std::size_t level) {
  return deck.levels[has_own_scatter(surface.data(level)) ? level : level - 1].name;
}

}  // namespace

std::string states_text(std::span<const RunRecord> records) {
  const auto count = [&](RunState state) {
    return std::count_if(records.begin(), records.end(), [&](const RunRecord& r) { return r.state == state; });
  };
  return fmt::format("{} runs: {} done, {} plugged, {} failed, {} to come", records.size(), count(RunState::done),
                     count(RunState::plugged), count(RunState::failed), count(RunState::waiting));
}

std::optional<TooFewPoints> too_few_points(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                           std::span<const RunRecord> records, std::size_t first, std::size_t last) {
  for (std::size_t level = first; level <= last; ++level) {
    const LevelRuns own = runs_of_level(level, runs, records);
    for (std::size_t k = 0; k < deck.observables.size(); ++k) {
      const std::ptrdiff_t points = points_with_value(deck, own, k);
      if (points >= least_points) continue;
      const std::string what = fmt::format("observable \"{}\": has a value at {} points; a surface needs {} or more",
                                           deck.observables[k].figure, points, least_points);
      const std::string of_level = deck.levels.empty() ? "" : "level " + deck.levels[level].name + ": ";
      return TooFewPoints{level, what, of_level + what};
    }
  }
  return {};
}

void require_surfaces(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  const auto lacks = too_few_points(deck, runs, records, 0, deck.level_count() - 1);
  if (!lacks) return;
  std::string text = lacks->with_level + "; " + states_text(records);
  const auto failed =
      std::find_if(records.begin(), records.end(), [](const RunRecord& r) { return !r.reason.empty(); });
  if (failed != records.end()) {
    const StudyRun& run = runs[static_cast<std::size_t>(failed - records.begin())];
    text += fmt::format("; runs/{}: {}", run.name, failed->reason);
  }
  throw DeckError(text);
}

KnownLevels known_levels(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                         std::span<const RunRecord> records) {
  for (std::size_t level = 1; level < deck.levels.size(); ++level) {
    const std::ptrdiff_t points = points_done(runs_of_level(level, runs, records));
    const auto lacks = too_few_points(deck, runs, records, level, level);
    if (!lacks) continue;
    LevelRuns below = runs_of_levels(0, level - 1, runs, records);
    KnownLevels known{deck, std::move(below.runs), std::move(below.records), {}};
    known.deck.levels.resize(level);
    const std::string why = points < least_points ? fmt::format("{} points of it are done, a surface needs {} or more",
                                                                points, least_points)
                                                  : lacks->what;
    known.left_out = fmt::format("level {} {} left out: {}\n", deck.levels[level].name,
                                 level + 1 < deck.levels.size() ? "and those above are" : "is", why);
    return known;
  }
  return {deck, {runs.begin(), runs.end()}, {records.begin(), records.end()}, {}};
}

OtherEstimate first_level_alone(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                std::span<const RunRecord> records) {
  CalibrationDeck first = deck;
  first.levels.resize(1);
  const LevelRuns own = runs_of_level(0, runs, records);
  return other_estimate(deck.levels[0].name + " alone", misfit_of(first, own.runs, own.records), deck.confidence);
}

std::vector<OtherEstimate> experiments_alone(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                             std::span<const RunRecord> records) {
  std::vector<OtherEstimate> result;
  for (std::size_t e = 0; deck.experiments.size() > 1 && e < deck.experiments.size(); ++e) {
    CalibrationDeck alone = deck;
    alone.observables.clear();
    std::vector<StudyRun> own_runs;
    std::vector<RunRecord> own_records;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i].experiment != e) continue;
      own_runs.push_back(runs[i]);
      own_records.push_back(records[i]);
      own_records.back().figures.clear();
    }
    for (std::size_t k = 0; k < deck.observables.size(); ++k) {
      if (deck.observables[k].experiment != e) continue;
      alone.observables.push_back(deck.observables[k]);
      auto own = own_records.begin();
      for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].experiment == e) (own++)->figures.push_back(records[i].figures[k]);
      }
    }
    const bool is_enough = alone.observables.size() >= deck.study.parameters.size();
    if (!is_enough && !takes_posterior(ranges_of(deck.study))) continue;
    result.push_back(
        other_estimate(deck.experiments[e].name + " alone", misfit_of(alone, own_runs, own_records), deck.confidence));
  }
  return result;
}

OtherEstimate without_discrepancy(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                  std::span<const RunRecord> records) {
  CalibrationDeck exact = deck;
  for (ObservableDeck& o : exact.observables) o.discrepancy = o.discrepancy_share = 0.0;
  return other_estimate("without the discrepancy of the model", misfit_of(exact, runs, records), deck.confidence);
}

bool has_discrepancy(const CalibrationDeck& deck) {
  for (const ObservableDeck& o : deck.observables) {
    if (o.model_deviation() > 0.0) return true;
  }
  return false;
}

Json levels_json(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  Json list = Json::array();
  for (std::size_t level = 0; level < deck.levels.size(); ++level) {
    const LevelRuns own = runs_of_level(level, runs, records);
    list.push_back({{"name", deck.levels[level].name},
                    {"points", points_ended(own)},
                    {"runs", runs_ended(own)},
                    {"core_hours", core_hours(deck, own.runs, own.records)}});
  }
  return list;
}

std::string levels_text(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                        std::span<const RunRecord> records) {
  std::string text;
  for (std::size_t level = 0; level < deck.levels.size(); ++level) {
    const LevelRuns own = runs_of_level(level, runs, records);
    text += fmt::format("level {:20} {} points, {} runs, {:.3g} core-hours at {:.3g} particle-steps/s\n",
                        deck.levels[level].name, points_ended(own), runs_ended(own),
                        core_hours(deck, own.runs, own.records), deck.adaptive.core_speed);
  }
  return text;
}

Json links_json(const CalibrationDeck& deck, const Misfit& misfit, Index observable) {
  Json list = Json::array();
  const LevelSurface* surface = level_surface(misfit, observable);
  for (std::size_t level = 1; surface != nullptr && level < deck.levels.size(); ++level) {
    list.push_back({{"level", deck.levels[level].name},
                    {"below", deck.levels[level - 1].name},
                    {"rho", json_number(surface->rho(level))},
                    {"rho_standard_error", json_number(surface->rho_deviation(level))},
                    {"explained", json_number(surface->explained(level))},
                    {"second_seeds", surface->data(level).second_seeds()},
                    {"scatter_from", scatter_from(deck, *surface, level)}});
  }
  return list;
}

std::string links_text(const CalibrationDeck& deck, const Misfit& misfit) {
  std::string text;
  for (Index k = 0; k < misfit.observables(); ++k) {
    const LevelSurface* surface = level_surface(misfit, k);
    for (std::size_t level = 1; surface != nullptr && level < deck.levels.size(); ++level) {
      const std::string& own = deck.levels[level].name;
      text += fmt::format("{:26} {} = {:.3g} (+- {:.2g}) x {} + a rest; {:.0f} % of it explained", surface->name(), own,
                          surface->rho(level), surface->rho_deviation(level), deck.levels[level - 1].name,
                          100.0 * surface->explained(level));
      const std::string& from = scatter_from(deck, *surface, level);
      if (from != own) {
        text += fmt::format("; {} second seeds: scatters as {}", surface->data(level).second_seeds(), from);
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace repose
