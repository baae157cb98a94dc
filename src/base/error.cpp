#include "base/error.h"

#include <algorithm>

namespace repose {

std::string one_line(std::string message) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(message.begin(), message.end(), is_control, '?');
  return message;
}

}  // namespace repose
