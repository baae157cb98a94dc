#include "base/vector_level.h"

#include <array>

#include "base/error.h"

namespace repose {
namespace {

constexpr std::array levels = {VectorLevel::sse2, VectorLevel::avx2, VectorLevel::avx512x4, VectorLevel::avx512};

/// Whether registers of 512 bits are worked on in two halves: then eight lanes take longer than twice four
/// (docs/performance.md).
bool halves_512_bits() {
#if defined(__x86_64__)
  return __builtin_cpu_is("amdfam19h");
#else
  return true;
#endif
}

}  // namespace

bool is_available(VectorLevel level) {
#if defined(__x86_64__)
  if (level >= VectorLevel::avx512x4) return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (level == VectorLevel::avx2) return __builtin_cpu_supports("avx2");
#endif
  return level == VectorLevel::sse2;
}

VectorLevel best_vector_level() {
  if (is_available(VectorLevel::avx512)) return halves_512_bits() ? VectorLevel::avx512x4 : VectorLevel::avx512;
  return is_available(VectorLevel::avx2) ? VectorLevel::avx2 : VectorLevel::sse2;
}

VectorLevel vector_level_from(const std::string& name) {
  if (name.empty() || name == "auto") return best_vector_level();
  std::string names = "auto";
  for (const VectorLevel level : levels) {
    names += ", " + to_string(level);
    if (name != to_string(level)) continue;
    if (is_available(level)) return level;
    throw DeckError("--vector-level " + name + ": this processor lacks it; the best it has is " +
                    to_string(best_vector_level()));
  }
  throw DeckError("--vector-level " + name + ": not a vector level; one of " + names);
}

std::string to_string(VectorLevel level) {
  if (level == VectorLevel::avx512) return "avx512";
  if (level == VectorLevel::avx512x4) return "avx512x4";
  return level == VectorLevel::avx2 ? "avx2" : "sse2";
}

}  // namespace repose
