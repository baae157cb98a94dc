#include "fields/fields_of.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fields/coarse_grain.h"
#include "fields/find_contacts.h"
#include "fields/image_data.h"
#include "files/csv_file.h"
#include "scene/particles/sphere_mass.h"

namespace repose::fields {
namespace {

std::vector<Grain> grains_of(const State& state) {
  std::vector<Grain> grains;
  for (std::size_t i = 0; i < state.particles.owned; ++i) {
    const ParticleRecord& p = state.particles.record[i];
    const double density = state.materials[static_cast<std::size_t>(state.particles.material[i])].density;
    grains.push_back({p.position, p.velocity, sphere_mass(p.radius, density), sphere_mass(p.radius, 1.0)});
  }
  return grains;
}

/// Surfaces count beside centres: kernels lie about the touched points of walls, too.
Grid grid_of(const State& state, const Resolution& resolution, const std::string& file) {
  Vec3 low = state.particles.record[0].position;
  Vec3 high = low;
  for (const ParticleRecord& p : state.particles.record) {
    const auto widen = [&](double Vec3::*x) {
      low.*x = std::min(low.*x, p.position.*x - p.radius);
      high.*x = std::max(high.*x, p.position.*x + p.radius);
    };
    for (double Vec3::*x : {&Vec3::x, &Vec3::y, &Vec3::z}) widen(x);
  }
  return grid_around(low, high, state.deck.domain, resolution, file);
}

std::string lines_of(const State& state, const std::string& file, const ContactForces& contacts, const Fields& f,
                     const FieldsHead& head) {
  const double mass = f.grid.cell_volume() * std::accumulate(f.mass_density.begin(), f.mass_density.end(), 0.0);
  std::string text = fmt::format(
      "{}: step {}, {:.6g} s: {} grains, {} contacts of two grains, {} with walls\n"
      "  {} x {} x {} cells of {:.4g} x {:.4g} x {:.4g} mm, kernel of half-width {:.4g} mm; mass {:.6g} g\n"
      "  contact stress of {} forces\n",
      file, state.step, state.time, state.particles.owned, contacts.pairs.size(), contacts.walls.size(),
      f.grid.cells[0], f.grid.cells[1], f.grid.cells[2], 1e3 * f.grid.spacing[0], 1e3 * f.grid.spacing[1],
      1e3 * f.grid.spacing[2], 1e3 * head.width, 1e3 * mass, head.contact_forces);
  if (state.unknown_walls.empty()) return text;
  return text + fmt::format(
                    "  without contacts with {}, as a snapshot does not say where such walls are: a checkpoint "
                    "does\n",
                    fmt::join(state.unknown_walls, ", "));
}

}  // namespace

Resolution resolution_for(const State& state, Resolution given) {
  double diameters = 0.0;
  for (const ParticleRecord& p : state.particles.record) diameters += 2.0 * p.radius;
  if (given.width == 0.0) given.width = 3.0 * diameters / static_cast<double>(state.particles.owned);
  if (given.spacing == 0.0) given.spacing = given.width / 3.0;
  return given;
}

FieldsOfFile fields_of(const State& state, const std::string& file, const Resolution& resolution) {
  const Grid grid = grid_of(state, resolution, file);
  const ContactForces contacts = find_contacts(state, file);
  const Fields fields = coarse_grain(grid, resolution.width, grains_of(state), contacts);
  const FieldsHead head = {state.time, resolution.width, state.remembers ? "normal and tangential" : "normal"};
  return {state.step, state.time, image_data(fields, head), lines_of(state, file, contacts, fields, head)};
}

std::string series_text(const std::vector<std::pair<double, std::string>>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [time, name] : files) {
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", shortest_text(time), name);
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace repose::fields
