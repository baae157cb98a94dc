#include "files/hdf5_image.h"

#include <algorithm>

#include "files/hdf5_attribute.h"

namespace repose {
namespace {

constexpr std::size_t grows_by = 1 << 20;  // bytes

Hdf5Space space_of(const std::vector<std::uint64_t>& shape) {
  if (shape.empty()) return Hdf5Space(H5Screate(H5S_SCALAR));
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  return Hdf5Space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr));
}

Hdf5FileHandle file_in_memory(const std::string& name) {
  const Hdf5Properties access(check_hdf5(H5Pcreate(H5P_FILE_ACCESS), name, "create it"));
  check_hdf5(H5Pset_fapl_core(access.get(), grows_by, 0), name, "create it");
  return Hdf5FileHandle(
      check_hdf5(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), name, "create it"));
}

}  // namespace

Hdf5Image::Hdf5Image(std::string name) : name_(std::move(name)), file_(file_in_memory(name_)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are told by check_hdf5
}

void Hdf5Image::create_group(const std::string& group) {
  const Hdf5Group made(check_hdf5(H5Gcreate2(file_.get(), group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name_,
                                  "create " + group));
}

void Hdf5Image::write_attribute(const std::string& object, const std::string& name, hid_t type, const Hdf5Space& space,
                                const void* values) {
  write_hdf5_attribute(file_, name_, object, name, type, space, values);
}

void Hdf5Image::write_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const char* start = text.c_str();
  write_attribute(object, name, hdf5_text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), space_of({}), &start);
}

void Hdf5Image::write_attribute(const std::string& object, const std::string& name,
                                std::span<const std::string> texts) {
  std::vector<const char*> starts;
  for (const std::string& text : texts) starts.push_back(text.c_str());
  write_attribute(object, name, hdf5_text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), space_of({texts.size()}),
                  starts.data());
}

void Hdf5Image::write_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  write_attribute(object, name, H5T_NATIVE_INT64, space_of({}), &value);
}

void Hdf5Image::write_attribute(const std::string& object, const std::string& name,
                                std::span<const std::int64_t> values) {
  write_attribute(object, name, H5T_NATIVE_INT64, space_of({values.size()}), values.data());
}

void Hdf5Image::write_fixed_texts(const std::string& object, const std::string& name,
                                  std::span<const std::string> texts, const std::vector<std::uint64_t>& shape) {
  std::size_t length = 1;  // HDF5 has no texts of length 0
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string bytes;
  for (const std::string& text : texts) bytes += text + std::string(length - text.size(), '\0');
  const Hdf5Type type = hdf5_text_type(length, H5T_CSET_ASCII);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  write_attribute(object, name, type.get(), space_of(shape), bytes.data());
}

void Hdf5Image::write_array(const std::string& dataset, hid_t type, const void* values,
                            const std::vector<std::uint64_t>& shape) {
  const std::string action = "write " + dataset;
  const Hdf5Space space = space_of(shape);
  const Hdf5Dataset array(
      check_hdf5(H5Dcreate2(file_.get(), dataset.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                 name_, action));
  check_hdf5(H5Dwrite(array.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name_, action);
}

void Hdf5Image::write_array(const std::string& dataset, std::span<const double> values,
                            const std::vector<std::uint64_t>& shape) {
  write_array(dataset, H5T_NATIVE_DOUBLE, values.data(), shape);
}

void Hdf5Image::write_array(const std::string& dataset, std::span<const std::int64_t> values,
                            const std::vector<std::uint64_t>& shape) {
  write_array(dataset, H5T_NATIVE_INT64, values.data(), shape);
}

std::string Hdf5Image::bytes() const {
  check_hdf5(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), name_, "complete it");
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  check_hdf5(size, name_, "complete it");
  std::string image(static_cast<std::size_t>(size), '\0');
  check_hdf5(H5Fget_file_image(file_.get(), image.data(), image.size()), name_, "complete it");
  return image;
}

}  // namespace repose
