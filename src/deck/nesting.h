#pragma once

#include <string_view>

namespace repose {

/// Whether a key of TOML text has more parts ("a.b.c" has three) than any deck needs. The parser makes a table in a
/// table of each, and takes them apart by recursion: it must not be given the text.
bool has_deep_key(std::string_view toml);

/// The most parts that a key may have.
inline constexpr int most_key_parts = 20;

}  // namespace repose
