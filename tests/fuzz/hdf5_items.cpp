#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "hdf5_image.h"

namespace repose::fuzz {

namespace {

using Type = Hdf5Item::Type;

constexpr std::array<std::string_view, 9> type_names = {"f32", "f64",  "i8",         "i32",     "i64",
                                                        "u64", "text", "fixed_text", "compound"};

template <class Number>
bool is_number(std::string_view word, Number& value) {
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  return problem == std::errc{} && end == word.data() + word.size();
}

/// "4", "2x3"; false for what is no shape.
bool is_shape(const std::string& word, std::vector<std::uint64_t>& shape) {
  std::istringstream parts(word);
  std::vector<std::uint64_t> sizes;
  for (std::string part; std::getline(parts, part, 'x');) {
    if (!is_number(part, sizes.emplace_back())) return false;
  }
  if (sizes.empty() || sizes.size() > 32) return false;
  shape = sizes;
  return true;
}

void read_values(std::istream& words, Hdf5Item& item) {
  const bool is_text = item.type == Type::text || item.type == Type::fixed_text;
  for (std::string word; words >> word;) {
    double number = 0.0;
    if (is_text) {
      item.texts.push_back(word);
    } else if (is_number(word, number)) {
      item.numbers.push_back(number);
    }
  }
}

Hdf5Item parse_line(std::istream& words) {
  Hdf5Item item;
  words >> item.path;
  for (std::string word; words >> word && word != "=";) {
    const auto* const type = std::find(type_names.begin(), type_names.end(), word);
    if (type != type_names.end()) {
      item.type = static_cast<Type>(type - type_names.begin());
    } else if (word == "null") {
      item.has_values = false;
    } else if (word == "chunk") {
      words >> item.rows_per_chunk;
    } else if (word == "deflate") {
      item.is_deflated = true;
    } else if (word == "in") {
      words >> item.stored_in;
    } else if (word == "link") {
      item.kind = Hdf5Item::Kind::external_link;
      words >> item.target;
    } else {
      is_shape(word, item.shape);
    }
  }
  read_values(words, item);
  return item;
}

}  // namespace

std::vector<Hdf5Item> parse_hdf5_items(std::string_view text) {
  std::vector<Hdf5Item> items;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Hdf5Item item = parse_line(words);
    if (item.path.size() > 1) items.push_back(item);
  }
  return items;
}

}  // namespace repose::fuzz
