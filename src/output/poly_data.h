#pragma once

#include <cstddef>
#include <string>

#include "output/vtk_arrays.h"

namespace repose {

/// Of a file of PolyData of VTK, in one piece.
struct PolyDataCounts {
  std::size_t points = 0;
  std::size_t verts = 0;
  std::size_t lines = 0;
  std::size_t polys = 0;
};

/// Its beginning: the time in s, and the piece, whose arrays are to follow.
std::string poly_data_begin(VtkArrays& data, double time_s, const PolyDataCounts& counts);

/// What follows the arrays of the piece: their bytes.
std::string poly_data_end(const VtkArrays& data);

}  // namespace repose
