#pragma once

#include <vector>

#include "base/error.h"
#include "base/vector_level.h"

namespace repose::test {

/// The vector levels of this processor.
inline std::vector<VectorLevel> levels_here() {
  std::vector<VectorLevel> levels;
  for (const char* name : {"sse2", "avx2", "avx512"}) {
    try {
      levels.push_back(vector_level_from(name));
    } catch (const DeckError&) {  // this processor lacks it
    }
  }
  return levels;
}

}  // namespace repose::test
