#include "hdf5_image.h"

#include <algorithm>
#include <cmath>

#include "files/hdf5_handle.h"

namespace repose::fuzz {

namespace {

using Type = Hdf5Item::Type;

Hdf5Type type_of(const Hdf5Item& item) {
  constexpr std::size_t fixed_length = 8;
  switch (item.type) {
    case Type::f32:
      return Hdf5Type(H5Tcopy(H5T_IEEE_F32LE));
    case Type::f64:
      return Hdf5Type(H5Tcopy(H5T_IEEE_F64LE));
    case Type::i8:
      return Hdf5Type(H5Tcopy(H5T_STD_I8LE));
    case Type::i32:
      return Hdf5Type(H5Tcopy(H5T_STD_I32LE));
    case Type::i64:
      return Hdf5Type(H5Tcopy(H5T_STD_I64LE));
    case Type::u64:
      return Hdf5Type(H5Tcopy(H5T_STD_U64LE));
    case Type::text:
    case Type::fixed_text: {
      Hdf5Type text(H5Tcopy(H5T_C_S1));
      H5Tset_size(text.get(), item.type == Type::text ? H5T_VARIABLE : fixed_length);
      return text;
    }
    case Type::compound: {
      Hdf5Type compound(H5Tcreate(H5T_COMPOUND, sizeof(double)));
      H5Tinsert(compound.get(), "x", 0, H5T_NATIVE_DOUBLE);
      return compound;
    }
  }
  return Hdf5Type(H5I_INVALID_HID);
}

Hdf5Space space_of(const Hdf5Item& item) {
  if (!item.has_values) return Hdf5Space(H5Screate(H5S_NULL));
  if (item.shape.empty()) return Hdf5Space(H5Screate(H5S_SCALAR));
  const std::vector<hsize_t> shape(item.shape.begin(), item.shape.end());
  return Hdf5Space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
}

/// Whether the item's texts or numbers fill its shape; a shape without end is never full.
bool is_full(const Hdf5Item& item) {
  double wanted = item.has_values ? 1.0 : 0.0;
  for (const std::uint64_t size : item.shape) wanted *= static_cast<double>(size);
  return static_cast<double>(std::max(item.texts.size(), item.numbers.size())) >= wanted;
}

Hdf5Properties dataset_properties(const Hdf5Item& item) {
  Hdf5Properties properties(H5Pcreate(H5P_DATASET_CREATE));
  if (!item.stored_in.empty()) H5Pset_external(properties.get(), item.stored_in.c_str(), 0, H5F_UNLIMITED);
  if (item.rows_per_chunk == 0 || item.shape.empty()) return properties;
  std::vector<hsize_t> chunk(item.shape.begin(), item.shape.end());
  chunk.front() = item.rows_per_chunk;
  H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
  if (item.is_deflated) {
    H5Pset_shuffle(properties.get());
    H5Pset_deflate(properties.get(), 1);
  }
  return properties;
}

/// The values in memory, as double or char*, for H5Dwrite and H5Awrite.
struct Values {
  explicit Values(const Hdf5Item& item) : numbers(item.numbers) {
    for (const std::string& text : item.texts) starts.push_back(text.c_str());
    if (item.type == Type::fixed_text) {
      for (const std::string& text : item.texts)
        fixed += text.substr(0, 8) + std::string(8 - std::min<std::size_t>(8, text.size()), '\0');
    }
  }
  const void* data(Type type) const {
    if (type == Type::fixed_text) return fixed.data();
    return type == Type::text ? static_cast<const void*>(starts.data()) : numbers.data();
  }

  std::vector<double> numbers;
  std::vector<const char*> starts;
  std::string fixed;
};

hid_t memory_type(const Hdf5Item& item, const Hdf5Type& type) {
  const bool is_number = item.type != Type::text && item.type != Type::fixed_text && item.type != Type::compound;
  return is_number ? H5T_NATIVE_DOUBLE : type.get();
}

/// The first values of a list that is chunked, so that one of its chunks is there and the others are not.
void write_first(const Hdf5Dataset& dataset, const Hdf5Space& disk, const Hdf5Item& item) {
  const hsize_t count = item.numbers.size();
  const hsize_t start = 0;
  const Hdf5Space memory(H5Screate_simple(1, &count, nullptr));
  H5Sselect_hyperslab(disk.get(), H5S_SELECT_SET, &start, nullptr, &count, nullptr);
  H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, memory.get(), disk.get(), H5P_DEFAULT, item.numbers.data());
}

void add_dataset(const Hdf5FileHandle& file, const Hdf5Item& item) {
  constexpr std::uint64_t most_chunk_bytes = 1 << 20;  // written ones; the image holds them
  const Hdf5Type type = type_of(item);
  const Hdf5Space space = space_of(item);
  const Hdf5Properties links(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.get(), 1);
  const Hdf5Properties creation = dataset_properties(item);
  const Hdf5Dataset dataset(
      H5Dcreate2(file.get(), item.path.c_str(), type.get(), space.get(), links.get(), creation.get(), H5P_DEFAULT));
  if (dataset.get() < 0 || !item.stored_in.empty() || item.rows_per_chunk * sizeof(double) > most_chunk_bytes) return;
  if (is_full(item)) {
    H5Dwrite(dataset.get(), memory_type(item, type), H5S_ALL, H5S_ALL, H5P_DEFAULT, Values(item).data(item.type));
  } else if (item.rows_per_chunk > 0 && item.shape.size() == 1 && !item.numbers.empty()) {
    write_first(dataset, space, item);
  }
}

void add_attribute(const Hdf5FileHandle& file, const Hdf5Item& item) {
  const Hdf5Type type = type_of(item);
  const Hdf5Space space = space_of(item);
  const Hdf5Attribute attribute(
      H5Acreate2(file.get(), item.path.c_str() + 1, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  if (attribute.get() < 0 || !is_full(item)) return;
  H5Awrite(attribute.get(), memory_type(item, type), Values(item).data(item.type));
}

void add_link(const Hdf5FileHandle& file, const Hdf5Item& item) {
  const std::size_t colon = std::min(item.target.find(':'), item.target.size());
  const Hdf5Properties links(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.get(), 1);
  H5Lcreate_external(item.target.substr(0, colon).c_str(),
                     item.target.substr(std::min(colon + 1, item.target.size())).c_str(), file.get(), item.path.c_str(),
                     links.get(), H5P_DEFAULT);
}

}  // namespace

std::string hdf5_image(const std::vector<Hdf5Item>& items) {
  constexpr std::size_t increment = 1 << 16;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_fapl_core(access.get(), increment, false);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  const Hdf5FileHandle file(H5Fcreate("/dev/null/made", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
  for (const Hdf5Item& item : items) {
    if (item.kind == Hdf5Item::Kind::external_link) {
      add_link(file, item);
    } else if (item.path.front() == '@') {
      add_attribute(file, item);
    } else {
      add_dataset(file, item);
    }
  }
  H5Fflush(file.get(), H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file.get(), nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  H5Fget_file_image(file.get(), image.data(), image.size());
  return image;
}

}  // namespace repose::fuzz
