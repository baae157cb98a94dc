#include "output/csv_file.h"

#include <cerrno>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "base/error.h"

namespace repose {

CsvFile::CsvFile(std::string path, std::string_view header)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "we")) {
  if (!file_) throw FileError(fmt::format("{}: cannot open: {}", path_, std::strerror(errno)));
  append(fmt::format("{}\n", header));
}

void CsvFile::append(std::string_view lines) {
  const bool written = std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size();
  if (!written || std::fflush(file_.get()) != 0) {
    throw FileError(fmt::format("{}: cannot write: {}", path_, std::strerror(errno)));
  }
}

std::string shortest_text(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value); }

}  // namespace repose
