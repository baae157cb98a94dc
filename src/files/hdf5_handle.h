#pragma once

#include <string>
#include <utility>

#include <hdf5.h>

namespace repose {

/// The innermost message on HDF5's error stack (with MPI's own text, when MPI failed), and clears the stack.
std::string hdf5_error_text();

/// Throws FileError "<path>: cannot <action>: <HDF5's reason>" when `code`, the result of an HDF5 call, is negative.
template <class Code>
Code check_hdf5(Code code, const std::string& path, const std::string& action);

/// Owner of an HDF5 identifier, closed by `close`.
template <herr_t (*close)(hid_t)>
class Hdf5Handle {
 public:
  explicit Hdf5Handle(hid_t id) : id_(id) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  hid_t get() const { return id_; }
  /// Gives up ownership, for a close whose failure must be seen.
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

 private:
  hid_t id_;
};

using Hdf5FileHandle = Hdf5Handle<H5Fclose>;
using Hdf5Group = Hdf5Handle<H5Gclose>;
using Hdf5Object = Hdf5Handle<H5Oclose>;
using Hdf5Dataset = Hdf5Handle<H5Dclose>;
using Hdf5Attribute = Hdf5Handle<H5Aclose>;
using Hdf5Space = Hdf5Handle<H5Sclose>;
using Hdf5Type = Hdf5Handle<H5Tclose>;
using Hdf5Properties = Hdf5Handle<H5Pclose>;

[[noreturn]] void throw_hdf5_error(const std::string& path, const std::string& action);

template <class Code>
Code check_hdf5(Code code, const std::string& path, const std::string& action) {
  if (code < 0) throw_hdf5_error(path, action);
  return code;
}

}  // namespace repose
