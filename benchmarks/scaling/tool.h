#pragma once

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "comm/communicator.h"

namespace repose {

/// The main function of a tool: run(words) with the words of the command line under MPI, at least `least` of them.
/// Returns the exit code; an error is one line.
template <class Run>
int run_tool(int argc, char** argv, int least, const char* usage, const Run& run) {
  const MpiGuard mpi(&argc, &argv);
  if (argc <= least) {
    std::fprintf(stderr, "usage: %s\n", usage);
    return 2;
  }
  try {
    run(std::vector<std::string>(argv + 1, argv + argc));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ERROR: %s\n", error.what());
    return 1;
  }
}

}  // namespace repose
