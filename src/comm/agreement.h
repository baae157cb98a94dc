#pragma once

#include <functional>
#include <string>

#include "comm/communicator.h"

namespace repose {

/// Collective. Does `work` on this rank; when it threw on any rank, throws on every rank, with the message and exit
/// code of the lowest rank that failed (FileError for what is no Error). So no rank goes on (or waits) where another
/// has given up.
void agree_after(const Communicator& comm, const std::function<void()>& work);

/// Collective. Like agree_after, but only rank 0 does the work.
void agree_after_root(const Communicator& comm, const std::function<void()>& work);

}  // namespace repose
