#include "files/hdf5_disk.h"

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"

namespace repose {
namespace {

/// What HDF5 holds of an open file; it knows the first member only.
struct OpenFile {
  H5FD_t base;
  Hdf5Disk* disk;
  haddr_t allocated;  ///< end of what HDF5 has given to its objects
  haddr_t written;    ///< end of what has been written
};

OpenFile& open_file(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& open_file(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

H5FD_t* open(const char* /*name*/, unsigned /*flags*/, hid_t access, haddr_t /*most*/) {
  const void* disk = H5Pget_driver_info(access);
  if (disk == nullptr) return nullptr;
  auto* file = new (std::nothrow) OpenFile{};
  if (file == nullptr) return nullptr;
  file->disk = *static_cast<Hdf5Disk* const*>(disk);
  return &file->base;
}

herr_t close(H5FD_t* file) {
  delete &open_file(file);
  return 0;
}

herr_t query(const H5FD_t* /*file*/, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t allocated(const H5FD_t* file, H5FD_mem_t /*type*/) { return open_file(file).allocated; }

herr_t allocate(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
  open_file(file).allocated = end;
  return 0;
}

haddr_t written(const H5FD_t* file, H5FD_mem_t /*type*/) { return open_file(file).written; }

herr_t read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t place, std::size_t size, void* bytes) {
  open_file(file).disk->read(place, static_cast<char*>(bytes), size);
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t place, std::size_t size,
             const void* bytes) {
  OpenFile& f = open_file(file);
  f.disk->write(place, {static_cast<const char*>(bytes), size});
  f.written = std::max(f.written, place + size);
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
  OpenFile& f = open_file(file);
  if (f.allocated != f.written) f.disk->set_length(f.allocated);
  f.written = f.allocated;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "repose_disk";
  driver.maxaddr = (haddr_t{1} << 62);
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(Hdf5Disk*);
  driver.open = open;
  driver.close = close;
  driver.query = query;
  driver.get_eoa = allocated;
  driver.set_eoa = allocate;
  driver.get_eof = written;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  std::fill(std::begin(driver.fl_map), std::end(driver.fl_map), H5FD_MEM_DEFAULT);
  return driver;
}

}  // namespace

Hdf5Disk::Hdf5Disk(const std::string& opened, std::string path)
    : path_(std::move(path)), file_(opened, O_RDWR | O_CREAT | O_TRUNC, path_) {}

Hdf5Properties Hdf5Disk::access() {
  static const H5FD_class_t driver = driver_class();
  static const hid_t registered = H5FDregister(&driver);
  Hdf5Properties properties(H5Pcreate(H5P_FILE_ACCESS));
  Hdf5Disk* disk = this;
  check_hdf5(H5Pset_driver(properties.get(), registered, &disk), path_, "create");
  H5Pset_fclose_degree(properties.get(), H5F_CLOSE_STRONG);
  return properties;
}

void Hdf5Disk::check() const {
  if (!error_.empty()) throw FileError(error_);
}

void Hdf5Disk::give_up() noexcept { usable_ = false; }

template <class Work>
void Hdf5Disk::attempt(const Work& work) noexcept {
  if (!usable_) return;
  try {
    work();
  } catch (const std::exception& error) {
    usable_ = false;
    error_ = error.what();
  }
}

void Hdf5Disk::read(std::uint64_t place, char* bytes, std::size_t size) const noexcept {
  const ssize_t got = ::pread(file_.get(), bytes, size, static_cast<off_t>(place));
  std::fill(bytes + std::max<ssize_t>(got, 0), bytes + size, '\0');  // behind the end, and where writing has failed
}

void Hdf5Disk::write(std::uint64_t place, std::string_view bytes) noexcept {
  attempt([&] { file_.write_at(bytes, static_cast<std::int64_t>(place)); });
}

void Hdf5Disk::set_length(std::uint64_t bytes) noexcept {
  attempt([&] {
    if (::ftruncate(file_.get(), static_cast<off_t>(bytes)) != 0) throw_system_error("write", path_);
  });
}

}  // namespace repose
