#pragma once

namespace repose {

/// Asks the C library to keep what is freed for what is allocated next, for the rest of the process. New lists free and
/// allocate some hundred bytes per particle every few hundred steps; given back to the system, they would be taken from
/// it again page by page, which costs as much as the lists (docs/performance.md). Blocks of a huge page or more still
/// come from the system, which can give them whole. Without effect beyond glibc.
void keep_freed_memory();

}  // namespace repose
