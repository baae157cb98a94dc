#include "output/snapshot.h"

#include <array>
#include <numeric>
#include <stdexcept>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/hdf5_file.h"

namespace repose {

namespace {

RowBlock rows_of(const ParticleTable& particles) {
  return {particles.total, particles.offset, std::ssize(particles.id)};
}

/// What the file may need: more than the arrays hold before they are compressed.
std::int64_t most_bytes(const ParticleTable& particles, const SnapshotHeader& header) {
  constexpr std::int64_t bytes_per_particle = 168;  // 125 in the arrays below
  constexpr std::int64_t bytes_of_structure = 1 << 20;
  return bytes_of_structure + std::ssize(header.deck) + particles.total * bytes_per_particle;
}

/// The cells of the grid: cell i is the vertex i.
struct VertexCells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  RowBlock offset_rows;
};

VertexCells vertex_cells(RowBlock rows, bool is_root) {
  constexpr std::uint8_t vtk_vertex = 1;  // vtkCellType.h
  VertexCells cells;
  cells.connectivity.resize(static_cast<std::size_t>(rows.count));
  std::iota(cells.connectivity.begin(), cells.connectivity.end(), rows.offset);
  cells.types.assign(cells.connectivity.size(), vtk_vertex);
  // There is one offset more than there are cells: the end of the last cell goes to the rank that holds this cell.
  cells.offsets = cells.connectivity;
  const bool holds_end = rows.total == 0 ? is_root : rows.count > 0 && rows.offset + rows.count == rows.total;
  if (holds_end) cells.offsets.push_back(rows.total);
  cells.offset_rows = {rows.total + 1, rows.offset, std::ssize(cells.offsets)};
  return cells;
}

void write_header(Hdf5File& file, const SnapshotHeader& header) {
  file.write_attribute("/", "step", header.step);
  file.write_attribute("/", "time_s", header.time_s);
  file.write_attribute("/", "state_hash", header.state_hash);
  file.write_attribute("/", "inserted", header.inserted);
  file.write_attribute("/", "inside", header.inside);
  file.write_attribute("/", "left", header.left);
  file.write_attribute("/", "materials", std::span<const std::string>(header.materials));
  file.write_attribute("/", "deck", header.deck);
  for (const auto& [name, text] : build_fields(header.build)) file.write_attribute("/", "build_" + name, text);
}

void write_particles(Hdf5File& file, const ParticleTable& particles) {
  const RowBlock rows = rows_of(particles);
  const auto write = [&](const std::string& name, const auto& values, int columns, const std::string& unit) {
    const std::string dataset = "/particles/" + name;
    file.write_rows(dataset, std::span(values), rows, columns);
    if (!unit.empty()) file.write_attribute(dataset, "unit", unit);
  };
  file.create_group("/particles");
  write("id", particles.id, 1, "");
  write("position", particles.position, 3, "m");
  write("velocity", particles.velocity, 3, "m/s");
  write("angular_velocity", particles.angular_velocity, 3, "rad/s");
  write("radius", particles.radius, 1, "m");
  write("mass", particles.mass, 1, "kg");
  write("material", particles.material, 1, "");
  if (particles.has_temperature) write("temperature", particles.temperature, 1, "K");
}

/// The VTKHDF 1.0 file format, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html, one partition.
void write_vtk_view(Hdf5File& file, const Communicator& comm, RowBlock rows, bool has_temperature) {
  file.create_group("/VTKHDF");
  constexpr std::array<std::int64_t, 2> version{1, 0};
  file.write_attribute("/VTKHDF", "Version", std::span<const std::int64_t>(version));
  file.write_ascii_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const std::vector<std::int64_t> size(comm.is_root() ? 1 : 0, rows.total);
  const RowBlock single{1, 0, std::ssize(size)};
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    file.write_rows(fmt::format("/VTKHDF/{}", name), std::span(size), single);
  }
  const VertexCells cells = vertex_cells(rows, comm.is_root());
  file.write_rows("/VTKHDF/Connectivity", std::span(cells.connectivity), rows);
  file.write_rows("/VTKHDF/Offsets", std::span(cells.offsets), cells.offset_rows);
  file.write_rows("/VTKHDF/Types", std::span(cells.types), rows);
  file.link("/particles/position", "/VTKHDF/Points");
  file.create_group("/VTKHDF/PointData");
  for (const char* name : {"id", "velocity", "angular_velocity", "radius", "mass", "material"}) {
    file.link(fmt::format("/particles/{}", name), fmt::format("/VTKHDF/PointData/{}", name));
  }
  if (has_temperature) file.link("/particles/temperature", "/VTKHDF/PointData/temperature");
}

void check_blocks(const Communicator& comm, const ParticleTable& particles) {
  const RowBlock rows = rows_of(particles);
  const std::int64_t below = comm.exclusive_sum(rows.count);
  const std::int64_t all = comm.sum(rows.count);
  agree_after(comm, [&] {
    if (all != particles.total || (rows.count > 0 && rows.offset != below)) {
      throw std::logic_error(
          fmt::format("particle table: rank {} holds {} rows from {}, but {} rows lie on lower ranks; "
                      "{} rows of {} in all",
                      comm.rank(), rows.count, rows.offset, below, all, particles.total));
    }
  });
}

}  // namespace

void write_snapshot(const Communicator& comm, const std::string& path, const ParticleTable& particles,
                    const SnapshotHeader& header) {
  if (!path.ends_with(".hdf"))
    throw FileError(path + ": the name of a snapshot must end in .hdf (VTK's reader asks for it)");
  check_blocks(comm, particles);
  Hdf5File file(comm, path, most_bytes(particles, header));
  write_header(file, header);
  write_particles(file, particles);
  write_vtk_view(file, comm, rows_of(particles), particles.has_temperature);
  file.close();
}

}  // namespace repose
