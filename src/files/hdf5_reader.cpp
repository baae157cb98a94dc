#include "files/hdf5_reader.h"

#include <array>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {
namespace {

constexpr double greatest_deflation = 1032.0;  // deflate makes no more of a byte

Hdf5Properties access_properties() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions, once
  H5PLset_loading_state(0);                     // a filter that HDF5 does not know is an error, no program to load
  return Hdf5Properties(H5Pcreate(H5P_FILE_ACCESS));
}

herr_t refuse_link(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) { return -1; }

const char* name_of(H5T_class_t wanted) {
  return wanted == H5T_FLOAT ? "real numbers" : wanted == H5T_STRING ? "texts" : "integers";
}

/// What is in a file about an array, and what keeps it from being read.
class Inspection {
 public:
  Inspection(const Hdf5Dataset& dataset, double most_bytes)
      : dataset_(dataset),
        creation_(H5Dget_create_plist(dataset.get())),
        type_(H5Dget_type(dataset.get())),
        most_values_(most_bytes / static_cast<double>(H5Tget_size(type_.get()))) {
    const Hdf5Space space(H5Dget_space(dataset.get()));
    if (H5Sget_simple_extent_type(space.get()) != H5S_SIMPLE) return;
    dimensions_ = H5Sget_simple_extent_ndims(space.get());
    if (dimensions_ < 1 || dimensions_ > 2) return;
    H5Sget_simple_extent_dims(space.get(), size_.data(), nullptr);
  }

  std::int64_t rows() const { return static_cast<std::int64_t>(size_[0]); }

  /// Empty: nothing.
  std::string problem(H5T_class_t wanted, int columns) const {
    if (H5Tget_class(type_.get()) != wanted) return std::string("is not of ") + name_of(wanted);
    if (wanted == H5T_STRING && H5Tis_variable_str(type_.get()) > 0) return "is of texts without a length";
    if (dimensions_ != (columns == 1 ? 1 : 2) || size_[1] != static_cast<hsize_t>(columns))
      return "has not the right columns";
    if (is_elsewhere()) return "lies in another file";
    if (values() > most_values_ || chunk_values() > most_values_) return "claims more values than the file can hold";
    H5D_space_status_t status = H5D_SPACE_STATUS_ERROR;
    H5Dget_space_status(dataset_.get(), &status);
    if (size_[0] > 0 && status != H5D_SPACE_STATUS_ALLOCATED && status != H5D_SPACE_STATUS_PART_ALLOCATED)
      return "has no values";
    return {};
  }

 private:
  bool is_elsewhere() const {
    return H5Pget_external_count(creation_.get()) != 0 || H5Pget_layout(creation_.get()) == H5D_VIRTUAL;
  }
  double values() const { return static_cast<double>(size_[0]) * static_cast<double>(size_[1]); }
  double chunk_values() const {
    if (H5Pget_layout(creation_.get()) != H5D_CHUNKED) return 0.0;
    std::array<hsize_t, 2> chunk{1, 1};
    H5Pget_chunk(creation_.get(), dimensions_, chunk.data());
    return static_cast<double>(chunk[0]) * static_cast<double>(chunk[1]);
  }

  const Hdf5Dataset& dataset_;
  Hdf5Properties creation_;
  Hdf5Type type_;
  double most_values_;
  int dimensions_ = 0;
  std::array<hsize_t, 2> size_{0, 1};
};

double most_bytes_of(std::uint64_t file_bytes) { return greatest_deflation * static_cast<double>(file_bytes); }

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path)
    : file_(H5I_INVALID_HID), name_(path), bytes_(std::filesystem::file_size(path)) {
  const Hdf5Properties access = access_properties();
  H5Pset_file_locking(access.get(), false, true);  // many network file systems have no locks
  file_ = Hdf5FileHandle(check_hdf5(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), path, "read as HDF5"));
}

/// Needs no disk, so that every rank can do with the bytes that one has read.
Hdf5Reader Hdf5Reader::of_bytes(const std::string& bytes, const std::string& file, const std::string& kind) {
  constexpr std::size_t increment = 1 << 20;
  const Hdf5Properties access = access_properties();
  H5Pset_fapl_core(access.get(), increment, false);
  std::string image = bytes;                   // HDF5 asks for memory it could write to
  const char* const name = "/dev/null/image";  // HDF5 refuses the name of a file that is there; this can be none
  H5Pset_file_image(access.get(), image.data(), image.size());
  Hdf5FileHandle handle(check_hdf5(H5Fopen(name, H5F_ACC_RDONLY, access.get()), file, "read as a " + kind));
  return {std::move(handle), file, bytes.size()};
}

Hdf5Attribute Hdf5Reader::open_scalar(const std::string& attribute) const {
  const std::string action = "read the attribute " + attribute;
  Hdf5Attribute handle(check_hdf5(H5Aopen(file_.get(), attribute.c_str(), H5P_DEFAULT), name_, action));
  const Hdf5Space space(check_hdf5(H5Aget_space(handle.get()), name_, action));
  if (H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw FileError(fmt::format("{}: cannot {}: it is not one value", name_, action));
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
  std::vector<std::string> texts = read_texts(name);
  if (texts.size() != 1) throw FileError(fmt::format("{}: the attribute {} is not one text", name_, name));
  return texts.front();
}

namespace {

std::vector<std::string> texts_of(const Hdf5Attribute& attribute, std::uint64_t bytes, const std::string& file,
                                  const std::string& action) {
  const Hdf5Space space(check_hdf5(H5Aget_space(attribute.get()), file, action));
  const Hdf5Type type(check_hdf5(H5Aget_type(attribute.get()), file, action));
  const auto count = static_cast<std::size_t>(check_hdf5(H5Sget_simple_extent_npoints(space.get()), file, action));
  if (H5Tis_variable_str(type.get()) <= 0 || count > bytes) {
    throw FileError(fmt::format("{}: cannot {}: it is not of texts", file, action));
  }
  std::vector<char*> pointers(count, nullptr);
  std::vector<std::string> texts(count);
  check_hdf5(H5Aread(attribute.get(), type.get(), pointers.data()), file, action);
  for (std::size_t k = 0; k < count; ++k) {
    if (pointers[k] != nullptr) texts[k] = pointers[k];
  }
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, pointers.data());
  return texts;
}

}  // namespace

std::vector<std::string> Hdf5Reader::read_texts(const std::string& name) const {
  const std::string action = "read the attribute " + name;
  return texts_of(Hdf5Attribute(check_hdf5(H5Aopen(file_.get(), name.c_str(), H5P_DEFAULT), name_, action)), bytes_,
                  name_, action);
}

std::vector<std::string> Hdf5Reader::read_texts(const std::string& name, const std::string& dataset) const {
  const std::string action = fmt::format("read the attribute {} of {}", name, dataset);
  const Hdf5Dataset handle = open(dataset);
  return texts_of(Hdf5Attribute(check_hdf5(H5Aopen(handle.get(), name.c_str(), H5P_DEFAULT), name_, action)), bytes_,
                  name_, action);
}

bool Hdf5Reader::has_attribute(const std::string& name) const { return H5Aexists(file_.get(), name.c_str()) > 0; }

bool Hdf5Reader::has(const std::string& object) const {
  return H5Lexists(file_.get(), object.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::read_text_rows(const std::string& dataset) const {
  const Hdf5Type type(check_hdf5(H5Dget_type(open(dataset).get()), name_, "read " + dataset));
  if (H5Tget_class(type.get()) != H5T_STRING) {
    throw FileError(fmt::format("{}: cannot read {}: it is not of texts", name_, dataset));
  }
  const std::size_t length = H5Tget_size(type.get());
  std::string rows;
  read_rows(dataset, 1, 0, this->rows(dataset), type.get(), [&](std::size_t count) {
    rows.resize(count * length);
    return static_cast<void*>(rows.data());
  });
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin < rows.size(); begin += length) {
    texts.emplace_back(rows.substr(begin, length).c_str());  // up to the zeros that fill it
  }
  return texts;
}

/// Without following a link to another file.
Hdf5Dataset Hdf5Reader::open(const std::string& dataset) const {
  const Hdf5Properties access(H5Pcreate(H5P_DATASET_ACCESS));
  H5Pset_elink_cb(access.get(), refuse_link, nullptr);
  return Hdf5Dataset(check_hdf5(H5Dopen2(file_.get(), dataset.c_str(), access.get()), name_, "read " + dataset));
}

std::int64_t Hdf5Reader::rows(const std::string& dataset) const {
  return Inspection(open(dataset), most_bytes_of(bytes_)).rows();
}

void Hdf5Reader::read_rows(const std::string& dataset, int columns, std::int64_t begin, std::int64_t end, hid_t type,
                           const std::function<void*(std::size_t)>& allocate) const {
  const Hdf5Dataset handle = open(dataset);
  const Inspection inspection(handle, most_bytes_of(bytes_));
  const std::string problem = inspection.problem(H5Tget_class(type), columns);
  if (!problem.empty()) throw FileError(fmt::format("{}: cannot read {}: it {}", name_, dataset, problem));
  if (begin < 0 || begin > end || end > inspection.rows()) {
    throw FileError(fmt::format("{}: {} has {} rows, {} are needed", name_, dataset, inspection.rows(), end));
  }
  if (begin == end) return;  // HDF5 wants a place for none, too
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
