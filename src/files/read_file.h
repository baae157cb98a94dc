#pragma once

#include <functional>
#include <string>

namespace repose {

/// The bytes of a file named in the deck. On several ranks it must give all of them the same.
using ReadFile = std::function<std::string(const std::string&)>;

}  // namespace repose
