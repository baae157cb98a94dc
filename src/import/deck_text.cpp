#include "import/deck_text.h"

#include <cctype>

namespace repose {

std::string DeckNames::take(const std::string& wanted) {
  std::string name;
  for (const char c : wanted) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    name += is_plain ? c : '_';
  }
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0) name = "w" + name;
  const std::string stem = name;
  for (int k = 2; !taken_.insert(name).second; ++k) name = stem + "_" + std::to_string(k);
  return name;
}

}  // namespace repose
