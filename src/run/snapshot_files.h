#pragma once

namespace repose {

/// Files that belong to a step, which stands in their names (files/step_file.h). They go when a run starts anew, or
/// goes on from an earlier step.
struct StepFiles {
  const char* prefix;
  const char* ending;
};

inline constexpr StepFiles snapshot_files{"run_", ".hdf"};
inline constexpr StepFiles neighbourhood_files{"neighbourhood_", ".hdf"};  ///< of a guard
inline constexpr StepFiles contacts_files{"contacts_", ".vtp"};
inline constexpr StepFiles walls_files{"walls_", ".vtp"};

}  // namespace repose
