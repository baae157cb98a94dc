#include "files/hdf5_handle.h"

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

namespace {

herr_t take_innermost(unsigned depth, const H5E_error2_t* entry, void* text) {
  if (depth == 0 && entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

}  // namespace

std::string hdf5_error_text() {
  std::string text = "unknown HDF5 error";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_innermost, &text);
  H5Eclear2(H5E_DEFAULT);
  return text;
}

void throw_hdf5_error(const std::string& path, const std::string& action) {
  throw FileError(fmt::format("{}: cannot {}: {}", path, action, hdf5_error_text()));
}

}  // namespace repose
