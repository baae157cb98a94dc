#pragma once

#include <span>
#include <vector>

#include "calibration/misfit.h"
#include "campaign/run_folder.h"
#include "campaign/run_list.h"
#include "deck/calibration_deck.h"

namespace repose {

/// The ranges in which the parameters are looked for.
std::vector<ParameterRange> ranges_of(const StudyDeck& study);

/// The parameters of each run.
std::vector<std::vector<double>> places_of(std::span<const StudyRun> runs);

/// The level and the experiment of each run; none without levels or experiments.
RunLevels levels_of(const CalibrationDeck& deck, std::span<const StudyRun> runs);

/// What the runs and the laboratory say together.
Misfit misfit_of(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records);

/// Whether a record has something to say of what a column or a key of summary.json measures. A plugged run counts for
/// the masses alone: what little has fallen through is no pile (thesis section 3.5).
bool counts(const RunRecord& record, const std::string& measured);

/// The same of an observable, for whose mass plugged runs do not count either if it is one of flowing runs only.
bool counts(const RunRecord& record, const ObservableDeck& observable);

/// The values of figure `k` of the records, NaN where a run has none or does not count for it.
std::vector<double> values_of_figure(std::span<const RunRecord> records, const std::string& figure, std::size_t k);

/// What the laboratory and the runs have of each observable; the records' figures are those of the observables.
std::vector<ObservableData> observable_data(const CalibrationDeck& deck, std::span<const RunRecord> records);

}  // namespace repose
