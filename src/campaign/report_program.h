#pragma once

#include <memory>
#include <string>

#include "files/child_process.h"

namespace repose {

/// Starts Python on the package beside the program, to make the report of a directory; `output` may be empty. FileError
/// when there is no package or no Python.
std::unique_ptr<ChildProcess> start_report(const std::string& directory, const std::string& output,
                                           ChildProcess::Says says);

/// Waits for its end and prints what Python has said; its last line becomes the Error when it has failed.
void finish_report(ChildProcess& python);

}  // namespace repose
