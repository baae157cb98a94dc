#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/trimmed.h"

namespace repose {

/// A line of a file, for messages.
struct FilePlace {
  const std::string& file;
  std::size_t line;
};

/// Throws DeckError as `file:line: what`.
[[noreturn]] void fail_at(const FilePlace& place, const std::string& what);

/// A finite number of a column. DeckError with its place when the field is something else.
double parse_number(std::string_view field, std::string_view column, const FilePlace& place);

/// The fields between the commas of a line, trimmed.
std::vector<std::string_view> split_fields(std::string_view line);

/// DeckError with the place when a line has another number of fields.
void require_fields(const std::vector<std::string_view>& fields, std::size_t count, const FilePlace& place);

/// A header line without blanks and quotes.
std::string compact(std::string_view line);

/// Calls visit(line, place) for each line of comma-separated text that is neither blank nor begins with #; a byte order
/// mark is skipped. Returns the number of the last line.
template <class Visit>
std::size_t for_each_line(std::string_view text, const std::string& file, Visit&& visit) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  FilePlace place{file, 0};
  while (!text.empty()) {
    const std::size_t end = text.find('\n') == std::string_view::npos ? text.size() : text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(end < text.size() ? end + 1 : end);
    ++place.line;
    if (!line.empty() && line.front() != '#') visit(line, place);
  }
  return place.line;
}

}  // namespace repose
