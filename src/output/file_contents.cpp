#include "output/file_contents.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "files/file_seal.h"
#include "files/hdf5_reader.h"
#include "output/checkpoint.h"
#include "output/snapshot_reader.h"

namespace repose {
namespace {

using Kind = FileContents::Kind;

Hdf5Reader open(const std::string& bytes, const std::string& file, const char* expected) {
  if (!is_snapshot(bytes)) throw FileError(fmt::format("{}: is no HDF5 file; {} was expected", file, expected));
  check_seal_if_any(bytes, file);
  return Hdf5Reader::of_bytes(bytes, file, "file of repose");
}

Kind kind_of(const Hdf5Reader& file) {
  if (file.has_attribute("repose_checkpoint")) return Kind::checkpoint;
  if (file.has_attribute("state_hash") && file.has_attribute("inserted")) return Kind::snapshot;
  if (file.has_attribute("deck") && file.has("/runs")) return Kind::grid;
  throw FileError(file.name() + ": is neither a snapshot nor a checkpoint nor a grid.h5 of repose");
}

/// Checkpoints name no materials; particles that are held have twins behind those of the deck.
void count_materials(const Hdf5Reader& file, const std::vector<std::string>& names, FileContents& contents) {
  for (const std::string& name : names) contents.materials.push_back({name, 0});
  for (const std::int32_t material : file.read_rows<std::int32_t>("/particles/material", 1)) {
    const auto m = static_cast<std::size_t>(material);
    if (material < 0 || (!names.empty() && m >= names.size())) {
      throw FileError(fmt::format("{}: material {} has no name", file.name(), material));
    }
    while (m >= contents.materials.size()) contents.materials.push_back({std::to_string(contents.materials.size()), 0});
    ++contents.materials[m].count;
  }
}

void read_state(const Hdf5Reader& file, FileContents& contents) {
  contents.step = file.read_integer("step");
  contents.time_s = file.read_real("time_s");
  contents.state_hash = file.read_text("state_hash");
  contents.particles = file.rows("/particles/id");
  const std::vector<double> radius = file.read_rows<double>("/particles/radius", 1);
  if (std::ssize(radius) != contents.particles) {
    throw FileError(file.name() + ": the arrays of /particles differ in length");
  }
  if (!radius.empty()) {
    const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
    contents.radii = {*least, *most};
  }
  const bool is_snapshot = contents.kind == Kind::snapshot;
  count_materials(file, is_snapshot ? file.read_texts("materials") : std::vector<std::string>(), contents);
  if (is_snapshot) {
    contents.inserted = file.read_integer("inserted");
    contents.left = file.read_integer("left");
  }
}

/// How often each of the names is in a data set of texts; another one is `wrong`.
std::vector<FileContents::Count> counted(const Hdf5Reader& file, const char* path,
                                         const std::vector<std::string>& names, const char* wrong) {
  std::vector<FileContents::Count> counts;
  for (const std::string& name : names) counts.push_back({name, 0});
  for (const std::string& text : file.read_text_rows(path)) {
    const auto found =
        std::find_if(counts.begin(), counts.end(), [&](const FileContents::Count& c) { return c.name == text; });
    if (found == counts.end()) throw FileError(fmt::format("{}: \"{}\" is no {}", file.name(), text, wrong));
    ++found->count;
  }
  return counts;
}

void read_grid(const Hdf5Reader& file, FileContents& contents) {
  contents.columns = file.read_texts("names", "/runs/parameters");
  if (file.has("/runs/figures")) contents.figures = file.read_texts("names", "/runs/figures");
  contents.states = counted(file, "/runs/state", {"waiting", "running", "done", "plugged", "failed"}, "state of a run");
  if (file.has("/runs/experiment")) {
    contents.experiments =
        counted(file, "/runs/experiment", file.read_texts("names", "/runs/experiment"), "experiment");
  }
  if (file.has("/runs/level")) {
    contents.levels = counted(file, "/runs/level", file.read_texts("names", "/runs/level"), "level of the model");
  }
}

}  // namespace

FileContents file_contents(const std::string& bytes, const std::string& file) {
  const Hdf5Reader reader = open(bytes, file, "a snapshot, a checkpoint or a grid.h5");
  FileContents contents;
  contents.kind = kind_of(reader);
  contents.deck = reader.read_text("deck");
  contents.version = reader.read_text("build_version");
  contents.commit = reader.read_text("build_commit");
  contents.compiler = reader.read_text("build_compiler");
  if (contents.kind == Kind::grid) {
    read_grid(reader, contents);
  } else {
    read_state(reader, contents);
  }
  return contents;
}

SnapshotParticles snapshot_particles(const std::string& bytes, const std::string& file) {
  const Hdf5Reader reader = open(bytes, file, "a snapshot");
  if (kind_of(reader) != Kind::snapshot) {
    throw FileError(file + ": is no snapshot; the snapshots of a run are called run_<step>.hdf");
  }
  SnapshotParticles found;
  found.materials = reader.read_texts("materials");
  std::vector<MaterialDeck> materials;
  for (const std::string& name : found.materials) materials.push_back({.name = name});
  try {
    found.particles = parse_snapshot(bytes, file, materials);
  } catch (const DeckError& error) {  // no particles: no deck is to blame here
    throw FileError(error.what());
  }
  found.particles.id = reader.read_rows<std::int64_t>("/particles/id", 1);
  found.mass = reader.read_rows<double>("/particles/mass", 1);
  found.step = reader.read_integer("step");
  found.time_s = reader.read_real("time_s");
  if (reader.has_attribute("deck")) found.deck = reader.read_text("deck");
  if (found.particles.id.size() != found.particles.size() || found.mass.size() != found.particles.size()) {
    throw FileError(file + ": the arrays of /particles differ in length");
  }
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(found.mass.begin(), found.mass.end(), is_finite) || !is_finite(found.time_s)) {
    throw FileError(file + ": has a mass or a time that is not finite");
  }
  return found;
}

}  // namespace repose
