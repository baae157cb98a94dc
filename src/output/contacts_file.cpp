#include "output/contacts_file.h"

#include "output/poly_data.h"
#include "output/vector_rows.h"
#include "output/vtk_arrays.h"

namespace repose {

std::string contacts_text(std::span<const ListedContact> contacts, double time_s) {
  std::vector<double> points, normal, tangential;
  std::vector<std::int64_t> first, second, wall, connectivity, ends;
  for (const ListedContact& c : contacts) {
    append_vector(points, c.centre);
    append_vector(points, c.other);
    append_vector(normal, c.normal_force);
    append_vector(tangential, c.tangential_force);
    first.push_back(c.first);
    second.push_back(c.second);
    wall.push_back(c.wall);
    connectivity.push_back(std::ssize(connectivity));
    connectivity.push_back(std::ssize(connectivity));
    ends.push_back(std::ssize(connectivity));
  }
  VtkArrays data(VtkArrays::Compression::zlib);
  std::string text = poly_data_begin(data, time_s, {.points = 2 * contacts.size(), .lines = contacts.size()});
  text += "<CellData>\n" + data.array("first", first) + data.array("second", second) + data.array("wall", wall);
  text += data.array("normal_force", 3, normal) + data.array("tangential_force", 3, tangential) + "</CellData>\n";
  text += "<Points>\n" + data.array("position", 3, points) + "</Points>\n";
  text += "<Lines>\n" + data.array("connectivity", connectivity) + data.array("offsets", ends) + "</Lines>\n";
  return text + poly_data_end(data);
}

}  // namespace repose
