#include "import/script_command.h"

#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "files/text_table.h"

namespace repose {
namespace {

constexpr double most_whole = 9e15;  // whole numbers that a double holds

}  // namespace

std::string text(const Place& place) { return fmt::format("{}:{}", place.file, place.line); }

void refuse(const Place& place, const std::string& what) { fail_at({place.file, place.line}, what); }

std::string text(const ScriptCommand& command) {
  std::string line;
  for (const std::string& word : command.words) line += (line.empty() ? "" : " ") + word;
  return line;
}

double number_of(const std::string& word, const Place& place, std::string_view what) {
  std::string_view digits = word;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value)) {
    refuse(place, fmt::format("\"{}\" where a number is expected ({})", word, what));
  }
  return value;
}

std::int64_t integer_of(const std::string& word, const Place& place, std::string_view what, double most) {
  const double value = number_of(word, place, what);
  if (value != std::floor(value) || std::fabs(value) > most) {
    refuse(place, fmt::format("\"{}\" where a whole number is expected ({})", word, what));
  }
  return static_cast<std::int64_t>(value);
}

bool Words::take(std::string_view word) {
  if (at_end() || command_.words[next_] != word) return false;
  ++next_;
  return true;
}

void Words::expect(std::string_view word) {
  if (take(word)) return;
  fail(fmt::format("{} where \"{}\" is expected", at_end() ? "the end" : "\"" + command_.words[next_] + "\"", word));
}

const std::string& Words::word(std::string_view what) {
  if (at_end()) fail(fmt::format("{} ends before {}", command_.words[0], what));
  return command_.words[next_++];
}

double Words::number(std::string_view what) { return number_of(word(what), command_.place, what); }

std::int64_t Words::integer(std::string_view what) { return integer_of(word(what), command_.place, what, most_whole); }

std::int64_t Words::steps(std::string_view what) {
  const double value = number(what);
  if (std::fabs(value) > most_whole) fail(fmt::format("{:g} where a number of steps is expected ({})", value, what));
  return static_cast<std::int64_t>(value);
}

Vec3 Words::vector(std::string_view what) {
  const double x = number(what);
  const double y = number(what);
  return {x, y, number(what)};
}

int Words::type() {
  const std::int64_t type = integer("the type");
  if (type < 1 || type > 1000) fail(fmt::format("type {}; types are counted from 1 on", type));
  return static_cast<int>(type);
}

bool Words::skip_needless(const std::string& key, const std::map<std::string, int>& needless) {
  const auto found = needless.find(key);
  if (found == needless.end()) return false;
  for (int k = 0; k < found->second; ++k) word(key);
  return true;
}

bool Words::choice(std::string_view what) {
  const std::string& answer = word(what);
  if (answer == "yes" || answer == "on") return true;
  if (answer == "no" || answer == "off") return false;
  fail(fmt::format("\"{}\" where on or off is expected ({})", answer, what));
}

std::vector<std::string> Words::rest() {
  std::vector<std::string> words(command_.words.begin() + static_cast<std::ptrdiff_t>(next_), command_.words.end());
  next_ = command_.words.size();
  return words;
}

}  // namespace repose
