#pragma once

#include <cstdint>
#include <string>

#include "fields/grid.h"
#include "fields/state.h"

namespace repose::fields {

/// The fields of one file, ready to be written.
struct FieldsOfFile {
  std::int64_t step = 0;
  double time = 0.0;  ///< s
  std::string vti;    ///< image data of VTK
  std::string lines;  ///< for the user: what the fields are of, and what is not in them
};

/// Half-width of the kernel and spacing of the cells where they are not given (0): three mean diameters of the grains,
/// and a third of that width.
Resolution resolution_for(const State& state, Resolution given);

FieldsOfFile fields_of(const State& state, const std::string& file, const Resolution& resolution);

/// A collection of files with their times, which ParaView reads as one series (.pvd).
std::string series_text(const std::vector<std::pair<double, std::string>>& files);

}  // namespace repose::fields
