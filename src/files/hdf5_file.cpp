#include "files/hdf5_file.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "files/disk_space.h"
#include "files/file_seal.h"
#include "files/hdf5_attribute.h"

namespace repose {

namespace {

// 2 to 6 MiB each.
constexpr std::int64_t rows_per_chunk = 262144;

Hdf5Space array_space(std::int64_t rows, int columns) {
  const std::array<hsize_t, 2> size{static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
  return Hdf5Space(H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr));
}

Hdf5Properties array_properties(std::int64_t rows, int columns, int deflate_level) {
  Hdf5Properties properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(properties.get(), false);
  if (rows == 0) return properties;  // a chunk has at least one row
  if (deflate_level == 0) {
    H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);  // each rank has to know where its rows go
    H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER);
    return properties;
  }
  const std::array<hsize_t, 2> chunk{static_cast<hsize_t>(std::min(rows, rows_per_chunk)),
                                     static_cast<hsize_t>(columns)};
  H5Pset_chunk(properties.get(), columns == 1 ? 1 : 2, chunk.data());
  H5Pset_shuffle(properties.get());
  H5Pset_deflate(properties.get(), static_cast<unsigned>(deflate_level));
  return properties;
}

/// For a group, and for a file, which creates its root group.
Hdf5Properties group_properties(hid_t kind) {
  constexpr std::size_t name_bytes = 1024;
  Hdf5Properties properties(H5Pcreate(kind));
  H5Pset_obj_track_times(properties.get(), false);
  // A table of names that has to grow is left with bytes that nobody wrote (HDF5 1.10).
  H5Pset_local_heap_size_hint(properties.get(), name_bytes);
  return properties;
}

}  // namespace

template <>
hid_t hdf5_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t hdf5_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t hdf5_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
hid_t hdf5_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

Hdf5File::Hdf5File(const Communicator& comm, std::string path, std::int64_t most_bytes, int deflate_level)
    : comm_(comm), path_(std::move(path)), deflate_level_(deflate_level), file_(H5I_INVALID_HID) {
  agree_after_root(comm_, [&] { refuse_special_file(path_); });
  try {
    agree_after_root(comm_, [&] {
      // Reserved before, for the system's clear words, and after, as the new file starts from nothing.
      reserve_space(partial_path(path_), most_bytes, path_);
      create();
      reserve_space(partial_path(path_), most_bytes, path_, FileSize::kept);
    });
    agree_after(comm_, [&] { rows_.emplace(partial_path(path_), O_WRONLY, path_); });
  } catch (const FileError&) {
    discard();
    throw;
  }
}

Hdf5File::~Hdf5File() {
  if (!closed_) discard();
}

void Hdf5File::discard() noexcept {
  closed_ = true;
  rows_.reset();
  if (disk_) disk_->give_up();
  file_ = Hdf5FileHandle(H5I_INVALID_HID);
  if (comm_.is_root()) discard_partial_file(path_);
}

void Hdf5File::create() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions, once
  disk_ = std::make_unique<Hdf5Disk>(partial_path(path_), path_);
  const Hdf5Properties access = disk_->access();
  const Hdf5Properties creation = group_properties(H5P_FILE_CREATE);
  H5Pset_userblock(creation.get(), seal_bytes);
  const std::string partial = partial_path(path_);
  file_ = Hdf5FileHandle(
      check_hdf5(H5Fcreate(partial.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), path_, "create"));
  disk_->check();
}

void Hdf5File::lead_hdf5(const std::function<void()>& work) {
  agree_after_root(comm_, [&] {
    try {
      work();
    } catch (const FileError&) {
      disk_->check();  // the reason of the reason
      throw;
    }
    disk_->check();
  });
}

void Hdf5File::create_group(const std::string& group) {
  lead_hdf5([&] {
    const Hdf5Properties creation = group_properties(H5P_GROUP_CREATE);
    const Hdf5Group handle(check_hdf5(H5Gcreate2(file_.get(), group.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                                      path_, "create the group " + group));
  });
}

void Hdf5File::link(const std::string& existing, const std::string& alias) {
  lead_hdf5([&] {
    check_hdf5(H5Lcreate_hard(file_.get(), existing.c_str(), file_.get(), alias.c_str(), H5P_DEFAULT, H5P_DEFAULT),
               path_, "link " + existing + " to " + alias);
  });
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, hid_t type, const Hdf5Space& space,
                               const void* values) {
  lead_hdf5([&] { write_hdf5_attribute(file_, path_, object, name, type, space, values); });
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const char* start = text.c_str();
  write_attribute(object, name, hdf5_text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), Hdf5Space(H5Screate(H5S_SCALAR)),
                  &start);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts) {
  std::vector<const char*> starts;
  for (const std::string& text : texts) starts.push_back(text.c_str());
  write_attribute(object, name, hdf5_text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), array_space(std::ssize(texts), 1),
                  starts.data());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  write_attribute(object, name, hdf5_type<std::int64_t>(), Hdf5Space(H5Screate(H5S_SCALAR)), &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(object, name, hdf5_type<double>(), Hdf5Space(H5Screate(H5S_SCALAR)), &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               std::span<const std::int64_t> values) {
  write_attribute(object, name, hdf5_type<std::int64_t>(), array_space(std::ssize(values), 1), values.data());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::span<const double> values) {
  write_attribute(object, name, hdf5_type<double>(), array_space(std::ssize(values), 1), values.data());
}

void Hdf5File::write_ascii_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Type type = hdf5_text_type(text.size(), H5T_CSET_ASCII);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);  // the reader of VTK 9.2 takes a zero at the end for a part of the text
  write_attribute(object, name, type.get(), Hdf5Space(H5Screate(H5S_SCALAR)), text.c_str());
}

void Hdf5File::write_rows(const std::string& dataset, hid_t type, const void* values, std::size_t size, RowBlock block,
                          int columns) {
  agree_after(comm_, [&] {
    if (static_cast<std::int64_t>(size) != block.count * columns) {
      throw std::logic_error(fmt::format("{}: {}: {} values for {} rows", path_, dataset, size, block.count));
    }
    if (block.count < 0 || (block.count > 0 && (block.offset < 0 || block.offset + block.count > block.total))) {
      throw std::logic_error(fmt::format("{}: {}: rows {} to {} of {}", path_, dataset, block.offset,
                                         block.offset + block.count, block.total));
    }
  });
  Hdf5Dataset array(H5I_INVALID_HID);
  lead_hdf5([&] {
    const Hdf5Space space = array_space(block.total, columns);
    const Hdf5Properties creation = array_properties(block.total, columns, deflate_level_);
    array = Hdf5Dataset(check_hdf5(
        H5Dcreate2(file_.get(), dataset.c_str(), type, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), path_,
        "write " + dataset));
  });
  const RowBytes rows{static_cast<const char*>(values), H5Tget_size(type) * static_cast<std::size_t>(columns)};
  if (block.total > 0 && deflate_level_ > 0) {
    write_compressed(array, dataset, type, rows, block);
  } else if (block.total > 0) {
    write_in_place(array, dataset, rows, block);
  }
  lead_hdf5([&] { check_hdf5(H5Dclose(array.release()), path_, "write " + dataset); });
}

void Hdf5File::write_texts(const std::string& dataset, std::span<const std::string> texts) {
  std::size_t longest = 0;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  const std::size_t length = longest + 1;
  std::string rows;
  for (const std::string& text : texts) rows += text + std::string(length - text.size(), '\0');
  const std::int64_t count = std::ssize(texts);
  const std::int64_t here = comm_.is_root() ? count : 0;
  write_rows(dataset, hdf5_text_type(length, H5T_CSET_UTF8).get(), rows.data(), static_cast<std::size_t>(here),
             {count, 0, here}, 1);
}

/// Chunk by chunk: HDF5 compresses on rank 0.
void Hdf5File::write_compressed(const Hdf5Dataset& array, const std::string& dataset, hid_t type, RowBytes rows,
                                RowBlock block) {
  for (std::int64_t first = 0; first < block.total; first += rows_per_chunk) {
    const std::int64_t count = std::min(rows_per_chunk, block.total - first);
    const std::vector<char> chunk = gather_rows(rows, block, first, count);
    lead_hdf5([&] {
      const Hdf5Space disk(check_hdf5(H5Dget_space(array.get()), path_, "write " + dataset));
      std::array<hsize_t, 2> start{0, 0};
      std::array<hsize_t, 2> extent{0, 0};
      H5Sget_simple_extent_dims(disk.get(), extent.data(), nullptr);
      start[0] = static_cast<hsize_t>(first);
      extent[0] = static_cast<hsize_t>(count);
      H5Sselect_hyperslab(disk.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr);
      const Hdf5Space memory(H5Screate_simple(H5Sget_simple_extent_ndims(disk.get()), extent.data(), nullptr));
      check_hdf5(H5Dwrite(array.get(), type, memory.get(), disk.get(), H5P_DEFAULT, chunk.data()), path_,
                 "write " + dataset);
    });
  }
}

/// The rows [first, first + count) of all ranks, in order, on rank 0.
std::vector<char> Hdf5File::gather_rows(RowBytes rows, RowBlock block, std::int64_t first, std::int64_t count) const {
  const std::int64_t begin = std::clamp(block.offset, first, first + count);
  const std::int64_t end = std::clamp(block.offset + block.count, begin, first + count);
  const std::size_t bytes = static_cast<std::size_t>(end - begin) * rows.each;
  const char* const start =
      bytes == 0 ? nullptr : rows.first + static_cast<std::size_t>(begin - block.offset) * rows.each;
  const std::vector<std::int64_t> begins = comm_.all_gather(begin);
  const std::vector<std::int64_t> sizes = comm_.all_gather(static_cast<std::int64_t>(bytes));
  const std::vector<char> pieces = comm_.gather(std::vector<char>(start, start + bytes));
  std::vector<char> chunk(pieces.size());
  if (!comm_.is_root()) return chunk;
  auto piece = pieces.begin();
  for (std::size_t r = 0; r < begins.size(); ++r) {
    const auto place = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(begins[r] - first) * rows.each);
    std::copy(piece, piece + sizes[r], chunk.begin() + place);
    piece += sizes[r];
  }
  return chunk;
}

/// HDF5 says where the array lies in the file; there each rank puts its rows itself.
void Hdf5File::write_in_place(const Hdf5Dataset& array, const std::string& dataset, RowBytes rows, RowBlock block) {
  std::int64_t place = 0;
  lead_hdf5([&] {
    const haddr_t offset = H5Dget_offset(array.get());
    if (offset == HADDR_UNDEF) throw_hdf5_error(path_, "find the place of " + dataset);
    place = static_cast<std::int64_t>(offset);
  });
  comm_.broadcast(place);
  agree_after(comm_, [&] {
    const auto before = static_cast<std::int64_t>(rows.each) * block.offset;
    rows_->write_at({rows.first, rows.each * static_cast<std::size_t>(block.count)}, place + before);
  });
}

void Hdf5File::close() {
  try {
    agree_after(comm_, [this] {
      rows_->sync();
      rows_->close();
    });
    lead_hdf5([this] {
      check_hdf5(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), path_, "write");
      check_hdf5(H5Fclose(file_.release()), path_, "close");
      release_space(partial_path(path_), path_);
    });
    seal_file(comm_, partial_path(path_), path_);
    agree_after_root(comm_, [this] { publish_file(path_); });
    closed_ = true;
  } catch (const FileError&) {
    discard();
    throw;
  }
}

}  // namespace repose
