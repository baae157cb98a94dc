#pragma once

#include <span>
#include <string>

#include "calibration/estimate.h"
#include "campaign/curve_observables.h"
#include "campaign/run_list.h"

namespace repose {

/// What runs and laboratory say, for a person and for programs.
struct Report {
  std::string text;
  std::string json;     ///< of estimate.json; with two parameters also the surfaces and contour lines, for the plots
  std::string samples;  ///< of posterior.csv: a row each; empty without a posterior
};

/// DeckError when no surface can be built from the runs.
Report report_of(const Projection& projection, std::span<const StudyRun> runs);

/// One line while a search is under way.
std::string progress_of(const Estimate& estimate);

}  // namespace repose
