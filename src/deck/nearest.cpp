#include "deck/nearest.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace repose {
namespace {

constexpr std::size_t least_part = 3;  // letters that are not in a name by chance

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string nearest(std::string_view text, const std::vector<std::string>& candidates) {
  const auto holds_text = [&](const std::string& candidate) {
    return text.size() >= least_part && candidate.find(text) != std::string::npos;
  };
  const bool only_holders = std::any_of(candidates.begin(), candidates.end(), holds_text);
  std::string best;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(text, candidate);
    if (distance < best_distance && (!only_holders || holds_text(candidate))) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace repose
