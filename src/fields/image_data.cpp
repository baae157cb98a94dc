#include "fields/image_data.h"

#include <fmt/core.h>

#include "files/csv_file.h"
#include "output/vector_rows.h"
#include "output/vtk_arrays.h"

namespace repose::fields {
namespace {

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) append_vector(values, v);
  return values;
}

std::vector<double> flat(const std::vector<Tensor>& tensors) {
  std::vector<double> values;
  values.reserve(9 * tensors.size());
  for (const Tensor& t : tensors) values.insert(values.end(), t.begin(), t.end());
  return values;
}

/// A third of the trace of the whole stress.
std::vector<double> pressure(const Fields& f) {
  std::vector<double> values;
  for (std::size_t cell = 0; cell < f.grid.size(); ++cell) {
    double trace = 0.0;
    for (const std::size_t k : {0U, 4U, 8U}) trace += f.contact_stress[cell][k] + f.kinetic_stress[cell][k];
    values.push_back(trace / 3.0);
  }
  return values;
}

std::string three(const Triple& values) {
  return shortest_text(values[0]) + " " + shortest_text(values[1]) + " " + shortest_text(values[2]);
}

/// Texts are there as the codes of their characters.
std::string text_array(const char* name, const std::string& text) {
  std::string codes;
  for (const char c : text) codes += fmt::format("{} ", static_cast<int>(c));
  return fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{}0</Array>\n", name,
                     codes);
}

std::string one_tuple(std::string element) {
  element.insert(element.rfind(" format="), " NumberOfTuples=\"1\"");
  return element;
}

}  // namespace

std::string image_data(const Fields& f, const FieldsHead& head) {
  VtkArrays data(VtkArrays::Compression::zlib);
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", f.grid.cells[0], f.grid.cells[1], f.grid.cells[2]);
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\">\n";
  text += fmt::format("<ImageData WholeExtent=\"{}\" Origin=\"{}\" Spacing=\"{}\">\n", extent, three(f.grid.origin),
                      three(f.grid.spacing));
  text += "<FieldData>\n" + one_tuple(data.array("TimeValue", 1, {head.time}));
  text += one_tuple(data.array("kernel_half_width", 1, {head.width}));
  text += text_array("contact_forces", head.contact_forces) + "</FieldData>\n";
  text += fmt::format("<Piece Extent=\"{}\">\n<CellData Scalars=\"solid_fraction\">\n", extent);
  text += data.array("solid_fraction", 1, f.solid_fraction) + data.array("mass_density", 1, f.mass_density);
  text += data.array("momentum_density", 3, flat(f.momentum)) + data.array("velocity", 3, flat(f.velocity));
  text += data.array("granular_temperature", 1, f.temperature) + data.array("pressure", 1, pressure(f));
  text += data.array("contact_stress", 9, flat(f.contact_stress));
  text += data.array("kinetic_stress", 9, flat(f.kinetic_stress));
  text += data.array("wall_force_density", 3, flat(f.wall_force)) + "</CellData>\n</Piece>\n</ImageData>\n";
  return text + "<AppendedData encoding=\"raw\">\n_" + data.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace repose::fields
