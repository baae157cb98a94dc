#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace repose {

/// A text table that grows and can be read meanwhile. For one rank.
class CsvFile {
 public:
  /// Creates or empties `path` and writes the line `header`. Throws FileError with the path and the system's reason.
  CsvFile(std::string path, std::string_view header);

  /// Appends whole lines (each ends in a newline) and hands them to the system. Throws FileError, also on a full disk.
  void append(std::string_view lines);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The shortest decimal text that reads back as exactly this number; "nan" without a sign.
std::string shortest_text(double value);

}  // namespace repose
