#include "output/checkpoint.h"

#include <array>
#include <vector>

#include <fmt/core.h>

#include "files/hdf5_file.h"
#include "output/vector_rows.h"

namespace repose {
namespace {

constexpr int no_deflate = 0;

/// Appends the components of a vector, or one number.
void append(std::vector<double>& to, const Vec3& v) { append_vector(to, v); }
void append(std::vector<double>& to, const ContactHistory& h) {
  append(to, h.spring);
  append(to, h.rolling);
}
void append(std::vector<std::int64_t>& to, const std::int64_t (&sum)[4]) { to.insert(to.end(), sum, sum + 3); }
template <class T>
void append(std::vector<T>& to, T value) {
  to.push_back(value);
}

class Writer {
 public:
  Writer(const Communicator& comm, Hdf5File& file) : comm_(comm), file_(file) {}

  /// One dataset of `columns` values of each of the rows.
  template <class T, class Row, class Get>
  void write(const std::string& dataset, int columns, const std::vector<Row>& rows, Get&& get) {
    std::vector<T> values;
    values.reserve(rows.size() * static_cast<std::size_t>(columns));
    for (const Row& row : rows) append(values, get(row));
    const std::int64_t count = std::ssize(rows);
    file_.write_rows(dataset, std::span<const T>(values), {comm_.sum(count), comm_.exclusive_sum(count), count},
                     columns);
  }

 private:
  const Communicator& comm_;
  Hdf5File& file_;
};

void write_header(Hdf5File& file, const CheckpointHeader& header) {
  file.write_attribute("/", "repose_checkpoint", checkpoint_format);
  file.write_attribute("/", "step", header.step);
  file.write_attribute("/", "time_s", header.time_s);
  file.write_attribute("/", "state_hash", header.state_hash);
  file.write_attribute("/", "deck", header.deck);
  for (const auto& [name, text] : build_fields(header.build)) file.write_attribute("/", "build_" + name, text);
}

void write_particles(Writer& writer, const Particles& p, const ContactMemory& memory,
                     const std::vector<std::size_t>& kept) {
  using I = std::size_t;
  writer.write<std::int64_t>("/particles/id", 1, kept, [&](I i) { return p.id[i]; });
  writer.write<std::int32_t>("/particles/material", 1, kept, [&](I i) { return p.material[i]; });
  writer.write<double>("/particles/position", 3, kept, [&](I i) { return p.record[i].position; });
  writer.write<double>("/particles/velocity", 3, kept, [&](I i) { return p.record[i].velocity; });
  writer.write<double>("/particles/spin", 3, kept, [&](I i) { return p.record[i].spin; });
  writer.write<double>("/particles/radius", 1, kept, [&](I i) { return p.record[i].radius; });
  writer.write<std::int64_t>(
      "/particles/force_sum", 3, kept, [&](I i) -> const auto& { return p.sum[i].force; });
  writer.write<std::int64_t>(
      "/particles/torque_sum", 3, kept, [&](I i) -> const auto& { return p.sum[i].torque; });
  if (p.has_heat) writer.write<std::int64_t>("/particles/heat", 1, kept, [&](I i) { return p.heat[i]; });
  writer.write<std::int64_t>("/particles/pair_contacts", 1, kept, [&](I i) { return std::ssize(memory.pairs.row(i)); });
  writer.write<std::int64_t>("/particles/wall_contacts", 1, kept, [&](I i) { return std::ssize(memory.walls.row(i)); });
}

template <class T>
std::vector<T> items_of(const Csr<T>& csr, const std::vector<std::size_t>& kept) {
  std::vector<T> items;
  items.reserve(csr.items.size());
  for (const std::size_t i : kept) items.insert(items.end(), csr.row(i).begin(), csr.row(i).end());
  return items;
}

/// Bytes of a whole file with `particles` rows and so many contacts, generously.
std::int64_t most_bytes(std::int64_t particles, std::int64_t pairs, std::int64_t walls, std::size_t text) {
  constexpr std::int64_t of_particle = 8 + 4 + 10 * 8 + 6 * 8 + 2 * 8 + 8;
  constexpr std::int64_t of_history = 6 * 8 + 8;
  constexpr std::int64_t of_hdf5 = 1 << 16;
  return of_hdf5 + particles * of_particle + (pairs + walls) * of_history + static_cast<std::int64_t>(text);
}

}  // namespace

void write_checkpoint(const Communicator& comm, const std::string& path, const CheckpointHeader& header,
                      const Particles& particles, const ContactMemory& memory) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (!is_parked(particles.record[i])) kept.push_back(i);
  }
  const std::vector<PairMemory> pairs = items_of(memory.pairs, kept);
  const std::vector<WallMemory> walls = items_of(memory.walls, kept);
  const std::vector<char> state(header.state.begin(), comm.is_root() ? header.state.end() : header.state.begin());

  Hdf5File file(comm, path,
                most_bytes(comm.sum(std::ssize(kept)), comm.sum(std::ssize(pairs)), comm.sum(std::ssize(walls)),
                           header.deck.size() + header.state.size()),
                no_deflate);
  write_header(file, header);
  Writer writer(comm, file);
  writer.write<std::uint8_t>("/state", 1, state, [](char c) { return static_cast<std::uint8_t>(c); });
  file.create_group("/particles");
  write_particles(writer, particles, memory, kept);
  file.create_group("/pair_contacts");
  writer.write<std::int64_t>("/pair_contacts/partner", 1, pairs, [](const PairMemory& m) { return m.partner; });
  writer.write<double>("/pair_contacts/history", 6, pairs, [](const PairMemory& m) { return m.history; });
  file.create_group("/wall_contacts");
  writer.write<std::int32_t>("/wall_contacts/wall", 1, walls, [](const WallMemory& m) { return m.wall; });
  writer.write<std::int32_t>("/wall_contacts/feature", 1, walls, [](const WallMemory& m) { return m.feature; });
  writer.write<double>("/wall_contacts/history", 6, walls, [](const WallMemory& m) { return m.history; });
  file.close();
}

}  // namespace repose
