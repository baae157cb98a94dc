#pragma once

#include <cstddef>
#include <vector>

namespace repose {

/// Memory that a vector holds, in use or not.
template <class T, class Allocator>
std::size_t bytes_of(const std::vector<T, Allocator>& items) {
  return items.capacity() * sizeof(T);
}

}  // namespace repose
