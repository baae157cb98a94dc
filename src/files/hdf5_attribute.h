#pragma once

#include <string>

#include "files/hdf5_handle.h"

namespace repose {

/// Text of `length` bytes, or of any length (H5T_VARIABLE).
Hdf5Type hdf5_text_type(std::size_t length, H5T_cset_t characters);

/// Gives an object of an open file a new attribute. FileError that names the file.
void write_hdf5_attribute(const Hdf5FileHandle& file, const std::string& path, const std::string& object,
                          const std::string& name, hid_t type, const Hdf5Space& space, const void* values);

}  // namespace repose
