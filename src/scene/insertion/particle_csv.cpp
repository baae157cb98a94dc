#include "scene/insertion/particle_csv.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/text_table.h"

namespace repose {

namespace {

constexpr std::string_view full_header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material";
constexpr std::string_view short_header = "x,y,z,radius,material";
constexpr std::string_view bare_header = "x,y,z,radius";

int find_material(std::string_view name, const std::vector<MaterialDeck>& materials, const FilePlace& place) {
  std::string known;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (materials[m].name == name) return static_cast<int>(m);
    known += (m > 0 ? ", " : "") + materials[m].name;
  }
  fail_at(place, fmt::format("no material is named \"{}\"; the deck has: {}", name, known));
}

struct Header {
  std::string_view text = {};                  ///< empty: not read yet
  std::vector<std::string_view> columns = {};  ///< of the text
};

void parse_line(std::string_view line, const FilePlace& place, const Header& header,
                const std::vector<MaterialDeck>& materials, NewParticles& particles) {
  const std::vector<std::string_view>& columns = header.columns;
  const auto fields = split_fields(line);
  if (fields.size() != columns.size()) {
    fail_at(place, fmt::format("{} fields instead of {} ({})", fields.size(), columns.size(), header.text));
  }
  std::vector<double> n;
  for (std::size_t k = 0; k < columns.size() && columns[k] != "material"; ++k) {
    n.push_back(parse_number(fields[k], columns[k], place));
  }
  const double radius = n.back();
  if (!(radius > 0.0)) fail_at(place, fmt::format("radius = {} is not positive; write a length above 0, in m", radius));
  const bool moves = header.text == full_header;
  particles.position.push_back({n[0], n[1], n[2]});
  particles.velocity.push_back(moves ? Vec3{n[3], n[4], n[5]} : Vec3{});
  particles.spin.push_back(moves ? Vec3{n[6], n[7], n[8]} : Vec3{});
  particles.radius.push_back(radius);
  if (header.text != bare_header) particles.material.push_back(find_material(fields.back(), materials, place));
}

Header header_of(std::string_view line, const FilePlace& place, std::span<const std::string_view> headers) {
  const std::string text = compact(line);
  const auto found = std::find(headers.begin(), headers.end(), text);
  if (found == headers.end()) fail_at(place, fmt::format("the header line must read {}", fmt::join(headers, " or ")));
  return {*found, split_fields(*found)};
}

NewParticles parse(std::string_view text, const std::string& file, const std::vector<MaterialDeck>& materials,
                   std::span<const std::string_view> headers) {
  NewParticles particles;
  Header header;
  const std::size_t last = for_each_line(text, file, [&](std::string_view line, const FilePlace& place) {
    if (header.text.empty()) {
      header = header_of(line, place, headers);
    } else {
      parse_line(line, place, header, materials, particles);
    }
  });
  if (particles.size() == 0) {
    fail_at({file, last},
            fmt::format("no particles; expected a header line {} and one line each", fmt::join(headers, " or ")));
  }
  return particles;
}

}  // namespace

NewParticles parse_particle_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials) {
  constexpr std::array headers = {full_header, short_header};
  return parse(text, file, materials, headers);
}

NewParticles parse_measured_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials) {
  constexpr std::array headers = {bare_header, short_header, full_header};
  return parse(text, file, materials, headers);
}

}  // namespace repose
