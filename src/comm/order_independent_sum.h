#pragma once

#include <span>

#include "comm/communicator.h"

namespace repose {

/// Collective. Sum of the finite values of all ranks, the same bits for any distribution and order: each value is
/// rounded to a multiple of a common unit, 2^-61 of the power of two above anything the sum may reach, and the integers
/// are added.
double order_independent_sum(const Communicator& comm, std::span<const double> values);

}  // namespace repose
