#include "output/dump_export.h"

#include <array>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/read_deck.h"
#include "files/csv_file.h"
#include "files/hdf5_image.h"
#include "output/build_info.h"
#include "output/vector_rows.h"

namespace repose {
namespace {

constexpr std::array<double Vec3::*, 3> components = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The domain of the deck in the snapshot.
DomainDeck domain_of(const SnapshotParticles& snapshot) {
  try {
    return read_written_deck(snapshot.deck, "its deck", {}).domain;
  } catch (const DeckError& error) {
    throw FileError(fmt::format("the snapshot does not say its domain: {}", error.what()));
  }
}

/// An element of H5MD: its values at the one step there is.
class Element {
 public:
  Element(Hdf5Image& file, const SnapshotParticles& snapshot, std::string group)
      : file_(file), group_(std::move(group)) {
    file_.create_group(group_);
    const std::array step = {snapshot.step};
    const std::array time = {snapshot.time_s};
    file_.write_array(group_ + "/step", std::span<const std::int64_t>(step), {1});
    file_.write_array(group_ + "/time", std::span<const double>(time), {1});
    file_.write_attribute(group_ + "/time", "unit", std::string("s"));
  }
  void write(const std::vector<Vec3>& vectors, const std::string& unit) {
    std::vector<double> values;
    for (const Vec3& v : vectors) append_vector(values, v);
    write(values, {1, vectors.size(), 3}, unit);
  }
  void write(const std::vector<double>& values, const std::string& unit) { write(values, {1, values.size()}, unit); }

 private:
  void write(std::span<const double> values, const std::vector<std::uint64_t>& shape, const std::string& unit) {
    file_.write_array(group_ + "/value", values, shape);
    file_.write_attribute(group_ + "/value", "unit", unit);
  }

  Hdf5Image& file_;
  std::string group_;
};

void write_head(Hdf5Image& file) {
  const std::array<std::int64_t, 2> version = {1, 1};
  const std::array name = {std::string("repose")};
  const std::array program_version = {build_info("").version};
  file.create_group("/h5md");
  file.write_attribute("/h5md", "version", std::span<const std::int64_t>(version));
  file.create_group("/h5md/author");
  file.write_fixed_texts("/h5md/author", "name", name, {});
  file.create_group("/h5md/creator");
  file.write_fixed_texts("/h5md/creator", "name", name, {});
  file.write_fixed_texts("/h5md/creator", "version", program_version, {});
}

void write_box(Hdf5Image& file, const DomainDeck& domain, const std::string& group) {
  std::vector<std::string> boundary;
  std::vector<double> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    boundary.emplace_back(is_periodic(domain, static_cast<Axis>(k)) ? "periodic" : "none");
    edges.push_back(domain.max.*components.at(k) - domain.min.*components.at(k));
  }
  file.create_group(group);
  file.write_attribute(group, "dimension", std::int64_t{3});
  file.write_fixed_texts(group, "boundary", boundary, {3});
  file.write_array(group + "/edges", std::span<const double>(edges), {3});
  file.write_attribute(group + "/edges", "unit", std::string("m"));
}

}  // namespace

std::string dump_text(const SnapshotParticles& snapshot) {
  const NewParticles& p = snapshot.particles;
  const DomainDeck domain = domain_of(snapshot);
  std::string text =
      fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS", snapshot.step, p.size());
  for (std::size_t k = 0; k < 3; ++k) text += is_periodic(domain, static_cast<Axis>(k)) ? " pp" : " ff";
  text += "\n";
  for (double Vec3::*component : components) {
    text += shortest_text(domain.min.*component) + " " + shortest_text(domain.max.*component) + "\n";
  }
  text += "ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius mass\n";
  for (std::size_t i = 0; i < p.size(); ++i) {
    text += fmt::format("{} {}", p.id[i] + 1, p.material[i] + 1);
    for (const Vec3& v : {p.position[i], p.velocity[i], p.spin[i]}) {
      for (double Vec3::*component : components) text += " " + shortest_text(v.*component);
    }
    text += " " + shortest_text(p.radius[i]) + " " + shortest_text(snapshot.mass[i]) + "\n";
  }
  return text;
}

std::string h5md_bytes(const SnapshotParticles& snapshot) {
  const NewParticles& p = snapshot.particles;
  const std::string group = "/particles/grains";
  Hdf5Image file("h5md");
  write_head(file);
  file.create_group("/particles");
  file.create_group(group);
  write_box(file, domain_of(snapshot), group + "/box");
  Element(file, snapshot, group + "/position").write(p.position, "m");
  Element(file, snapshot, group + "/velocity").write(p.velocity, "m s-1");
  Element(file, snapshot, group + "/angular_velocity").write(p.spin, "s-1");
  if (!p.temperature.empty()) Element(file, snapshot, group + "/temperature").write(p.temperature, "K");
  const std::vector<std::int64_t> species(p.material.begin(), p.material.end());
  file.write_array(group + "/id", std::span<const std::int64_t>(p.id), {p.size()});
  file.write_array(group + "/species", std::span<const std::int64_t>(species), {p.size()});
  file.write_attribute(group + "/species", "names", std::span<const std::string>(snapshot.materials));
  file.write_array(group + "/mass", std::span<const double>(snapshot.mass), {p.size()});
  file.write_attribute(group + "/mass", "unit", std::string("kg"));
  file.write_array(group + "/radius", std::span<const double>(p.radius), {p.size()});
  file.write_attribute(group + "/radius", "unit", std::string("m"));
  return file.bytes();
}

}  // namespace repose
