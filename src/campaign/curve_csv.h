#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "deck/calibration_deck.h"

namespace repose {

/// The curve of a laboratory: lines x,y,deviation below that header, x rising, deviations above 0. DeckError as
/// `file:line: what` on the first bad line.
LaboratoryCurve parse_curve_csv(std::string_view text, const std::string& file);

/// The steps of a run whose rows count; x is counted from the first of them.
struct StepWindow {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

/// Two columns of a table that a run has written, as a curve that is linear between the rows.
struct RunCurve {
  std::vector<double> x, y;
};

/// The columns `observable.x` and `observable.y`. With `window` the rows of these steps alone, x less that of the first
/// step, and a row at either end between those that stand there, where there are some. Rows whose y is `nan` are left
/// out. DeckError, with the place, when the table lacks a column, x does not rise or a value is no number.
RunCurve parse_run_curve(std::string_view text, const std::string& file, const ObservableDeck& observable,
                         const StepWindow* window);

/// The curve at these places. DeckError, with `file` and the observable's name, when it does not reach so far.
std::vector<double> at_places(const RunCurve& curve, const std::string& file, const ObservableDeck& observable);

}  // namespace repose
