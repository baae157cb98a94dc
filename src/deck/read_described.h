#pragma once

#include <string>
#include <vector>

#include "deck/overrides.h"
#include "deck/parse_toml.h"
#include "deck/reader.h"

namespace repose {

/// Reads a file whose keys describe(visitor, D&) lists (deck/key.h): `text` is its TOML, `path` its name in
/// messages, `overrides` are "key=value" texts. `check(deck, errors)` fills in and adds what connects several keys.
/// DeckError, with the place, on the first mistake.
template <class D, class Check>
D read_described(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
                 Check&& check) {
  toml::table root = parse_toml(text, path);
  const Overridden overridden = apply_overrides(root, overrides);
  DeckErrors errors(path);
  D deck;
  Reader reader(root, overridden, errors);
  describe(reader, deck);
  reader.finish();
  errors.throw_first();
  check(deck, errors);
  errors.throw_first();
  return deck;
}

}  // namespace repose
