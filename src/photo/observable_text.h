#pragma once

#include <string>
#include <vector>

#include "photo/measured.h"

namespace repose::photo {

/// What an [[observable]] of a calibration file says of a figure.
struct MeasuredFigure {
  std::string figure;  ///< key of summary.json
  Measured value;
  std::size_t photographs = 1;
  bool is_count = false;
};

/// [[observable]] sections to paste into a calibration file.
std::string observable_text(const std::vector<MeasuredFigure>& figures);

/// The text of a calibration file in which these figures have their new values: laboratory, deviation, repeats and
/// deviation_is_known of an [[observable]] that is there, and a new section at the end for one that is not. All else
/// stays, comments included. DeckError when `text` is no calibration file before or would be none after; `path` is its
/// name in messages.
std::string with_observables(const std::string& text, const std::string& path,
                             const std::vector<MeasuredFigure>& figures);

}  // namespace repose::photo
