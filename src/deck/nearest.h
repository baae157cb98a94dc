#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// The fewest insertions, deletions and replacements of one character that turn `a` into `b` (Levenshtein's distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance, the first of equals, among those that contain the text if it has
/// three letters and some do ("drum": rotating_drum); empty without candidates.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);

}  // namespace repose
