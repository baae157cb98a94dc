#include "output/snapshot_reader.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "base/error.h"
#include "files/file_seal.h"
#include "files/hdf5_reader.h"
#include "output/vector_rows.h"

namespace repose {
namespace {

/// The index in the deck of each material of the snapshot; -1: the deck does not have it.
std::vector<int> translation(const std::vector<std::string>& names, const std::vector<MaterialDeck>& materials) {
  std::vector<int> indices;
  for (const std::string& name : names) {
    const auto found = std::find_if(materials.begin(), materials.end(), [&](const auto& m) { return m.name == name; });
    indices.push_back(found == materials.end() ? -1 : static_cast<int>(found - materials.begin()));
  }
  return indices;
}

void check_numbers(const NewParticles& particles, const std::string& file) {
  const auto is_finite = [](const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double radius = particles.radius[i];
    if (!is_finite(particles.position[i]) || !is_finite(particles.velocity[i]) || !is_finite(particles.spin[i]))
      throw FileError(fmt::format("{}: row {} of /particles has a number that is not finite", file, i));
    if (!(radius > 0.0) || !std::isfinite(radius))
      throw FileError(fmt::format("{}: row {} of /particles/radius is {}; a radius is positive", file, i, radius));
    if (!particles.temperature.empty() && !(particles.temperature[i] > 0.0 && particles.temperature[i] <= 1e4))
      throw FileError(fmt::format("{}: row {} of /particles/temperature is {}; it must be above 0 and at most 10000 K",
                                  file, i, particles.temperature[i]));
  }
}

std::vector<Vec3> vectors(std::span<const double> values) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < values.size() / 3; ++i) result.push_back(vector_at(values, i));
  return result;
}

Hdf5Reader open(const std::string& bytes, const std::string& file) {
  check_seal_if_any(bytes, file);
  Hdf5Reader snapshot = Hdf5Reader::of_bytes(bytes, file, "snapshot");
  if (!snapshot.has_attribute("repose_checkpoint")) return snapshot;
  throw FileError(file + ": is a checkpoint, no snapshot; the snapshots of a run are called run_<step>.hdf");
}

}  // namespace

bool is_snapshot(const std::string& bytes) {
  constexpr std::string_view hdf5 = "\x89HDF\r\n\x1a\n";
  return bytes.starts_with(hdf5) || (bytes.size() > seal_bytes && bytes.compare(seal_bytes, hdf5.size(), hdf5) == 0);
}

std::int64_t left_before_snapshot(const std::string& bytes, const std::string& file) {
  return open(bytes, file).read_integer("left");
}

NewParticles parse_snapshot(const std::string& bytes, const std::string& file,
                            const std::vector<MaterialDeck>& materials) {
  const Hdf5Reader snapshot = open(bytes, file);
  NewParticles particles;
  particles.position = vectors(snapshot.read_rows<double>("/particles/position", 3));
  particles.velocity = vectors(snapshot.read_rows<double>("/particles/velocity", 3));
  particles.spin = vectors(snapshot.read_rows<double>("/particles/angular_velocity", 3));
  particles.radius = snapshot.read_rows<double>("/particles/radius", 1);
  if (snapshot.has("/particles/temperature"))
    particles.temperature = snapshot.read_rows<double>("/particles/temperature", 1);
  const std::size_t count = particles.size();
  const std::vector<std::string> names = snapshot.read_texts("materials");
  const std::vector<int> indices = translation(names, materials);
  for (const std::int32_t material : snapshot.read_rows<std::int32_t>("/particles/material", 1)) {
    const auto m = static_cast<std::size_t>(material);
    if (m >= indices.size()) throw FileError(fmt::format("{}: material {} has no name", file, material));
    if (indices[m] < 0)
      throw DeckError(fmt::format("{}: no material is named \"{}\"; add it to the deck", file, names[m]));
    particles.material.push_back(indices[m]);
  }
  if (particles.velocity.size() != count || particles.spin.size() != count || particles.radius.size() != count ||
      particles.material.size() != count || (!particles.temperature.empty() && particles.temperature.size() != count)) {
    throw FileError(fmt::format("{}: the arrays of /particles differ in length", file));
  }
  if (count == 0) throw DeckError(fmt::format("{}: the snapshot holds no particles", file));
  check_numbers(particles, file);
  return particles;
}

}  // namespace repose
