#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/build_info.h"
#include "scene/insertion/new_particles.h"

namespace repose {

/// What an HDF5 file of repose says of itself, and what was counted in it.
struct FileContents {
  enum class Kind { snapshot, checkpoint, grid };

  /// How many there are of something.
  struct Count {
    std::string name;
    std::int64_t count;
  };

  Kind kind = Kind::snapshot;
  std::string deck;                  ///< TOML; of a grid: the study as it was given
  std::int64_t step = 0;             ///< not of a grid, as all down to state_hash
  double time_s = 0.0;               ///< s
  std::int64_t particles = 0;        ///< rows
  std::int64_t inserted = 0;         ///< snapshot
  std::int64_t left = 0;             ///< snapshot
  std::vector<Count> materials;      ///< particles of each
  std::vector<double> radii;         ///< m, the smallest and the largest; none without particles
  std::string state_hash;            ///< of the whole state
  std::vector<Count> states;         ///< grid: runs in each state
  std::vector<Count> experiments;    ///< grid: runs of each experiment; empty when there is one alone
  std::vector<Count> levels;         ///< grid: runs of each level of the model; empty without levels
  std::vector<std::string> columns;  ///< grid: parameters, in order
  std::vector<std::string> figures;  ///< grid
  std::string version, commit;       ///< of the program that wrote it
  std::string compiler;
};

/// From the bytes of a whole file. FileError, beginning with `file`, when it is damaged or none of the three.
FileContents file_contents(const std::string& bytes, const std::string& file);

/// All that a snapshot says of its particles.
struct SnapshotParticles {
  NewParticles particles;              ///< with ids; materials are indices of the names
  std::vector<std::string> materials;  ///< names
  std::vector<double> mass;            ///< kg
  std::int64_t step = 0;
  double time_s = 0.0;  ///< s
  std::string deck;     ///< TOML
};

/// From the bytes of a whole file. FileError as above, also for a checkpoint or a grid.
SnapshotParticles snapshot_particles(const std::string& bytes, const std::string& file);

}  // namespace repose
