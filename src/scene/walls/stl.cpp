#include "scene/walls/stl.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/core.h>

#include "base/error.h"

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary STL is read as it lies in memory");

namespace repose {

namespace {

constexpr std::size_t header_bytes = 84;  // 80 of text and the number of triangles
constexpr std::size_t triangle_bytes = 50;
constexpr std::uint64_t most_triangles = 100'000'000;  // features are numbered by 32 bits
constexpr double farthest = 1e9;

bool is_acceptable(double x) { return std::fabs(x) <= farthest; }  // false for NaN

std::uint32_t stated_triangles(std::string_view text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + header_bytes - sizeof(count), sizeof(count));
  return count;
}

std::uint64_t binary_size(std::uint64_t triangles) { return header_bytes + triangle_bytes * triangles; }

void check_count(std::uint64_t triangles, const std::string& file) {
  if (triangles == 0) throw DeckError(file + ": an STL file without a triangle");
  if (triangles > most_triangles) {
    throw DeckError(fmt::format("{}: {} triangles; at most {} are supported", file, triangles, most_triangles));
  }
}

std::vector<Corners> parse_binary(std::string_view text, const std::string& file) {
  const std::uint32_t count = stated_triangles(text);
  check_count(count, file);
  std::vector<Corners> triangles(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<float, 12> numbers;  // the normal and three corners
    std::memcpy(numbers.data(), text.data() + binary_size(t), sizeof(numbers));
    for (std::size_t k = 0; k < 3; ++k) {
      const float* n = &numbers[3 + 3 * k];
      if (!is_acceptable(n[0]) || !is_acceptable(n[1]) || !is_acceptable(n[2])) {
        throw DeckError(fmt::format("{}: triangle {}: corner ({}, {}, {}) is not finite or beyond {}", file, t + 1,
                                    n[0], n[1], n[2], farthest));
      }
      triangles[t][k] = {n[0], n[1], n[2]};
    }
  }
  return triangles;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

/// For messages: a word of bytes that may be anything, made short and printable.
std::string printable(std::string_view word) {
  std::string text(word.substr(0, 20));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

/// The words of an ASCII file, with the line they stand in.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// The next word; empty at the end.
  std::string_view next() {
    while (!text_.empty() && is_blank(text_.front())) skip(1);
    std::size_t length = 0;
    while (length < text_.size() && !is_blank(text_[length])) ++length;
    const std::string_view word = text_.substr(0, length);
    text_.remove_prefix(length);
    return word;
  }
  void skip_line() { skip(std::min(text_.find('\n'), text_.size())); }

  void expect(std::string_view keyword) {
    const std::string_view word = next();
    if (!is_same(word, keyword)) refuse(word, keyword);
  }
  double number() {
    const std::string_view word = next();
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || end != digits.data() + digits.size()) refuse(word, "a coordinate");
    if (!is_acceptable(value)) refuse(word, fmt::format("a coordinate of at most {}", farthest));
    return value;
  }
  [[noreturn]] void refuse(std::string_view word, std::string_view wanted) const {
    const std::string found = word.empty() ? "the file ends" : fmt::format("\"{}\"", printable(word));
    throw DeckError(fmt::format("{}:{}: {} where {} is expected in an ASCII STL file", file_, line_, found, wanted));
  }

  /// Whether a word is a keyword, in small or capital letters.
  static bool is_same(std::string_view word, std::string_view keyword) {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
  }

 private:
  void skip(std::size_t count) {
    line_ +=
        static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
    text_.remove_prefix(count);
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t line_ = 1;
};

/// What follows the word "facet". The normal may be anything, such as "nan nan nan".
Corners parse_facet(Words& words) {
  words.expect("normal");
  for (int k = 0; k < 3; ++k) {
    if (words.next().empty()) words.refuse("", "a normal");
  }
  words.expect("outer");
  words.expect("loop");
  Corners corners;
  for (Vec3& corner : corners) {
    words.expect("vertex");
    corner.x = words.number();
    corner.y = words.number();
    corner.z = words.number();
  }
  words.expect("endloop");
  words.expect("endfacet");
  return corners;
}

std::vector<Corners> parse_ascii(std::string_view text, const std::string& file) {
  Words words(text, file);
  std::vector<Corners> triangles;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (!Words::is_same(word, "solid")) words.refuse(word, "\"solid\"");
    words.skip_line();  // its name
    for (word = words.next(); !Words::is_same(word, "endsolid"); word = words.next()) {
      if (!Words::is_same(word, "facet")) words.refuse(word, "\"facet\" or \"endsolid\"");
      triangles.push_back(parse_facet(words));
    }
    words.skip_line();
  }
  check_count(triangles.size(), file);
  return triangles;
}

bool begins_with_solid(std::string_view text) { return Words::is_same(Words(text, {}).next(), "solid"); }

}  // namespace

std::vector<Corners> parse_stl(std::string_view text, const std::string& file) {
  const bool has_header = text.size() >= header_bytes;
  if (has_header && text.size() == binary_size(stated_triangles(text))) return parse_binary(text, file);
  if (begins_with_solid(text)) return parse_ascii(text, file);
  if (!has_header) throw DeckError(fmt::format("{}: {} bytes are no STL file", file, text.size()));
  throw DeckError(fmt::format(
      "{}: not an STL file: no ASCII one begins like this, and a binary one of {} triangles has {} bytes, not {}", file,
      stated_triangles(text), binary_size(stated_triangles(text)), text.size()));
}

}  // namespace repose
