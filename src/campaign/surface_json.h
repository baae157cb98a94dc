#pragma once

#include <nlohmann/json_fwd.hpp>

#include "calibration/misfit.h"
#include "deck/calibration_deck.h"

namespace repose {

/// For plots of two parameters: on a lattice, the mean and the deviation of each observable's surface and the misfit
/// T with its limit; the laboratory's contour line of each observable.
nlohmann::ordered_json surface_json(const Misfit& misfit, const CalibrationDeck& deck, double limit);

}  // namespace repose
