#include "base/kept_memory.h"

#include <limits>

#include "base/big_vector.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace repose {

void keep_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(huge_page));
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace repose
