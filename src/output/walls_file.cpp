#include "output/walls_file.h"

#include "output/poly_data.h"
#include "output/vector_rows.h"
#include "output/vtk_arrays.h"
#include "scene/walls/wall_surface.h"

namespace repose {

std::string walls_text(std::span<const Wall> walls, const DomainDeck& domain, double time_s) {
  std::vector<double> points;
  std::vector<std::int64_t> wall, connectivity, ends;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!walls[w].present) continue;
    const WallSurface surface = surface_of(walls[w], domain);
    const std::size_t before = points.size() / 3;
    for (const Vec3& point : surface.points) append_vector(points, point);
    for (const std::vector<std::size_t>& polygon : surface.polygons) {
      for (const std::size_t corner : polygon) connectivity.push_back(static_cast<std::int64_t>(before + corner));
      ends.push_back(std::ssize(connectivity));
      wall.push_back(static_cast<std::int64_t>(w));
    }
  }
  VtkArrays data(VtkArrays::Compression::zlib);
  std::string text = poly_data_begin(data, time_s, {.points = points.size() / 3, .polys = ends.size()});
  text += "<CellData>\n" + data.array("wall", wall) + "</CellData>\n";
  text += "<Points>\n" + data.array("position", 3, points) + "</Points>\n";
  text += "<Polys>\n" + data.array("connectivity", connectivity) + data.array("offsets", ends) + "</Polys>\n";
  return text + poly_data_end(data);
}

}  // namespace repose
