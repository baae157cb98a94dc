#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "calibration/estimate.h"
#include "deck/calibration_deck.h"

namespace repose {

/// "0.2 to above 0.7".
std::string interval_text(const ConfidenceInterval& interval);
nlohmann::ordered_json interval_json(const ConfidenceInterval& interval);

/// Of an estimate with a posterior and a point: a line for each parameter, and which of them go together.
std::string posterior_text(const CalibrationDeck& deck, const Estimate& estimate);

nlohmann::ordered_json prior_json(const ParameterDeck& parameter);
nlohmann::ordered_json posterior_json(const Posterior& posterior);

/// A row for each sample: the parameters, and ln of the density.
std::string posterior_csv(const CalibrationDeck& deck, const Posterior& posterior);

}  // namespace repose
