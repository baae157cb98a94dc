#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "output/build_info.h"
#include "output/particle_table.h"

namespace repose {

/// What every snapshot says about the run that it comes from.
struct SnapshotHeader {
  std::int64_t step = 0;
  double time_s = 0.0;
  std::string deck;  ///< resolved, TOML
  BuildInfo build;
  std::string state_hash;
  std::int64_t inserted = 0;
  std::int64_t inside = 0;
  std::int64_t left = 0;
  std::vector<std::string> materials;  ///< names, in the order of ParticleTable::material
};

/// Collective. Writes the particles to `path`, which must end in .hdf, whole or not at all: arrays under /particles for
/// h5py, the same arrays linked under /VTKHDF (VTKHDF 1.0, UnstructuredGrid of vertices) for ParaView and VTK's
/// vtkHDFReader, the header as attributes of the root. The same particles and header give the same bytes for any number
/// of ranks. On an error FileError on all ranks, and nothing is left behind.
void write_snapshot(const Communicator& comm, const std::string& path, const ParticleTable& particles,
                    const SnapshotHeader& header);

}  // namespace repose
