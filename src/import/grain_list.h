#pragma once

#include <optional>
#include <string_view>

#include "import/imported_scene.h"

namespace repose {

/// Grains of a file, in SI units.
struct GrainList {
  std::vector<Grain> grains;
  std::optional<Extent> box;
  int types = 0;          ///< that the file declares or has
  std::int64_t step = 0;  ///< of a dump
};

/// A data file of read_data with atoms of style granular or sphere (id, type, diameter, density, x, y, z) and perhaps
/// their velocities, by docs.lammps.org/read_data.html. DeckError as `file:line: what`.
GrainList parse_data_file(std::string_view text, const std::string& file, const ScriptUnits& units);

/// The last snapshot of a text dump of style custom or atom, by docs.lammps.org/dump.html: of its columns x, y, z (or
/// xu, xs, ...) and radius or diameter are needed; type, density or mass, velocities and spins are read where they are.
/// A grain without density gets 0. DeckError as above.
GrainList parse_dump(std::string_view text, const std::string& file, const ScriptUnits& units);

/// As a deck reads it: x,y,z,vx,vy,vz,wx,wy,wz,radius,material.
std::string grain_csv(const std::vector<std::pair<Grain, std::string>>& grains_and_materials);

/// Whether a point lies in a region of a kind that is known. DeckError at the region's line for others.
bool is_inside(const ScriptRegion& region, const Vec3& point);

}  // namespace repose
