#include "output/poly_data.h"

#include <fmt/core.h>

namespace repose {

std::string poly_data_begin(VtkArrays& data, double time_s, const PolyDataCounts& counts) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"{}>\n<PolyData>\n",
      data.is_compressed() ? " compressor=\"vtkZLibDataCompressor\"" : "");
  text += "<FieldData>\n" + data.array("TimeValue", 1, {time_s});
  text.insert(text.rfind(" format="), " NumberOfTuples=\"1\"");
  text += "</FieldData>\n";
  return text + fmt::format(
                    "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"{}\">\n",
                    counts.points, counts.verts, counts.lines, counts.polys);
}

std::string poly_data_end(const VtkArrays& data) {
  return "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace repose
