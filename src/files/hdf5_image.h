#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/hdf5_handle.h"

namespace repose {

/// An HDF5 file in memory, for one rank; plain, without a seal. Errors are FileError that names `name`.
class Hdf5Image {
 public:
  explicit Hdf5Image(std::string name);

  void create_group(const std::string& group);
  void write_attribute(const std::string& object, const std::string& name, const std::string& text);
  void write_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
  /// Texts that all take the bytes of the longest, of this shape; no shape makes a scalar.
  void write_fixed_texts(const std::string& object, const std::string& name, std::span<const std::string> texts,
                         const std::vector<std::uint64_t>& shape);
  /// Values of an array of this shape in the order of rows; no shape makes a scalar.
  void write_array(const std::string& dataset, std::span<const double> values, const std::vector<std::uint64_t>& shape);
  void write_array(const std::string& dataset, std::span<const std::int64_t> values,
                   const std::vector<std::uint64_t>& shape);

  /// The file as it would lie on a disk.
  std::string bytes() const;

 private:
  void write_attribute(const std::string& object, const std::string& name, hid_t type, const Hdf5Space& space,
                       const void* values);
  void write_array(const std::string& dataset, hid_t type, const void* values, const std::vector<std::uint64_t>& shape);

  std::string name_;
  Hdf5FileHandle file_;
};

}  // namespace repose
