#include "files/csv_file.h"

#include <cmath>

#include <fmt/core.h>
#include <unistd.h>

#include "base/error.h"
#include "files/file_descriptor.h"

namespace repose {

CsvFile::CsvFile(std::string path, std::string_view header, Existing existing)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), existing == Existing::replace ? "we" : "r+e")) {
  if (!file_) throw_system_error("open", path_);
  if (existing == Existing::replace) append(fmt::format("{}\n", header));
}

void CsvFile::append(std::string_view lines) {
  const bool written = std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size();
  if (!written || std::fflush(file_.get()) != 0) throw_system_error("write", path_);
  bytes_ += std::ssize(lines);
}

void CsvFile::sync() {
  if (::fsync(::fileno(file_.get())) != 0) throw_system_error("sync", path_);
}

void CsvFile::cut_off() {
  if (std::fseek(file_.get(), 0, SEEK_END) != 0) throw_system_error("read", path_);
  const std::int64_t length = std::ftell(file_.get());
  if (length < bytes_) {
    throw FileError(fmt::format("{}: holds {} bytes, but {} when the checkpoint was written: rows are missing", path_,
                                length, bytes_));
  }
  if (::ftruncate(::fileno(file_.get()), bytes_) != 0) throw_system_error("cut off", path_);
  if (std::fseek(file_.get(), 0, SEEK_END) != 0) throw_system_error("read", path_);
}

std::string shortest_text(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value); }

}  // namespace repose
