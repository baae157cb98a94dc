#include "comm/order_independent_sum.h"

#include <algorithm>
#include <cmath>

namespace repose {

double order_independent_sum(const Communicator& comm, std::span<const double> values) {
  double greatest = 0.0;
  for (const double v : values) greatest = std::max(greatest, std::fabs(v));
  greatest = comm.max(greatest);
  const std::int64_t count = comm.sum(static_cast<std::int64_t>(values.size()));
  if (greatest == 0.0) return 0.0;

  int exponent = 0;
  std::frexp(greatest * static_cast<double>(count), &exponent);  // |sum| < 2^exponent
  std::int64_t sum = 0;
  for (const double v : values) sum += static_cast<std::int64_t>(std::rint(std::ldexp(v, 61 - exponent)));
  return std::ldexp(static_cast<double>(comm.sum(sum)), exponent - 61);
}

}  // namespace repose
