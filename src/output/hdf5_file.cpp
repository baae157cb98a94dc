#include "output/hdf5_file.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "output/agreement.h"
#include "output/atomic_file.h"
#include "output/disk_space.h"
#include "output/file_seal.h"

namespace repose {

namespace {

// Large, as with several chunks their order in the file depends on who wrote them; 2 to 6 MiB each.
constexpr std::int64_t rows_per_chunk = 262144;

Hdf5Space array_space(std::int64_t rows, int columns) {
  const std::array<hsize_t, 2> size{static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)};
  return Hdf5Space(H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr));
}

Hdf5Properties array_properties(std::int64_t rows, int columns, int deflate_level) {
  Hdf5Properties properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(properties.get(), false);
  if (rows == 0 || deflate_level == 0) return properties;  // a chunk has at least one row
  const std::array<hsize_t, 2> chunk{static_cast<hsize_t>(std::min(rows, rows_per_chunk)),
                                     static_cast<hsize_t>(columns)};
  H5Pset_chunk(properties.get(), columns == 1 ? 1 : 2, chunk.data());
  H5Pset_shuffle(properties.get());
  H5Pset_deflate(properties.get(), static_cast<unsigned>(deflate_level));
  return properties;
}

/// Selects this rank's rows of the array on disk; a rank without rows takes part in the write with an empty selection.
void select_rows(const Hdf5Space& space, RowBlock block, int columns) {
  if (block.count == 0) {
    H5Sselect_none(space.get());
    return;
  }
  const std::array<hsize_t, 2> start{static_cast<hsize_t>(block.offset), 0};
  const std::array<hsize_t, 2> count{static_cast<hsize_t>(block.count), static_cast<hsize_t>(columns)};
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
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

Hdf5Type text_type(std::size_t length, H5T_cset_t characters) {
  Hdf5Type type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), length);
  H5Tset_cset(type.get(), characters);
  return type;
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
  // Reserved before, for the first write of HDF5 and for the system's clear words, and after, as HDF5 starts from
  // nothing.
  const auto reserve = [&] { reserve_space(partial_path(path_), most_bytes, path_); };
  agree_after_root(comm_, [&] { refuse_special_file(path_); });
  try {
    agree_after_root(comm_, reserve);
    agree_after(comm_, [this] { create(); });
    agree_after_root(comm_, reserve);
  } catch (const FileError&) {
    discard();
    throw;
  }
}

Hdf5File::~Hdf5File() {
  if (file_.get() >= 0) discard();
}

void Hdf5File::discard() noexcept {
  file_ = Hdf5FileHandle(H5I_INVALID_HID);
  if (comm_.is_root()) discard_partial_file(path_);
}

void Hdf5File::create() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions, once
  const Hdf5Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_fapl_mpio(access.get(), comm_.handle(), MPI_INFO_NULL);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  const Hdf5Properties creation = group_properties(H5P_FILE_CREATE);
  H5Pset_userblock(creation.get(), seal_bytes);
  const std::string partial = partial_path(path_);
  file_ = Hdf5FileHandle(
      check_hdf5(H5Fcreate(partial.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), path_, "create"));
}

void Hdf5File::create_group(const std::string& group) {
  agree_after(comm_, [&] {
    const Hdf5Properties creation = group_properties(H5P_GROUP_CREATE);
    const Hdf5Group handle(check_hdf5(H5Gcreate2(file_.get(), group.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                                      path_, "create the group " + group));
  });
}

void Hdf5File::link(const std::string& existing, const std::string& alias) {
  agree_after(comm_, [&] {
    check_hdf5(H5Lcreate_hard(file_.get(), existing.c_str(), file_.get(), alias.c_str(), H5P_DEFAULT, H5P_DEFAULT),
               path_, "link " + existing + " to " + alias);
  });
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, hid_t type, const Hdf5Space& space,
                               const void* values) {
  agree_after(comm_, [&] {
    const std::string action = fmt::format("write the attribute {} of {}", name, object);
    const Hdf5Object owner(check_hdf5(H5Oopen(file_.get(), object.c_str(), H5P_DEFAULT), path_, action));
    const Hdf5Attribute attribute(
        check_hdf5(H5Acreate2(owner.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), path_, action));
    check_hdf5(H5Awrite(attribute.get(), type, values), path_, action);
  });
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const char* start = text.c_str();
  write_attribute(object, name, text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), Hdf5Space(H5Screate(H5S_SCALAR)), &start);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts) {
  std::vector<const char*> starts;
  for (const std::string& text : texts) starts.push_back(text.c_str());
  write_attribute(object, name, text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), array_space(std::ssize(texts), 1),
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
  write_attribute(object, name, text_type(text.size() + 1, H5T_CSET_ASCII).get(), Hdf5Space(H5Screate(H5S_SCALAR)),
                  text.c_str());
}

void Hdf5File::write_rows(const std::string& dataset, hid_t type, const void* values, std::size_t size, RowBlock block,
                          int columns) {
  // Both checks come before the collective call, in which a rank alone with its error would leave the others waiting.
  agree_after(comm_, [&] {
    if (static_cast<std::int64_t>(size) != block.count * columns) {
      throw std::logic_error(fmt::format("{}: {}: {} values for {} rows", path_, dataset, size, block.count));
    }
    if (block.count < 0 || (block.count > 0 && (block.offset < 0 || block.offset + block.count > block.total))) {
      throw std::logic_error(fmt::format("{}: {}: rows {} to {} of {}", path_, dataset, block.offset,
                                         block.offset + block.count, block.total));
    }
  });
  agree_after(comm_, [&] {
    const std::string action = "write " + dataset;
    const Hdf5Space disk = array_space(block.total, columns);
    const Hdf5Space memory = array_space(block.count, columns);
    select_rows(disk, block, columns);
    const Hdf5Properties creation = array_properties(block.total, columns, deflate_level_);
    const Hdf5Dataset handle(
        check_hdf5(H5Dcreate2(file_.get(), dataset.c_str(), type, disk.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                   path_, action));
    if (block.total == 0) return;  // HDF5 1.10 takes no empty selection of an empty array
    const Hdf5Properties transfer(H5Pcreate(H5P_DATASET_XFER));
    H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE);
    check_hdf5(H5Dwrite(handle.get(), type, memory.get(), disk.get(), transfer.get(), values), path_, action);
  });
}

void Hdf5File::close() {
  agree_after(comm_, [this] { check_hdf5(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), path_, "write"); });
  try {
    agree_after(comm_, [this] { check_hdf5(H5Fclose(file_.release()), path_, "close"); });
    seal_file(comm_, partial_path(path_), path_);
    agree_after_root(comm_, [this] { publish_file(path_); });
  } catch (const FileError&) {
    discard();
    throw;
  }
}

}  // namespace repose
