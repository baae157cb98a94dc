#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// Collective. What is in a snapshot, a checkpoint or the grid.h5 of a calibration, as lines for a person, on rank 0.
/// FileError when it is none of these.
std::string info_of_file(const Communicator& comm, const std::string& file);

/// Collective. Writes the particles of a snapshot to `output`, as "vtp" or "csv" (output/particle_export.h), and
/// returns a line that says so, on rank 0. FileError.
std::string export_snapshot(const Communicator& comm, const std::string& file, const std::string& format,
                            const std::string& output);

}  // namespace repose
