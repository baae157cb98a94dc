#include "output/hdf5_array.h"

#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "base/error.h"
#include "output/hdf5_file.h"

namespace repose {

namespace {

constexpr double greatest_deflation = 1032.0;  // deflate makes no more of a byte

herr_t refuse_link(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) { return -1; }

/// Without following a link to another file.
Hdf5Dataset open_dataset(const Hdf5FileHandle& image, const std::string& path, const std::string& file,
                         const std::string& action) {
  const Hdf5Properties access(H5Pcreate(H5P_DATASET_ACCESS));
  H5Pset_elink_cb(access.get(), refuse_link, nullptr);
  return Hdf5Dataset(check_hdf5(H5Dopen2(image.get(), path.c_str(), access.get()), file, action));
}

template <class T>
constexpr H5T_class_t type_class = std::is_integral_v<T> ? H5T_INTEGER : H5T_FLOAT;

/// What is not as read_hdf5_array wants it; empty: nothing.
class Inspection {
 public:
  Inspection(const Hdf5Dataset& dataset, int columns, double most_values)
      : dataset_(dataset), creation_(H5Dget_create_plist(dataset.get())), most_values_(most_values) {
    const Hdf5Space space(H5Dget_space(dataset.get()));
    if (H5Sget_simple_extent_type(space.get()) != H5S_SIMPLE) return;
    rank_ = H5Sget_simple_extent_ndims(space.get());
    if (rank_ != (columns == 1 ? 1 : 2)) return;
    H5Sget_simple_extent_dims(space.get(), size_.data(), nullptr);
    is_array_ = size_[1] == static_cast<hsize_t>(columns);
  }

  std::string problem(H5T_class_t wanted) const {
    const Hdf5Type type(H5Dget_type(dataset_.get()));
    if (H5Tget_class(type.get()) != wanted)
      return wanted == H5T_FLOAT ? "is not of real numbers" : "is not of integers";
    if (!is_array_) return "has not the right columns";
    if (is_elsewhere()) return "lies in another file";
    if (values() > most_values_ || chunk_values() > most_values_) return "claims more values than the file can hold";
    H5D_space_status_t status = H5D_SPACE_STATUS_ERROR;
    H5Dget_space_status(dataset_.get(), &status);
    if (size_[0] > 0 && status != H5D_SPACE_STATUS_ALLOCATED && status != H5D_SPACE_STATUS_PART_ALLOCATED)
      return "has no values";
    return {};
  }
  std::size_t count() const { return size_[0] * size_[1]; }

 private:
  bool is_elsewhere() const {
    return H5Pget_external_count(creation_.get()) != 0 || H5Pget_layout(creation_.get()) == H5D_VIRTUAL;
  }
  double values() const { return static_cast<double>(size_[0]) * static_cast<double>(size_[1]); }
  double chunk_values() const {
    if (H5Pget_layout(creation_.get()) != H5D_CHUNKED) return 0.0;
    std::array<hsize_t, 2> chunk{1, 1};
    H5Pget_chunk(creation_.get(), rank_, chunk.data());
    return static_cast<double>(chunk[0]) * static_cast<double>(chunk[1]);
  }

  const Hdf5Dataset& dataset_;
  Hdf5Properties creation_;
  double most_values_;
  int rank_ = 0;
  std::array<hsize_t, 2> size_{0, 1};
  bool is_array_ = false;
};

}  // namespace

template <class T>
std::vector<T> read_hdf5_array(const Hdf5FileHandle& image, const std::string& path, int columns,
                               std::size_t file_bytes, const std::string& file) {
  const std::string action = "read " + path;
  const Hdf5Dataset dataset = open_dataset(image, path, file, action);
  const Inspection inspection(dataset, columns, greatest_deflation * static_cast<double>(file_bytes) / sizeof(T));
  const std::string problem = inspection.problem(type_class<T>);
  if (!problem.empty()) throw FileError(fmt::format("{}: cannot {}: it {}", file, action, problem));
  std::vector<T> values(inspection.count());
  if (values.empty()) return values;  // HDF5 wants a place for none, too
  check_hdf5(H5Dread(dataset.get(), hdf5_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), file, action);
  return values;
}

template std::vector<double> read_hdf5_array(const Hdf5FileHandle&, const std::string&, int, std::size_t,
                                             const std::string&);
template std::vector<std::int32_t> read_hdf5_array(const Hdf5FileHandle&, const std::string&, int, std::size_t,
                                                   const std::string&);

}  // namespace repose
