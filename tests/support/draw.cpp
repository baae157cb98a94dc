#include "support/draw.h"

#include "base/philox.h"

namespace repose::test {

double Draw::operator()(double low, double high) {
  return low + (high - low) * uniform(seed_, count_++, RandomStream::insertion_jitter, 0);
}

}  // namespace repose::test
