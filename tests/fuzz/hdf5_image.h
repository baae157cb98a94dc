#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace repose::fuzz {

/// A dataset, an attribute of the root group ("@name"), or a link to another file, of an HDF5 file that is valid as
/// such, whatever it says.
struct Hdf5Item {
  enum class Kind { data, external_link };
  enum class Type { f32, f64, i8, i32, i64, u64, text, fixed_text, compound };

  std::string path;  ///< "/particles/position"; groups on the way are made
  Kind kind = Kind::data;
  Type type = Type::f64;
  std::vector<std::uint64_t> shape;  ///< rows first; empty: a scalar
  bool has_values = true;            ///< false: of the null dataspace
  std::vector<double> numbers;     ///< written in the order of rows; fewer than the shape has: the rest stays unwritten
  std::vector<std::string> texts;  ///< of the type text or fixed_text
  std::uint64_t rows_per_chunk = 0;  ///< 0: contiguous
  bool is_deflated = false;          ///< needs chunks
  std::string stored_in;             ///< name of another file that holds the values; empty: this one
  std::string target;                ///< of a link, "file:path"
};

/// The bytes of an HDF5 file with these items, made in memory. What HDF5 itself refuses to make is left out.
std::string hdf5_image(const std::vector<Hdf5Item>& items);

/// Items from lines of text, so that a fuzzer changes numbers and words and not bytes of HDF5's own format:
///   /particles/position f64 2x3 chunk 1 deflate = 0 0 nan 1 -1e300 2
///   /particles/radius f64 1152921504606846976 chunk 10000 =
///   /particles/mass f64 4 in /dev/zero =
///   /particles/material null i32 =
///   @materials text 2 = glass steel
///   /particles/velocity link other.hdf:/particles/velocity
/// A line that says nothing is left out.
std::vector<Hdf5Item> parse_hdf5_items(std::string_view text);

}  // namespace repose::fuzz
