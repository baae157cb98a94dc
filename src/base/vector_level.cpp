#include "base/vector_level.h"

#include "base/error.h"

namespace repose {
namespace {

bool has(VectorLevel level) {
#if defined(__x86_64__)
  if (level == VectorLevel::avx512) return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (level == VectorLevel::avx2) return __builtin_cpu_supports("avx2");
#endif
  return level == VectorLevel::sse2;
}

}  // namespace

VectorLevel best_vector_level() {
  if (has(VectorLevel::avx512)) return VectorLevel::avx512;
  return has(VectorLevel::avx2) ? VectorLevel::avx2 : VectorLevel::sse2;
}

VectorLevel vector_level_from(const std::string& name) {
  if (name.empty() || name == "auto") return best_vector_level();
  for (const VectorLevel level : {VectorLevel::sse2, VectorLevel::avx2, VectorLevel::avx512}) {
    if (name != to_string(level)) continue;
    if (has(level)) return level;
    throw DeckError("--vector-level " + name + ": this processor lacks it; the best it has is " +
                    to_string(best_vector_level()));
  }
  throw DeckError("--vector-level " + name + ": not a vector level; one of auto, sse2, avx2, avx512");
}

std::string to_string(VectorLevel level) {
  if (level == VectorLevel::avx512) return "avx512";
  return level == VectorLevel::avx2 ? "avx2" : "sse2";
}

}  // namespace repose
