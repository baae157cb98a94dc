#include "deck/key_reference.h"

#include <algorithm>

namespace repose {

void KeyReference::begin(const std::string& title, const Presence& presence, std::string_view meaning) {
  groups_.push_back({fmt::format("{}  {}{}", title, meaning, presence.is_required ? " (required)" : ""), {}});
}

std::string KeyReference::text(std::string_view title) const {
  Row titles{"key", "unit", "type", "range", "default", "meaning"};
  std::array<std::size_t, 6> widths{};
  const auto widen = [&](const Row& row) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  };
  const auto line = [&](const Row& row) {
    std::string text = " ";
    for (std::size_t c = 0; c + 1 < row.size(); ++c) text += fmt::format(" {:<{}} ", row[c], widths[c]);
    return text + fmt::format(" {}\n", row.back());
  };
  widen(titles);
  for (const Group& group : groups_) std::for_each(group.rows.begin(), group.rows.end(), widen);

  std::string text = fmt::format("{}\n\n", title) + line(titles);
  for (const Group& group : groups_) {
    text += fmt::format("\n{}\n", group.heading);
    for (const Row& row : group.rows) text += line(row);
  }
  return text;
}

}  // namespace repose
