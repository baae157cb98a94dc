#include "files/text_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

void fail_at(const FilePlace& place, const std::string& what) {
  throw DeckError(fmt::format("{}:{}: {}", place.file, place.line, what));
}

std::vector<std::string_view> split_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

void require_fields(const std::vector<std::string_view>& fields, std::size_t count, const FilePlace& place) {
  if (fields.size() != count) fail_at(place, fmt::format("{} fields instead of {}", fields.size(), count));
}

std::string compact(std::string_view line) {
  std::string text;
  std::copy_if(line.begin(), line.end(), std::back_inserter(text),
               [](char c) { return c != ' ' && c != '\t' && c != '"'; });
  return text;
}

double parse_number(std::string_view field, std::string_view column, const FilePlace& place) {
  double value = 0.0;
  std::string_view digits = field;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);  // from_chars knows no plus
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem == std::errc::result_out_of_range) {
    fail_at(place, fmt::format("{} = {} is out of the range of double precision, 1e-308 to 1e308", column, field));
  }
  if (problem != std::errc{} || end != digits.data() + digits.size()) {
    fail_at(place, fmt::format("{} = \"{}\" is not a number; write one such as 4.4e-4", column, field));
  }
  if (!std::isfinite(value))
    fail_at(place, fmt::format("{} = {} is not finite; write a number such as 4.4e-4", column, field));
  return value;
}

}  // namespace repose
