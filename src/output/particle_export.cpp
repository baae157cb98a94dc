#include "output/particle_export.h"

#include <cstdint>
#include <numeric>
#include <span>

#include <fmt/core.h>

#include "files/csv_file.h"
#include "output/dump_export.h"
#include "output/poly_data.h"
#include "output/vector_rows.h"
#include "output/vtk_arrays.h"

namespace repose {
namespace {

std::vector<double> flat(std::span<const Vec3> vectors) {
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) append_vector(values, v);
  return values;
}

}  // namespace

std::string vtp_text(const SnapshotParticles& snapshot) {
  const NewParticles& p = snapshot.particles;
  std::vector<std::int64_t> vertices(p.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<std::int64_t> ends(p.size());
  std::iota(ends.begin(), ends.end(), 1);
  VtkArrays data;
  std::string text = poly_data_begin(data, snapshot.time_s, {.points = p.size(), .verts = p.size()});
  text += "<PointData Scalars=\"radius\">\n" + data.array("id", p.id);
  text += data.array("velocity", 3, flat(p.velocity)) + data.array("angular_velocity", 3, flat(p.spin));
  text += data.array("radius", 1, p.radius) + data.array("mass", 1, snapshot.mass);
  if (!p.temperature.empty()) text += data.array("temperature", 1, p.temperature);
  text += data.array("Int32", "material", 1, std::span<const int>(p.material)) + "</PointData>\n";
  text += "<Points>\n" + data.array("position", 3, flat(p.position)) + "</Points>\n";
  text += "<Verts>\n" + data.array("connectivity", vertices) + data.array("offsets", ends) + "</Verts>\n";
  return text + poly_data_end(data);
}

namespace {
constexpr const char* csv_header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
}  // namespace

std::string csv_text(const SnapshotParticles& snapshot) {
  const NewParticles& p = snapshot.particles;
  std::string text = csv_header;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const Vec3& v : {p.position[i], p.velocity[i], p.spin[i]}) {
      for (const double value : {v.x, v.y, v.z}) text += shortest_text(value) + ",";
    }
    text += shortest_text(p.radius[i]) + "," + snapshot.materials[static_cast<std::size_t>(p.material[i])] + "\n";
  }
  return text;
}

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats = {
      {"vtp", "PolyData of VTK", vtp_text, "Name=\"angular_velocity\""},
      {"csv", "a list that measure and decks read", csv_text, csv_header},
      {"dump", "a text dump of LIGGGHTS and LAMMPS", dump_text, "ITEM: TIMESTEP\n"},
      {"h5md", "the HDF5 format of molecular dynamics", h5md_bytes, "h5md"},
  };
  return formats;
}

}  // namespace repose
