#include "scene/particle_csv.h"

#include <fmt/format.h>

#include "scene/text_table.h"

namespace repose {

namespace {

constexpr std::string_view full_header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material";
constexpr std::string_view short_header = "x,y,z,radius,material";

int find_material(std::string_view name, const std::vector<MaterialDeck>& materials, const FilePlace& place) {
  std::string known;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (materials[m].name == name) return static_cast<int>(m);
    known += (m > 0 ? ", " : "") + materials[m].name;
  }
  fail_at(place, fmt::format("no material is named \"{}\"; the deck has: {}", name, known));
}

void parse_line(std::string_view line, const FilePlace& place, std::string_view header,
                const std::vector<MaterialDeck>& materials, NewParticles& particles) {
  static const std::vector<std::string_view> full_columns = split_fields(full_header);
  static const std::vector<std::string_view> short_columns = split_fields(short_header);
  const auto& columns = header == full_header ? full_columns : short_columns;
  const auto fields = split_fields(line);
  if (fields.size() != columns.size()) {
    fail_at(place, fmt::format("{} fields instead of {} ({})", fields.size(), columns.size(), header));
  }
  std::vector<double> n;
  for (std::size_t k = 0; k + 1 < columns.size(); ++k) n.push_back(parse_number(fields[k], columns[k], place));
  const double radius = n.back();
  if (!(radius > 0.0)) fail_at(place, fmt::format("radius = {} is not positive; write a length above 0, in m", radius));
  const bool moves = columns.size() == full_columns.size();
  particles.position.push_back({n[0], n[1], n[2]});
  particles.velocity.push_back(moves ? Vec3{n[3], n[4], n[5]} : Vec3{});
  particles.spin.push_back(moves ? Vec3{n[6], n[7], n[8]} : Vec3{});
  particles.radius.push_back(radius);
  particles.material.push_back(find_material(fields.back(), materials, place));
}

std::string_view header_of(std::string_view line, const FilePlace& place) {
  const std::string text = compact(line);
  if (text == full_header) return full_header;
  if (text == short_header) return short_header;
  fail_at(place, fmt::format("the header line must read {} or {}", full_header, short_header));
}

}  // namespace

NewParticles parse_particle_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials) {
  NewParticles particles;
  std::string_view header;
  const std::size_t last = for_each_line(text, file, [&](std::string_view line, const FilePlace& place) {
    if (header.empty()) {
      header = header_of(line, place);
    } else {
      parse_line(line, place, header, materials, particles);
    }
  });
  if (particles.size() == 0) {
    fail_at({file, last},
            fmt::format("no particles; expected a header line {} or {} and one line each", full_header, short_header));
  }
  return particles;
}

}  // namespace repose
