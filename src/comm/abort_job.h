#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// Says a line on standard error and ends all processes of the job with exit code 1. For errors that have come up on
/// this rank alone, perhaps: the others may wait for it for ever.
[[noreturn]] void abort_job(const Communicator& comm, const std::string& what);

}  // namespace repose
