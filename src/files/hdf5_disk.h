#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <hdf5.h>

#include "files/file_descriptor.h"
#include "files/hdf5_handle.h"

namespace repose {

/// A new file as HDF5 sees it: one on which writing never fails. HDF5 (1.10) does not survive a failure to write: it
/// cannot close the file any more and crashes when the program ends. So a failure is kept here instead, nothing more is
/// written after it, and who leads HDF5 asks after each step.
class Hdf5Disk {
 public:
  /// Creates or empties the file `opened`; errors name `path`.
  Hdf5Disk(const std::string& opened, std::string path);
  Hdf5Disk(const Hdf5Disk&) = delete;
  Hdf5Disk& operator=(const Hdf5Disk&) = delete;

  /// Access properties by which HDF5 opens this file, under any name. The disk must outlive the open file.
  Hdf5Properties access();
  /// Throws FileError when a write has failed.
  void check() const;
  /// From now on nothing is written: HDF5 can close a file that is to be thrown away.
  void give_up() noexcept;

  // For HDF5.
  void read(std::uint64_t place, char* bytes, std::size_t size) const noexcept;
  void write(std::uint64_t place, std::string_view bytes) noexcept;
  void set_length(std::uint64_t bytes) noexcept;

 private:
  template <class Work>
  void attempt(const Work& work) noexcept;

  std::string path_;
  FileDescriptor file_;
  bool usable_ = true;
  std::string error_;
};

}  // namespace repose
