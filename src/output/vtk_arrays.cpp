#include "output/vtk_arrays.h"

#include <bit>
#include <stdexcept>

#include <zlib.h>

namespace repose {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes are written as they are");

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_SPEED);
  if (code != Z_OK) throw std::runtime_error("zlib cannot compress");
  packed.resize(size);
  return packed;
}

}  // namespace

std::string VtkArrays::array(const char* type, const char* name, int components, std::string_view bytes) {
  std::string element =
      fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                  type, name, components, bytes_.size());
  if (compression_ == Compression::zlib) {
    append_compressed(bytes);
  } else {
    append_number(bytes.size());
    bytes_.append(bytes);
  }
  return element;
}

void VtkArrays::append_number(std::uint64_t number) {
  bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Blocks of one size but for the last: their number, the size, that of the last if it is smaller, their compressed
/// sizes, and they.
void VtkArrays::append_compressed(std::string_view bytes) {
  constexpr std::size_t block = 1 << 20;
  const std::size_t count = (bytes.size() + block - 1) / block;
  std::string packed;
  append_number(count);
  append_number(block);
  append_number(bytes.size() % block);
  for (std::size_t k = 0; k < count; ++k) {
    const std::string one = deflated(bytes.substr(k * block, block));
    append_number(one.size());
    packed += one;
  }
  bytes_ += packed;
}

}  // namespace repose
