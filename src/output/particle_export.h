#pragma once

#include <string>
#include <vector>

#include "output/file_contents.h"

namespace repose {

/// Particles as a file of VTK's XML format for PolyData (.vtp): one vertex each, the arrays of a snapshot as point data
/// under the same names, the time as field data `TimeValue`.
/// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html; raw appended data.
std::string vtp_text(const SnapshotParticles& snapshot);

/// Particles as a list that `repose measure` and decks read: x,y,z,vx,vy,vz,wx,wy,wz,radius,material, in numbers that
/// read back exactly.
std::string csv_text(const SnapshotParticles& snapshot);

/// A format of `repose export`.
struct ExportFormat {
  std::string name;
  std::string meaning;  ///< in the help
  std::string (*text)(const SnapshotParticles& snapshot);
  std::string mark;  ///< every file of this format has it near its beginning, and none that other commands write
};
const std::vector<ExportFormat>& export_formats();

}  // namespace repose
