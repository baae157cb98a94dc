#pragma once

#include <vector>

#include "base/vector_level.h"

namespace repose::test {

/// The vector levels of this processor.
inline std::vector<VectorLevel> levels_here() {
  std::vector<VectorLevel> levels;
  for (const VectorLevel level : {VectorLevel::sse2, VectorLevel::avx2, VectorLevel::avx512x4, VectorLevel::avx512}) {
    if (is_available(level)) levels.push_back(level);
  }
  return levels;
}

}  // namespace repose::test
