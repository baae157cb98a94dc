#include "domain/migration.h"

#include <utility>

#include "comm/buffer.h"
#include "domain/layer_order.h"

namespace repose {
namespace {

/// What travels of a particle, followed by its contact memories.
struct Passport {
  ParticleRecord record;
  std::int64_t id;
  std::int64_t pair_contacts;
  std::int64_t wall_contacts;
  std::int64_t heat;  ///< 0 without [heat]
  std::int32_t material;
};

/// The particles a rank owns after migration, before they are sorted.
struct Arrivals {
  std::vector<ParticleRecord> record;
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> material;
  std::vector<std::int64_t> heat;
  std::vector<std::size_t> stayed;  ///< the first of them: where their contact memories are
  ContactMemory memory;             ///< of the rest
};

void pack(const Particles& particles, const ContactMemory& memory, std::size_t i, std::vector<char>& bytes) {
  PackBuffer buffer(bytes);
  const auto pairs = memory.pairs.row(i);
  const auto walls = memory.walls.row(i);
  buffer.put(Passport{particles.record[i], particles.id[i], static_cast<std::int64_t>(pairs.size()),
                      static_cast<std::int64_t>(walls.size()), particles.has_heat ? particles.heat[i] : 0,
                      particles.material[i]});
  buffer.put_all(pairs);
  buffer.put_all(walls);
}

void unpack(const std::vector<char>& bytes, Arrivals& arrivals) {
  for (UnpackBuffer buffer(bytes); !buffer.at_end();) {
    const auto passport = buffer.get<Passport>();
    arrivals.record.push_back(passport.record);
    arrivals.id.push_back(passport.id);
    arrivals.material.push_back(passport.material);
    arrivals.heat.push_back(passport.heat);
    const auto pairs = buffer.get_vector<PairMemory>(static_cast<std::size_t>(passport.pair_contacts));
    const auto walls = buffer.get_vector<WallMemory>(static_cast<std::size_t>(passport.wall_contacts));
    arrivals.memory.pairs.append_row(pairs);
    arrivals.memory.walls.append_row(walls);
  }
}

/// The rows of all arrivals in a new order.
template <class T>
Csr<T> gather_rows(const Arrivals& arrivals, const Csr<T>& of_stayed, const Csr<T>& of_rest,
                   std::span<const std::size_t> order) {
  const auto row = [&](std::size_t i) {
    const std::size_t stayed = arrivals.stayed.size();
    return i < stayed ? of_stayed.row(arrivals.stayed[i]) : of_rest.row(i - stayed);
  };
  std::size_t items = 0;
  for (const std::size_t i : order) items += row(i).size();
  Csr<T> result;
  result.offset.reserve(order.size() + 1);
  result.items.reserve(items);
  for (const std::size_t i : order) result.append_row(row(i));
  return result;
}

void sort_into(const Arrivals& arrivals, Particles& particles, ContactMemory& memory) {
  const std::vector<std::size_t> order = layer_order(arrivals.record, arrivals.id);
  particles.owned = order.size();
  particles.record.clear();
  particles.id.clear();
  particles.material.clear();
  particles.heat.clear();
  for (const std::size_t i : order) {
    particles.record.push_back(arrivals.record[i]);
    particles.id.push_back(arrivals.id[i]);
    particles.material.push_back(arrivals.material[i]);
    if (particles.has_heat) particles.heat.push_back(arrivals.heat[i]);
  }
  memory.pairs = gather_rows(arrivals, memory.pairs, arrivals.memory.pairs, order);
  memory.walls = gather_rows(arrivals, memory.walls, arrivals.memory.walls, order);
}

}  // namespace

void migrate(const Communicator& comm, const Decomposition& decomposition, Particles& particles,
             ContactMemory& memory) {
  std::vector<std::vector<char>> leaving(static_cast<std::size_t>(comm.size()));
  Arrivals arrivals;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) continue;
    const int owner = decomposition.owner(particles.record[i].position);
    if (owner == comm.rank()) {
      arrivals.record.push_back(particles.record[i]);
      arrivals.id.push_back(particles.id[i]);
      arrivals.material.push_back(particles.material[i]);
      arrivals.heat.push_back(particles.has_heat ? particles.heat[i] : 0);
      arrivals.stayed.push_back(i);
    } else {
      pack(particles, memory, i, leaving[static_cast<std::size_t>(owner)]);
    }
  }
  for (const std::vector<char>& bytes : comm.exchange(leaving)) unpack(bytes, arrivals);
  sort_into(arrivals, particles, memory);
}

}  // namespace repose
