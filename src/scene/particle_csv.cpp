#include "scene/particle_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"

namespace repose {

namespace {

constexpr std::string_view header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material";
constexpr std::array<std::string_view, 11> columns{"x",  "y",  "z",  "vx",     "vy",      "vz",
                                                   "wx", "wy", "wz", "radius", "material"};
constexpr std::size_t numbers = columns.size() - 1;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

struct Place {
  const std::string& file;
  std::size_t line;
};

[[noreturn]] void fail(const Place& place, const std::string& what) {
  throw DeckError(fmt::format("{}:{}: {}", place.file, place.line, what));
}

std::array<std::string_view, columns.size()> split(std::string_view line, const Place& place) {
  std::array<std::string_view, columns.size()> fields;
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= line.size(); ++count) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    if (count < fields.size()) fields[count] = trimmed(line.substr(begin, end - begin));
    begin = end + 1;
  }
  if (count != fields.size()) fail(place, fmt::format("{} fields instead of {} ({})", count, fields.size(), header));
  return fields;
}

double parse_number(std::string_view text, std::string_view column, const Place& place) {
  double value = 0.0;
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);  // from_chars knows no plus
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem == std::errc::result_out_of_range) {
    fail(place, fmt::format("{} = {} is out of the range of double precision", column, text));
  }
  if (problem != std::errc{} || end != digits.data() + digits.size()) {
    fail(place, fmt::format("{} = \"{}\" is not a number", column, text));
  }
  if (!std::isfinite(value)) fail(place, fmt::format("{} = {} is not finite", column, text));
  return value;
}

int find_material(std::string_view name, const std::vector<MaterialDeck>& materials, const Place& place) {
  std::string known;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (materials[m].name == name) return static_cast<int>(m);
    known += (m > 0 ? ", " : "") + materials[m].name;
  }
  fail(place, fmt::format("no material is named \"{}\"; the deck has: {}", name, known));
}

void parse_line(std::string_view line, const Place& place, const std::vector<MaterialDeck>& materials,
                NewParticles& particles) {
  const auto fields = split(line, place);
  std::array<double, numbers> n{};
  for (std::size_t k = 0; k < numbers; ++k) n[k] = parse_number(fields[k], columns[k], place);
  if (!(n[9] > 0.0)) fail(place, fmt::format("radius = {} is not positive", n[9]));
  particles.position.push_back({n[0], n[1], n[2]});
  particles.velocity.push_back({n[3], n[4], n[5]});
  particles.spin.push_back({n[6], n[7], n[8]});
  particles.radius.push_back(n[9]);
  particles.material.push_back(find_material(fields[10], materials, place));
}

void check_header(std::string_view line, const Place& place) {
  std::string compact;
  for (const char c : line) {
    if (c != ' ' && c != '\t' && c != '"') compact += c;
  }
  if (compact != header) fail(place, fmt::format("the header line must read {}", header));
}

}  // namespace

NewParticles parse_particle_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  NewParticles particles;
  bool header_seen = false;
  Place place{file, 0};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++place.line;
    if (line.empty() || line.front() == '#') continue;
    if (header_seen) {
      parse_line(line, place, materials, particles);
    } else {
      check_header(line, place);
      header_seen = true;
    }
  }
  if (particles.size() == 0)
    fail(place, fmt::format("no particles; expected a header line {} and one line each", header));
  return particles;
}

}  // namespace repose
