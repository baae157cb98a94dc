#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace repose {

/// The arrays of an XML file of VTK (byte_order LittleEndian, header_type UInt64): elements that name them, and their
/// bytes, which go behind the XML as AppendedData with the encoding raw.
class VtkArrays {
 public:
  enum class Compression { none, zlib };  ///< zlib: the file must name the compressor vtkZLibDataCompressor
  explicit VtkArrays(Compression compression = Compression::none) : compression_(compression) {}

  template <class T>
  std::string array(const char* type, const char* name, int components, std::span<const T> values) {
    return array(type, name, components, {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  std::string array(const char* name, int components, const std::vector<double>& values) {
    return array("Float64", name, components, std::span<const double>(values));
  }
  std::string array(const char* name, const std::vector<std::int64_t>& values) {
    return array("Int64", name, 1, std::span<const std::int64_t>(values));
  }
  const std::string& bytes() const { return bytes_; }
  bool is_compressed() const { return compression_ == Compression::zlib; }

 private:
  std::string array(const char* type, const char* name, int components, std::string_view bytes);
  void append_number(std::uint64_t number);
  void append_compressed(std::string_view bytes);

  Compression compression_;
  std::string bytes_;
};

}  // namespace repose
