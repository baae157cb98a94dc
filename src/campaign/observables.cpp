#include "campaign/observables.h"

#include <limits>

namespace repose {
namespace {

Transform transform_of(ObservableScale scale) {
  switch (scale) {
    case ObservableScale::square_root:
      return Transform::square_root;
    case ObservableScale::logarithm:
      return Transform::logarithm;
    case ObservableScale::linear:
      break;
  }
  return Transform::none;
}

LaboratoryValue laboratory_of(const ObservableDeck& o) {
  const auto repeats = static_cast<double>(o.repeats);
  LaboratoryValue laboratory{o.laboratory, o.deviation, repeats};
  if (!o.deviation_is_known) laboratory.freedom = repeats - 1.0;
  return laboratory;
}

Prior prior_of(const ParameterDeck& p) {
  switch (p.prior) {
    case ParameterPrior::normal:
      return {PriorKind::normal, p.prior_mean, p.prior_deviation};
    case ParameterPrior::lognormal:
      return {PriorKind::lognormal, p.prior_mean, p.prior_deviation};
    case ParameterPrior::uniform:
      break;
  }
  return {};
}

/// NaN where a run has none or does not count for what is measured.
template <class Measured>
std::vector<double> values_that_count(std::span<const RunRecord> records, const Measured& measured, std::size_t k) {
  std::vector<double> values;
  for (const RunRecord& record : records) {
    const bool has_value = counts(record, measured) && record.figures[k];
    values.push_back(has_value ? *record.figures[k] : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

}  // namespace

std::vector<ParameterRange> ranges_of(const StudyDeck& study) {
  std::vector<ParameterRange> ranges;
  for (const ParameterDeck& p : study.parameters) ranges.push_back({p.name, p.min, p.max, prior_of(p)});
  return ranges;
}

std::vector<std::vector<double>> places_of(std::span<const StudyRun> runs) {
  std::vector<std::vector<double>> places;
  for (const StudyRun& run : runs) places.push_back(run.values);
  return places;
}

RunLevels levels_of(const CalibrationDeck& deck, std::span<const StudyRun> runs) {
  RunLevels levels{.count = deck.level_count(), .of_run = {}, .experiment_of_run = {}};
  for (const StudyRun& run : runs) {
    if (!deck.levels.empty()) levels.of_run.push_back(run.level);
    if (!deck.experiments.empty()) levels.experiment_of_run.push_back(run.experiment);
  }
  return levels;
}

Misfit misfit_of(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  return {ranges_of(deck.study), places_of(runs), levels_of(deck, runs), observable_data(deck, records)};
}

bool counts(const RunRecord& record, const std::string& measured) {
  const bool is_mass = measured == "discharged_mass_kg" || measured == "retained_mass_kg";
  return record.state == RunState::done || (record.state == RunState::plugged && is_mass);
}

bool counts(const RunRecord& record, const ObservableDeck& observable) {
  return counts(record, observable.measured()) && !(record.state == RunState::plugged && observable.flowing_only);
}

std::vector<double> values_of_figure(std::span<const RunRecord> records, const std::string& figure, std::size_t k) {
  return values_that_count(records, figure, k);
}

std::vector<ObservableData> observable_data(const CalibrationDeck& deck, std::span<const RunRecord> records) {
  std::vector<ObservableData> data;
  for (std::size_t k = 0; k < deck.observables.size(); ++k) {
    const ObservableDeck& o = deck.observables[k];
    data.push_back({o.figure, transform_of(o.scale), laboratory_of(o), values_that_count(records, o, k),
                    o.model_deviation(), o.experiment});
  }
  return data;
}

}  // namespace repose
