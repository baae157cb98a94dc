#pragma once

#include "deck/calibration_deck.h"
#include "deck/deck_errors.h"

namespace repose {

/// Notes what is wrong between the keys of a calibration whose single keys are right, and gives its observables the
/// names that they have in tables, those of the experiments after each other.
void check_calibration(CalibrationDeck& deck, DeckErrors& errors);

}  // namespace repose
