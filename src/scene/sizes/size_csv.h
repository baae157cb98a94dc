#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/sizes/size_distribution.h"

namespace repose {

/// What a sieve or a laser has measured.
struct SizeAnalysis {
  Weighting by;
  std::vector<SizeBin> bins;
};

/// A size analysis from CSV text. The header line names two columns: `diameter` (m), `diameter_mm` or `diameter_um`,
/// and `cumulative_mass`, `cumulative_number` (share that is smaller), `share_mass` or `share_number` (share between
/// the diameter of the line above and this one). Shares may be of 1 or of 100: the sum counts. Diameters increase; the
/// first line has the share 0, the lower end of the finest class. DeckError as `file:line: what` on the first bad line.
SizeAnalysis parse_size_csv(std::string_view text, const std::string& file);

}  // namespace repose
