#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/hdf5_handle.h"

namespace repose {

/// All values, row by row, of an array of so many columns (one: of one dimension) in an HDF5 file that is in memory and
/// has `file_bytes` bytes; T is double or std::int32_t, and the array must be of its kind. `file` is the name in
/// messages. FileError when the array is not there, is another or is not complete, claims more values than the file can
/// hold, or lies in another file.
template <class T>
std::vector<T> read_hdf5_array(const Hdf5FileHandle& image, const std::string& path, int columns,
                               std::size_t file_bytes, const std::string& file);

}  // namespace repose
