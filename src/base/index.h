#pragma once

#include <cstddef>
#include <cstdint>

namespace repose {

/// The place in an array of what is counted in 32 bits; it must not be negative.
constexpr std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace repose
