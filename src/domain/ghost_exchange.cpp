#include "domain/ghost_exchange.h"

#include <algorithm>
#include <utility>

#include "comm/buffer.h"

namespace repose {
namespace {

/// All that another rank needs to know of a ghost.
struct GhostPassport {
  ParticleRecord record;
  std::int64_t id;
  double reach;
  std::int32_t material;
};

constexpr int tag = 2;

}  // namespace

std::vector<double> GhostExchange::set_up(const Decomposition& decomposition, const SkinRule& rule,
                                          Particles& particles) {
  free_requests();
  sends_.clear();
  receives_.clear();
  send_index_.clear();

  std::vector<double> reach(particles.owned);
  double longest = 0.0;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    reach[i] = reach_of(particles.record[i], rule);
    longest = std::max(longest, reach[i]);
  }
  const std::vector<double> longest_of = comm_.all_gather(longest);
  const double longest_of_all = *std::max_element(longest_of.begin(), longest_of.end());

  std::vector<std::vector<std::size_t>> ghosts_of(static_cast<std::size_t>(comm_.size()));
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const Vec3& position = particles.record[i].position;
    decomposition.for_each_rank_near(position, reach[i] + longest_of_all, [&](int rank, double squared_distance) {
      const auto r = static_cast<std::size_t>(rank);
      const double limit = reach[i] + longest_of[r];
      if (rank != comm_.rank() && longest_of[r] > 0.0 && squared_distance < limit * limit) ghosts_of[r].push_back(i);
    });
  }

  std::vector<std::vector<char>> bytes(ghosts_of.size());
  for (std::size_t r = 0; r < ghosts_of.size(); ++r) {
    if (ghosts_of[r].empty()) continue;
    sends_.push_back({static_cast<int>(r), send_index_.size(), ghosts_of[r].size()});
    send_index_.insert(send_index_.end(), ghosts_of[r].begin(), ghosts_of[r].end());
    PackBuffer buffer(bytes[r]);
    for (const std::size_t i : ghosts_of[r]) {
      buffer.put(GhostPassport{particles.record[i], particles.id[i], reach[i], particles.material[i]});
    }
  }
  const std::vector<std::vector<char>> received = comm_.exchange(bytes);
  for (std::size_t r = 0; r < received.size(); ++r) {
    const std::size_t begin = particles.ghosts();
    for (UnpackBuffer buffer(received[r]); !buffer.at_end();) {
      const auto ghost = buffer.get<GhostPassport>();
      particles.record.push_back(ghost.record);
      particles.id.push_back(ghost.id);
      particles.material.push_back(ghost.material);
      reach.push_back(ghost.reach);
    }
    if (particles.ghosts() > begin) receives_.push_back({static_cast<int>(r), begin, particles.ghosts() - begin});
  }
  open_requests();
  return reach;
}

void GhostExchange::keep(const std::vector<bool>& needed, Particles& particles) {
  free_requests();
  std::vector<std::vector<char>> kept(static_cast<std::size_t>(comm_.size()));
  std::size_t next = particles.owned;
  for (Link& link : receives_) {
    const std::size_t begin = next - particles.owned;
    PackBuffer buffer(kept[static_cast<std::size_t>(link.rank)]);
    for (std::size_t k = 0; k < link.count; ++k) {
      if (!needed[link.begin + k]) continue;
      const std::size_t old = particles.owned + link.begin + k;
      buffer.put(static_cast<std::int32_t>(k));
      particles.record[next] = particles.record[old];
      particles.id[next] = particles.id[old];
      particles.material[next] = particles.material[old];
      ++next;
    }
    link.begin = begin;
    link.count = next - particles.owned - begin;
  }
  particles.record.resize(next);
  particles.id.resize(next);
  particles.material.resize(next);
  std::erase_if(receives_, [](const Link& link) { return link.count == 0; });
  keep_sends(comm_.exchange(kept));
  open_requests();
}

/// `kept`: by rank, which of the particles sent there it wants.
void GhostExchange::keep_sends(const std::vector<std::vector<char>>& kept) {
  std::vector<std::size_t> index;
  for (Link& link : sends_) {
    const std::size_t begin = index.size();
    for (UnpackBuffer buffer(kept[static_cast<std::size_t>(link.rank)]); !buffer.at_end();) {
      index.push_back(send_index_[link.begin + static_cast<std::size_t>(buffer.get<std::int32_t>())]);
    }
    link.begin = begin;
    link.count = index.size() - begin;
  }
  send_index_ = std::move(index);
  std::erase_if(sends_, [](const Link& link) { return link.count == 0; });
}

void GhostExchange::open_requests() {
  send_buffer_.resize(send_index_.size());
  std::size_t ghosts = 0;
  for (const Link& link : receives_) ghosts += link.count;
  receive_buffer_.resize(ghosts);

  constexpr int doubles = sizeof(Motion) / sizeof(double);
  requests_.assign(receives_.size() + sends_.size(), MPI_REQUEST_NULL);
  std::size_t next = 0;
  for (const Link& link : receives_) {
    check_mpi(MPI_Recv_init(&receive_buffer_[link.begin], doubles * static_cast<int>(link.count), MPI_DOUBLE, link.rank,
                            tag, comm_.handle(), &requests_[next++]),
              "MPI_Recv_init");
  }
  for (const Link& link : sends_) {
    check_mpi(MPI_Send_init(&send_buffer_[link.begin], doubles * static_cast<int>(link.count), MPI_DOUBLE, link.rank,
                            tag, comm_.handle(), &requests_[next++]),
              "MPI_Send_init");
  }
}

void GhostExchange::free_requests() {
  for (MPI_Request& request : requests_) MPI_Request_free(&request);
  requests_.clear();
}

void pack_motion(std::span<const ParticleRecord> records, std::span<const std::size_t> index,
                 std::span<Motion> buffer) {
  for (std::size_t k = 0; k < index.size(); ++k) {
    const ParticleRecord& p = records[index[k]];
    buffer[k] = {p.position, p.velocity, p.spin};
  }
}

void GhostExchange::start(const Particles& particles) {
  pack_motion(particles.record, send_index_, send_buffer_);
  if (requests_.empty()) return;
  check_mpi(MPI_Startall(static_cast<int>(requests_.size()), requests_.data()), "MPI_Startall");
}

void GhostExchange::finish(Particles& particles) {
  if (requests_.empty()) return;
  check_mpi(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  for (std::size_t k = 0; k < receive_buffer_.size(); ++k) {
    ParticleRecord& ghost = particles.record[particles.owned + k];
    ghost.position = receive_buffer_[k].position;
    ghost.velocity = receive_buffer_[k].velocity;
    ghost.spin = receive_buffer_[k].spin;
  }
}

}  // namespace repose
