#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "output/hdf5_file.h"
#include "output/hdf5_handle.h"

namespace repose {

/// An HDF5 file open for reading, by one rank on its own. What is missing or of another kind than expected is a
/// FileError that names the file. The length of an array is believed only as far as the file holds its values.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::string& path);
  /// The bytes of a whole file; errors name it `file`.
  static Hdf5Reader of_bytes(const std::string& bytes, const std::string& file);

  const std::string& name() const { return name_; }

  /// Attributes of the root.
  bool has_attribute(const std::string& name) const;
  std::int64_t read_integer(const std::string& name) const;
  double read_real(const std::string& name) const;
  std::string read_text(const std::string& name) const;

  /// Rows of an array of one or two dimensions.
  std::int64_t rows(const std::string& dataset) const;
  /// Its rows begin to end - 1, which must be there and have so many columns.
  template <class T>
  std::vector<T> read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end) const {
    std::vector<T> values;
    read_rows(dataset, columns, begin, end, hdf5_type<T>(), [&](std::size_t count) {
      values.resize(count);
      return static_cast<void*>(values.data());
    });
    return values;
  }

 private:
  /// Sizes of an open array, which must be plain numbers.
  struct Shape {
    std::int64_t rows, columns;
  };
  Hdf5Reader(Hdf5FileHandle file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  Hdf5Dataset open(const std::string& dataset) const;
  Shape shape_of(const Hdf5Dataset& handle, const std::string& dataset) const;
  Hdf5Attribute open_scalar(const std::string& attribute) const;
  void read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end, hid_t type,
                 const std::function<void*(std::size_t)>& allocate) const;

  Hdf5FileHandle file_;
  std::string name_;
};

}  // namespace repose
