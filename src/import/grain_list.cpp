#include "import/grain_list.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "files/csv_file.h"
#include "files/text_table.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

constexpr double most_grains = 1e9;
constexpr double latest_step = 9e15;

/// A line with what it says, without what follows a #.
struct TableLine {
  Place place = {};
  std::vector<std::string> words = {};
};

std::vector<TableLine> table_lines(std::string_view text, const std::string& file) {
  std::vector<TableLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string kept(line.substr(0, line.find('#')));
    lines.push_back({{file, number}, {}});
    for (std::size_t at = 0; at < kept.size();) {
      const std::size_t begin = kept.find_first_not_of(" \t\r", at);
      if (begin == std::string::npos) break;
      at = std::min(kept.find_first_of(" \t\r", begin), kept.size());
      lines.back().words.push_back(kept.substr(begin, at - begin));
    }
  }
  return lines;
}

const std::string& word(const TableLine& line, std::size_t column, std::string_view what) {
  if (column >= line.words.size()) refuse(line.place, fmt::format("the line ends before {}", what));
  return line.words[column];
}

double number(const TableLine& line, std::size_t column, std::string_view what) {
  return number_of(word(line, column, what), line.place, what);
}

std::int64_t whole(const TableLine& line, std::size_t column, std::string_view what) {
  return integer_of(word(line, column, what), line.place, what, most_grains);
}

/// The columns of x, y and z.
using VectorColumns = std::array<std::size_t, 3>;

Vec3 vector(const TableLine& line, const VectorColumns& columns, std::string_view what) {
  return {number(line, columns[0], what), number(line, columns[1], what), number(line, columns[2], what)};
}

Vec3 vector(const TableLine& line, std::size_t column, std::string_view what) {
  return vector(line, VectorColumns{column, column + 1, column + 2}, what);
}

void check(const Grain& grain, const Place& place, bool needs_density) {
  if (!(grain.radius > 0.0)) refuse(place, "a grain whose radius is not above 0");
  if (grain.density < 0.0 || (needs_density && grain.density == 0.0)) refuse(place, "a density that is not above 0");
  if (grain.type < 1 || grain.type > 1000) refuse(place, "types are counted from 1 on");
}

Grain data_grain(const TableLine& line, const ScriptUnits& units) {
  Grain grain;
  grain.id = whole(line, 0, "id");
  grain.type = static_cast<int>(whole(line, 1, "type"));
  grain.radius = 0.5 * number(line, 2, "diameter") * units.length;
  grain.density = number(line, 3, "density") * units.density();
  grain.position = units.length * vector(line, 4, "position");
  check(grain, line.place, true);
  return grain;
}

bool is_section(const std::string& word) {
  for (const std::string_view name : {"Atoms", "Velocities", "Masses", "Bodies", "Ellipsoids", "Bonds", "Pair"}) {
    if (word == name) return true;
  }
  return false;
}

/// A line of the header: "100 atoms", "0 1 xlo xhi".
void header_line(const TableLine& line, const ScriptUnits& units, std::int64_t& atoms, GrainList& list) {
  const std::vector<std::string>& words = line.words;
  if (words.size() == 2 && words[1] == "atoms") atoms = whole(line, 0, "number of atoms");
  if (words.size() == 3 && words[1] == "atom" && words[2] == "types") {
    list.types = static_cast<int>(std::clamp<std::int64_t>(whole(line, 0, "number of types"), 0, 1000));
  }
  if (words.size() != 4) return;
  for (const auto& [low, component] :
       {std::pair{"xlo", &Vec3::x}, std::pair{"ylo", &Vec3::y}, std::pair{"zlo", &Vec3::z}}) {
    if (words[2] != low) continue;
    if (!list.box) list.box = Extent{};
    list.box->min.*component = number(line, 0, low) * units.length;
    list.box->max.*component = number(line, 1, low) * units.length;
    if (!(list.box->min.*component < list.box->max.*component)) refuse(line.place, "the box has no volume");
  }
}

void set_velocity(const TableLine& line, const ScriptUnits& units, std::map<std::int64_t, std::size_t>& place_of,
                  GrainList& list) {
  const auto found = place_of.find(whole(line, 0, "id"));
  if (found == place_of.end()) refuse(line.place, "a velocity of an atom that is not in the file");
  Grain& grain = list.grains[found->second];
  grain.velocity = units.speed() * vector(line, 1, "velocity");
  if (line.words.size() >= 7) grain.spin = (1.0 / units.time) * vector(line, 4, "angular velocity");
}

/// Where the columns of a dump are.
struct Columns {
  explicit Columns(const TableLine& line) : line_(line) {}
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
      for (std::size_t k = 2; k < line_.words.size(); ++k) {
        if (line_.words[k] == name) return k - 2;
      }
    }
    return {};
  }
  std::optional<VectorColumns> find_vector(std::string_view x, std::string_view y, std::string_view z) const {
    const auto a = find({x});
    const auto b = find({y});
    const auto c = find({z});
    if (!a || !b || !c) return {};
    return VectorColumns{*a, *b, *c};
  }

 private:
  const TableLine& line_;
};

/// What is read of each line of a dump.
struct DumpForm {
  std::optional<std::size_t> id = {}, type = {}, radius = {}, diameter = {}, density = {}, mass = {};
  VectorColumns position{};
  bool is_scaled = false;  ///< positions are shares of the box
  std::optional<VectorColumns> velocity = {}, spin = {};
};

DumpForm form_of(const TableLine& head) {
  const Columns columns(head);
  DumpForm form{columns.find({"id"}),       columns.find({"type"}),    columns.find({"radius"}),
                columns.find({"diameter"}), columns.find({"density"}), columns.find({"mass"})};
  form.velocity = columns.find_vector("vx", "vy", "vz");
  form.spin = columns.find_vector("omegax", "omegay", "omegaz");
  const auto plain = columns.find_vector("x", "y", "z");
  const auto unwrapped = columns.find_vector("xu", "yu", "zu");
  const auto scaled = columns.find_vector("xs", "ys", "zs");
  if (!plain && !unwrapped && !scaled) refuse(head.place, "a dump without x, y, z");
  if (!form.radius && !form.diameter) refuse(head.place, "a dump without radius or diameter");
  form.is_scaled = !plain && !unwrapped;
  form.position = plain ? *plain : unwrapped ? *unwrapped : *scaled;
  return form;
}

Grain dump_grain(const TableLine& line, const DumpForm& form, const Extent& box, const ScriptUnits& units,
                 std::int64_t place) {
  Grain grain;
  grain.id = form.id ? whole(line, *form.id, "id") : place;
  grain.type = form.type ? static_cast<int>(whole(line, *form.type, "type")) : 1;
  grain.radius = units.length *
                 (form.radius ? number(line, *form.radius, "radius") : 0.5 * number(line, *form.diameter, "diameter"));
  const Vec3 at = vector(line, form.position, "position");
  const Vec3 size = box.max - box.min;
  grain.position = form.is_scaled ? box.min + Vec3{at.x * size.x, at.y * size.y, at.z * size.z} : units.length * at;
  if (form.velocity) grain.velocity = units.speed() * vector(line, *form.velocity, "velocity");
  if (form.spin) grain.spin = (1.0 / units.time) * vector(line, *form.spin, "angular velocity");
  if (form.density) {
    grain.density = number(line, *form.density, "density") * units.density();
  } else if (form.mass && grain.radius > 0.0) {
    grain.density = number(line, *form.mass, "mass") * units.mass / sphere_volume(grain.radius);
  }
  check(grain, line.place, false);
  return grain;
}

}  // namespace

GrainList parse_data_file(std::string_view text, const std::string& file, const ScriptUnits& units) {
  const std::vector<TableLine> lines = table_lines(text, file);
  GrainList list;
  std::map<std::int64_t, std::size_t> place_of;
  std::int64_t atoms = -1;
  std::string section;
  for (std::size_t at = 1; at < lines.size(); ++at) {  // the first line is a title
    const TableLine& line = lines[at];
    if (line.words.empty()) continue;
    if (is_section(line.words[0])) {
      section = line.words[0];
    } else if (section.empty()) {
      header_line(line, units, atoms, list);
    } else if (section == "Atoms") {
      const Grain grain = data_grain(line, units);
      if (!place_of.emplace(grain.id, list.grains.size()).second) refuse(line.place, "an id that was there before");
      list.grains.push_back(grain);
    } else if (section == "Velocities") {
      set_velocity(line, units, place_of, list);
    }
  }
  const Place end{file, std::max<std::size_t>(1, lines.size())};
  if (atoms < 0) refuse(end, "no data file: no line says how many atoms there are");
  if (atoms != std::ssize(list.grains))
    refuse(end, fmt::format("{} atoms of the {} that the file declares", list.grains.size(), atoms));
  return list;
}

GrainList parse_dump(std::string_view text, const std::string& file, const ScriptUnits& units) {
  const std::vector<TableLine> lines = table_lines(text, file);
  GrainList list;
  Extent box;
  std::int64_t atoms = -1;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    const TableLine& line = lines[at];
    if (line.words.size() < 2 || line.words[0] != "ITEM:") continue;
    if (line.words[1] == "TIMESTEP" && at + 1 < lines.size()) {
      list.step = integer_of(word(lines[at + 1], 0, "step"), lines[at + 1].place, "step", latest_step);
    } else if (line.words[1] == "NUMBER" && at + 1 < lines.size()) {
      atoms = whole(lines[at + 1], 0, "number of atoms");
    } else if (line.words[1] == "BOX" && at + 3 < lines.size()) {
      std::size_t k = at;
      for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        ++k;
        box.min.*component = number(lines[k], 0, "box") * units.length;
        box.max.*component = number(lines[k], 1, "box") * units.length;
        if (!(box.min.*component < box.max.*component)) refuse(lines[k].place, "the box has no volume");
      }
      list.box = box;
    } else if (line.words[1] == "ATOMS") {
      const DumpForm form = form_of(line);
      if (atoms < 0 || static_cast<std::size_t>(atoms) >= lines.size() - at) {
        refuse(line.place, fmt::format("the file ends before its {} atoms", atoms));
      }
      list.grains.clear();
      for (std::int64_t k = 0; k < atoms; ++k) list.grains.push_back(dump_grain(lines[++at], form, box, units, k + 1));
    }
  }
  if (list.grains.empty())
    refuse({file, std::max<std::size_t>(1, lines.size())}, "no dump: there are no ITEM: ATOMS with lines behind");
  std::sort(list.grains.begin(), list.grains.end(), [](const Grain& a, const Grain& b) { return a.id < b.id; });
  for (const Grain& grain : list.grains) list.types = std::max(list.types, grain.type);
  return list;
}

std::string grain_csv(const std::vector<std::pair<Grain, std::string>>& grains_and_materials) {
  std::string text = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
  for (const auto& [grain, material] : grains_and_materials) {
    for (const Vec3& v : {grain.position, grain.velocity, grain.spin}) {
      for (const double value : {v.x, v.y, v.z}) text += shortest_text(value) + ",";
    }
    text += shortest_text(grain.radius) + "," + material + "\n";
  }
  return text;
}

bool is_inside(const ScriptRegion& region, const Vec3& p) {
  if (region.kind == "block") {
    const auto& [min, max] = region.block;
    const bool inside = p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
    return inside == region.is_inside;
  }
  if (region.kind != "cylinder")
    refuse(region.place, fmt::format("a region that is a {} has no counterpart", region.kind));
  const double along = region.axis == 'x' ? p.x : region.axis == 'y' ? p.y : p.z;
  const double a = (region.axis == 'x' ? p.y : p.x) - region.c1;
  const double b = (region.axis == 'z' ? p.y : p.z) - region.c2;
  const bool inside = a * a + b * b <= region.radius * region.radius && along >= region.low && along <= region.high;
  return inside == region.is_inside;
}

}  // namespace repose
