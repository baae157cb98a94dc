#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "files/file_descriptor.h"
#include "files/hdf5_disk.h"
#include "files/hdf5_handle.h"

namespace repose {

/// The rows [offset, offset + count) that this rank holds of an array of `total` rows. Over the ranks they cover the
/// array once; a rank may hold none.
struct RowBlock {
  std::int64_t total = 0;
  std::int64_t offset = 0;
  std::int64_t count = 0;
};

/// The HDF5 type of T in memory.
template <class T>
hid_t hdf5_type();

/// A new HDF5 file written by all ranks of a communicator together, which appears whole and sealed (file_seal.h) at
/// close() or not at all. Every member is collective and all ranks pass the same arguments (arrays: the same names,
/// their own rows). An error on any rank throws FileError, which names the file, on all of them. The bytes of the file
/// do not tell when and on how many ranks it was written.
///
/// Only rank 0 has the file open in HDF5. Rows go into a compressed array through rank 0, into any other by each rank
/// at their place. So every call that can fail is one of a single rank, after which the ranks agree. HDF5's collective
/// mode knows no such agreement: a disk that fails one rank leaves the others waiting for ever.
class Hdf5File {
 public:
  /// Starts `path` under a name beside it. `most_bytes`, a generous bound on its size, is set aside on the disk: a full
  /// disk is an error here, before the work. `deflate_level` 1 (fast) to 4 (small) applies to every array, 0 is off.
  Hdf5File(const Communicator& comm, std::string path, std::int64_t most_bytes, int deflate_level = 1);
  /// Without a close() before, removes what was written.
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void create_group(const std::string& group);
  /// A second name for an object that exists.
  void link(const std::string& existing, const std::string& alias);

  /// Text as UTF-8 of any length; h5py reads a str.
  void write_attribute(const std::string& object, const std::string& name, const std::string& text);
  void write_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
  void write_attribute(const std::string& object, const std::string& name, std::span<const double> values);
  /// Text as a fixed-length ASCII string, the only kind that VTK's reader takes.
  void write_ascii_attribute(const std::string& object, const std::string& name, const std::string& text);

  /// Writes an array of block.total rows of `columns` values, row by row; one column makes an array of one dimension.
  template <class T>
  void write_rows(const std::string& dataset, std::span<const T> values, RowBlock block, int columns = 1) {
    write_rows(dataset, hdf5_type<T>(), values.data(), values.size(), block, columns);
  }

  /// Writes a column of UTF-8 texts, of which all ranks pass the same; h5py reads bytes. No text may have a zero byte.
  void write_texts(const std::string& dataset, std::span<const std::string> texts);

  /// Completes the file and gives it its name; nothing may follow.
  void close();

 private:
  /// Rows in memory and the size of each.
  struct RowBytes {
    const char* first;
    std::size_t each;
  };
  void create();
  /// Collective. Rank 0 does some work in HDF5; its errors and those of the disk are thrown on all ranks.
  void lead_hdf5(const std::function<void()>& work);
  void discard() noexcept;
  void write_rows(const std::string& dataset, hid_t type, const void* values, std::size_t size, RowBlock block,
                  int columns);
  void write_compressed(const Hdf5Dataset& array, const std::string& dataset, hid_t type, RowBytes rows,
                        RowBlock block);
  void write_in_place(const Hdf5Dataset& array, const std::string& dataset, RowBytes rows, RowBlock block);
  std::vector<char> gather_rows(RowBytes rows, RowBlock block, std::int64_t first, std::int64_t count) const;
  void write_attribute(const std::string& object, const std::string& name, hid_t type, const Hdf5Space& space,
                       const void* values);

  const Communicator& comm_;
  std::string path_;
  int deflate_level_;
  bool closed_ = false;
  std::unique_ptr<Hdf5Disk> disk_;      ///< on rank 0
  Hdf5FileHandle file_;                 ///< on rank 0
  std::optional<FileDescriptor> rows_;  ///< for the rows that each rank writes itself
};

}  // namespace repose
