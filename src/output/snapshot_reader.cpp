#include "output/snapshot_reader.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "base/error.h"
#include "output/hdf5_file.h"
#include "output/hdf5_handle.h"

namespace repose {
namespace {

/// Opens a file that is in memory already: every rank has its bytes, none needs the disk.
Hdf5FileHandle open_image(const std::string& bytes, const std::string& file) {
  constexpr std::size_t increment = 1 << 20;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions, once
  const Hdf5Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_fapl_core(access.get(), increment, false);
  std::string image = bytes;                   // HDF5 asks for memory it could write to
  const char* const name = "/dev/null/image";  // HDF5 refuses the name of a file that is there; this can be none
  H5Pset_file_image(access.get(), image.data(), image.size());
  return Hdf5FileHandle(check_hdf5(H5Fopen(name, H5F_ACC_RDONLY, access.get()), file, "read as a snapshot"));
}

template <class T>
std::vector<T> read_array(const Hdf5FileHandle& snapshot, const std::string& name, std::size_t columns,
                          const std::string& file) {
  const std::string path = "/particles/" + name;
  const std::string action = "read " + path + ", which every snapshot has";
  const Hdf5Dataset dataset(check_hdf5(H5Dopen2(snapshot.get(), path.c_str(), H5P_DEFAULT), file, action));
  const Hdf5Space space(check_hdf5(H5Dget_space(dataset.get()), file, action));
  const auto size = static_cast<std::size_t>(check_hdf5(H5Sget_simple_extent_npoints(space.get()), file, action));
  std::vector<T> values(size);
  check_hdf5(H5Dread(dataset.get(), hdf5_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), file, action);
  if (size % columns != 0)
    throw FileError(fmt::format("{}: {} has {} values, no multiple of {}", file, path, size, columns));
  return values;
}

/// The attribute "materials" of the root: names of any length.
std::vector<std::string> read_materials(const Hdf5FileHandle& snapshot, const std::string& file) {
  const std::string action = "read the attribute materials, which every snapshot has";
  const Hdf5Attribute attribute(check_hdf5(H5Aopen(snapshot.get(), "materials", H5P_DEFAULT), file, action));
  const Hdf5Space space(check_hdf5(H5Aget_space(attribute.get()), file, action));
  const Hdf5Type type(check_hdf5(H5Aget_type(attribute.get()), file, action));
  std::vector<char*> texts(
      static_cast<std::size_t>(check_hdf5(H5Sget_simple_extent_npoints(space.get()), file, action)));
  if (H5Tis_variable_str(type.get()) <= 0) throw FileError(fmt::format("{}: cannot {}", file, action));
  check_hdf5(H5Aread(attribute.get(), type.get(), texts.data()), file, action);
  const std::vector<std::string> names(texts.begin(), texts.end());
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, texts.data());
  return names;
}

std::int64_t read_count(const Hdf5FileHandle& snapshot, const char* name, const std::string& file) {
  const std::string action = fmt::format("read the attribute {}, which every snapshot has", name);
  const Hdf5Attribute attribute(check_hdf5(H5Aopen(snapshot.get(), name, H5P_DEFAULT), file, action));
  std::int64_t count = 0;
  check_hdf5(H5Aread(attribute.get(), hdf5_type<std::int64_t>(), &count), file, action);
  return count;
}

/// The index in the deck of each material of the snapshot; -1: the deck does not have it.
std::vector<int> translation(const std::vector<std::string>& names, const std::vector<MaterialDeck>& materials) {
  std::vector<int> indices;
  for (const std::string& name : names) {
    const auto found = std::find_if(materials.begin(), materials.end(), [&](const auto& m) { return m.name == name; });
    indices.push_back(found == materials.end() ? -1 : static_cast<int>(found - materials.begin()));
  }
  return indices;
}

std::vector<Vec3> vectors(std::span<const double> values) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) result.push_back({values[i], values[i + 1], values[i + 2]});
  return result;
}

}  // namespace

bool is_snapshot(const std::string& bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

std::int64_t left_before_snapshot(const std::string& bytes, const std::string& file) {
  return read_count(open_image(bytes, file), "left", file);
}

NewParticles parse_snapshot(const std::string& bytes, const std::string& file,
                            const std::vector<MaterialDeck>& materials) {
  const Hdf5FileHandle snapshot = open_image(bytes, file);
  NewParticles particles;
  particles.position = vectors(read_array<double>(snapshot, "position", 3, file));
  particles.velocity = vectors(read_array<double>(snapshot, "velocity", 3, file));
  particles.spin = vectors(read_array<double>(snapshot, "angular_velocity", 3, file));
  particles.radius = read_array<double>(snapshot, "radius", 1, file);
  const std::size_t count = particles.size();
  const std::vector<std::string> names = read_materials(snapshot, file);
  const std::vector<int> indices = translation(names, materials);
  for (const std::int32_t material : read_array<std::int32_t>(snapshot, "material", 1, file)) {
    const auto m = static_cast<std::size_t>(material);
    if (m >= indices.size()) throw FileError(fmt::format("{}: material {} has no name", file, material));
    if (indices[m] < 0)
      throw DeckError(fmt::format("{}: no material is named \"{}\"; add it to the deck", file, names[m]));
    particles.material.push_back(indices[m]);
  }
  if (particles.velocity.size() != count || particles.spin.size() != count || particles.radius.size() != count ||
      particles.material.size() != count) {
    throw FileError(fmt::format("{}: the arrays of /particles differ in length", file));
  }
  if (count == 0) throw DeckError(fmt::format("{}: the snapshot holds no particles", file));
  return particles;
}

}  // namespace repose
