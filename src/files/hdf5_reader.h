#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "files/hdf5_file.h"
#include "files/hdf5_handle.h"

namespace repose {

/// An HDF5 file open for reading, by one rank on its own. What is missing, of another kind than expected, or in another
/// file is a FileError that names the file. The length of an array is believed only as far as the file can hold it.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::string& path);
  /// The bytes of a whole file that is a `kind` (for messages, as "snapshot"); errors name it `file`.
  static Hdf5Reader of_bytes(const std::string& bytes, const std::string& file, const std::string& kind);

  const std::string& name() const { return name_; }

  /// Attributes of the root.
  std::int64_t read_integer(const std::string& name) const;
  double read_real(const std::string& name) const;
  std::string read_text(const std::string& name) const;
  std::vector<std::string> read_texts(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  /// An attribute of an array.
  std::vector<std::string> read_texts(const std::string& name, const std::string& dataset) const;
  /// Whether there is a group or an array of this name; the group it is in must be there.
  bool has(const std::string& object) const;

  /// Rows of an array of one or two dimensions. With T = double an array of real numbers is expected, else one of
  /// integers.
  std::int64_t rows(const std::string& dataset) const;
  /// Its rows begin to end - 1, which must be there and have so many columns (one: an array of one dimension).
  template <class T>
  std::vector<T> read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end) const {
    std::vector<T> values;
    read_rows(dataset, columns, begin, end, hdf5_type<T>(), [&](std::size_t count) {
      values.resize(count);
      return static_cast<void*>(values.data());
    });
    return values;
  }
  template <class T>
  std::vector<T> read_rows(const std::string& dataset, int columns) const {
    return read_rows<T>(dataset, columns, 0, rows(dataset));
  }
  /// A column of texts as Hdf5File::write_texts makes it.
  std::vector<std::string> read_text_rows(const std::string& dataset) const;

 private:
  Hdf5Reader(Hdf5FileHandle file, std::string name, std::uint64_t bytes)
      : file_(std::move(file)), name_(std::move(name)), bytes_(bytes) {}
  Hdf5Dataset open(const std::string& dataset) const;
  Hdf5Attribute open_scalar(const std::string& attribute) const;
  void read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end, hid_t type,
                 const std::function<void*(std::size_t)>& allocate) const;

  Hdf5FileHandle file_;
  std::string name_;
  std::uint64_t bytes_;  ///< of the whole file
};

}  // namespace repose
