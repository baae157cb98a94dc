#include "files/hdf5_attribute.h"

#include <fmt/core.h>

namespace repose {

Hdf5Type hdf5_text_type(std::size_t length, H5T_cset_t characters) {
  Hdf5Type type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), length);
  H5Tset_cset(type.get(), characters);
  return type;
}

void write_hdf5_attribute(const Hdf5FileHandle& file, const std::string& path, const std::string& object,
                          const std::string& name, hid_t type, const Hdf5Space& space, const void* values) {
  const std::string action = fmt::format("write the attribute {} of {}", name, object);
  const Hdf5Object owner(check_hdf5(H5Oopen(file.get(), object.c_str(), H5P_DEFAULT), path, action));
  const Hdf5Attribute attribute(
      check_hdf5(H5Acreate2(owner.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), path, action));
  check_hdf5(H5Awrite(attribute.get(), type, values), path, action);
}

}  // namespace repose
