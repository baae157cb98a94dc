#include "output/hdf5_reader.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"

namespace repose {
namespace {

Hdf5Properties quiet_access() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions, once
  return Hdf5Properties(H5Pcreate(H5P_FILE_ACCESS));
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path) : file_(H5I_INVALID_HID), name_(path) {
  const Hdf5Properties access = quiet_access();
  H5Pset_file_locking(access.get(), false, true);  // many network file systems have no locks
  file_ = Hdf5FileHandle(check_hdf5(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), path, "read"));
}

/// Needs no disk, so that every rank can do with the bytes that one has read.
Hdf5Reader Hdf5Reader::of_bytes(const std::string& bytes, const std::string& file) {
  constexpr std::size_t increment = 1 << 20;
  const Hdf5Properties access = quiet_access();
  H5Pset_fapl_core(access.get(), increment, false);
  std::string image = bytes;                   // HDF5 asks for memory it could write to
  const char* const name = "/dev/null/image";  // HDF5 refuses the name of a file that is there; this can be none
  H5Pset_file_image(access.get(), image.data(), image.size());
  return {Hdf5FileHandle(check_hdf5(H5Fopen(name, H5F_ACC_RDONLY, access.get()), file, "read as HDF5")), file};
}

bool Hdf5Reader::has_attribute(const std::string& name) const { return H5Aexists(file_.get(), name.c_str()) > 0; }

Hdf5Attribute Hdf5Reader::open_scalar(const std::string& attribute) const {
  const std::string action = "read the attribute " + attribute;
  Hdf5Attribute handle(check_hdf5(H5Aopen(file_.get(), attribute.c_str(), H5P_DEFAULT), name_, action));
  const Hdf5Space space(check_hdf5(H5Aget_space(handle.get()), name_, action));
  if (H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw FileError(fmt::format("{}: the attribute {} is not one value", name_, attribute));
  }
  return handle;
}

std::int64_t Hdf5Reader::read_integer(const std::string& name) const {
  std::int64_t value = 0;
  check_hdf5(H5Aread(open_scalar(name).get(), hdf5_type<std::int64_t>(), &value), name_, "read the attribute " + name);
  return value;
}

double Hdf5Reader::read_real(const std::string& name) const {
  double value = 0.0;
  check_hdf5(H5Aread(open_scalar(name).get(), hdf5_type<double>(), &value), name_, "read the attribute " + name);
  return value;
}

std::string Hdf5Reader::read_text(const std::string& name) const {
  const std::string action = "read the attribute " + name;
  const Hdf5Attribute attribute = open_scalar(name);
  const Hdf5Space space(check_hdf5(H5Aget_space(attribute.get()), name_, action));
  const Hdf5Type type(check_hdf5(H5Aget_type(attribute.get()), name_, action));
  if (H5Tis_variable_str(type.get()) <= 0) {
    throw FileError(fmt::format("{}: the attribute {} is no text of any length", name_, name));
  }
  char* text = nullptr;
  check_hdf5(H5Aread(attribute.get(), type.get(), &text), name_, action);
  std::string copy = text == nullptr ? "" : text;
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, &text);
  return copy;
}

Hdf5Dataset Hdf5Reader::open(const std::string& dataset) const {
  return Hdf5Dataset(check_hdf5(H5Dopen2(file_.get(), dataset.c_str(), H5P_DEFAULT), name_, "read " + dataset));
}

Hdf5Reader::Shape Hdf5Reader::shape_of(const Hdf5Dataset& handle, const std::string& dataset) const {
  const Hdf5Space space(check_hdf5(H5Dget_space(handle.get()), name_, "read " + dataset));
  const Hdf5Type type(check_hdf5(H5Dget_type(handle.get()), name_, "read " + dataset));
  const H5T_class_t kind = H5Tget_class(type.get());
  const int dimensions = H5Sget_simple_extent_ndims(space.get());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || dimensions < 1 || dimensions > 2) {
    throw FileError(fmt::format("{}: {} is no array of numbers with one or two dimensions", name_, dataset));
  }
  std::array<hsize_t, 2> size = {0, 1};
  check_hdf5(H5Sget_simple_extent_dims(space.get(), size.data(), nullptr), name_, "read " + dataset);
  const double bytes =
      static_cast<double>(size[0]) * static_cast<double>(size[1]) * static_cast<double>(H5Tget_size(type.get()));
  if (bytes > static_cast<double>(H5Dget_storage_size(handle.get()))) {
    throw FileError(fmt::format("{}: {} is longer than what the file holds of it", name_, dataset));
  }
  return {static_cast<std::int64_t>(size[0]), static_cast<std::int64_t>(size[1])};
}

std::int64_t Hdf5Reader::rows(const std::string& dataset) const { return shape_of(open(dataset), dataset).rows; }

void Hdf5Reader::read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end, hid_t type,
                           const std::function<void*(std::size_t)>& allocate) const {
  const Hdf5Dataset handle = open(dataset);
  const Shape shape = shape_of(handle, dataset);
  if (shape.columns != columns || begin < 0 || begin > end || end > shape.rows) {
    throw FileError(
        fmt::format("{}: {} has {} rows of {}, not {} of {}", name_, dataset, shape.rows, shape.columns, end, columns));
  }
  if (begin == end) return;
  const Hdf5Space disk(check_hdf5(H5Dget_space(handle.get()), name_, "read " + dataset));
  const std::array<hsize_t, 2> start = {static_cast<hsize_t>(begin), 0};
  const std::array<hsize_t, 2> count = {static_cast<hsize_t>(end - begin), static_cast<hsize_t>(columns)};
  H5Sselect_hyperslab(disk.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const std::array<hsize_t, 1> all = {count[0] * count[1]};
  const Hdf5Space memory(H5Screate_simple(1, all.data(), nullptr));
  check_hdf5(H5Dread(handle.get(), type, memory.get(), disk.get(), H5P_DEFAULT, allocate(all[0])), name_,
             "read " + dataset);
}

}  // namespace repose
