#include "deck/deck_errors.h"

#include <algorithm>
#include <tuple>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

void DeckErrors::add(const std::string& key, const std::string& message) {
  std::string around = key;
  while (!around.empty() && !places_.contains(around)) {
    const auto dot = around.rfind('.');
    around.resize(dot == std::string::npos ? 0 : dot);
  }
  const auto found = places_.find(around);
  add(found == places_.end() ? KeyPlace{} : found->second, message);
}

void DeckErrors::throw_first() const {
  if (errors_.empty()) return;
  const auto first = std::min_element(errors_.begin(), errors_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  const KeyPlace& place = first->place;
  if (!place.set_text.empty()) throw DeckError(fmt::format("--set {}: {}", place.set_text, first->message));
  throw DeckError(fmt::format("{}:{}:{}: {}", file_, place.line, place.column, first->message));
}

}  // namespace repose
