#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "calibration/curve_components.h"
#include "campaign/run_folder.h"
#include "campaign/run_list.h"
#include "comm/communicator.h"
#include "deck/calibration_deck.h"

namespace repose {

/// Collective. The laboratory's curves of a deck, from the files at these paths. DeckError on a bad one, FileError.
using CurvePath = std::function<std::string(const ObservableDeck&)>;
void read_curves(const Communicator& world, const CurvePath& path_of, CalibrationDeck& deck);

/// Where the curve of an observable is kept beside the runs, for estimates that come later.
std::string curve_copy(const ObservableDeck& observable);

/// DeckError when runs of a deck have no such phase, or write no such table, as the curves of an experiment name.
void check_curves(const CalibrationDeck& deck, const Deck& run, std::size_t experiment);

/// DeckError when the run in a folder is complete and has no curve at the laboratory's places.
void check_curves(const CalibrationDeck& deck, const std::string& folder, const StudyRun& run);

/// A curve that is compared by its components.
struct ProjectedCurve {
  ObservableDeck observable;
  CurveComponents components;
};

/// A deck in which each curve is replaced by an observable for each of its components, NAME.1 and so on, and the
/// records with the scores of the runs.
struct Projection {
  CalibrationDeck deck;
  std::vector<RunRecord> records;
  std::vector<ProjectedCurve> curves;
};

/// The components are those of the runs that are complete: with more runs they change. A run that failed, or is plugged
/// and does not count, has no curve. `records` have the figures of the observables that are no curves, in their order.
/// For rank 0. DeckError when a curve cannot be compared; FileError.
Projection project_curves(const CalibrationDeck& deck, const std::string& directory, std::span<const StudyRun> runs,
                          std::span<const RunRecord> records);

/// For a person: a line for each curve.
std::string curves_text(std::span<const ProjectedCurve> curves);
/// For estimate.json: curves, components, and what the components have of the laboratory.
nlohmann::ordered_json curves_json(std::span<const ProjectedCurve> curves);

}  // namespace repose
