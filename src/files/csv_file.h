#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace repose {

/// What becomes of a file that is there already.
enum class Existing { replace, go_on };

/// A text table that grows and can be read meanwhile. For one rank.
class CsvFile {
 public:
  /// Creates or empties `path` and writes the line `header`; or opens one that was begun by an earlier process, whose
  /// state then has to be read. Throws FileError with the path and the system's reason.
  CsvFile(std::string path, std::string_view header, Existing existing = Existing::replace);

  /// Appends whole lines (each ends in a newline) and hands them to the system. Throws FileError, also on a full disk.
  void append(std::string_view lines);
  /// Forces to the disk what has been appended. Throws FileError.
  void sync();

  /// Its length. Reading cuts off what was appended later; FileError when the file is shorter.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("bytes", self.bytes_);
    if constexpr (!std::is_const_v<Self>) self.cut_off();
  }

 private:
  void cut_off();

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::int64_t bytes_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The shortest decimal text that reads back as exactly this number; "nan" without a sign.
std::string shortest_text(double value);

}  // namespace repose
