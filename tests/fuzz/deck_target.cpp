// A deck, and after it lines "--set key=value".
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "scene/particles/materials.h"
#include "scene/walls/wall.h"
#include "target.h"

namespace repose::fuzz {

namespace {

struct Input {
  std::string deck;
  std::vector<std::string> overrides;
};

Input divided(std::string_view text) {
  constexpr std::string_view mark = "\n--set ";
  std::vector<std::string> parts;
  for (std::size_t end = text.find(mark); end != text.npos; end = text.find(mark)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + mark.size());
  }
  parts.emplace_back(text);
  return {parts.front(), {parts.begin() + 1, parts.end()}};
}

/// What is written of a deck that was accepted is read as the same deck.
void check_round_trip(const Deck& deck) {
  const std::string text = resolved_deck(deck);
  std::string again;
  const bool is_read = is_done([&] { again = resolved_deck(read_deck(text, "resolved.toml", {})); });
  expect(is_read, "a resolved deck is accepted: " + text);
  expect(again == text, "a resolved deck is read as it is: " + text + "\n" + again);
}

}  // namespace

bool accepts(std::string_view text) {
  const Input input = divided(text);
  Deck deck;
  if (!is_done([&] { deck = read_deck(input.deck, "deck.toml", input.overrides); })) return false;
  check_round_trip(deck);
  is_done([&] { const MaterialTable materials(deck); });
  const ReadFile no_file = [](const std::string& file) -> std::string { throw FileError(file); };
  for (const WallDeck& wall : deck.walls) is_done([&] { make_wall(wall, 0, no_file); });
  return true;
}

}  // namespace repose::fuzz
