#include "domain/ghost_exchange.h"

#include <algorithm>
#include <utility>

#include "comm/buffer.h"
#include "scene/particles/periodicity.h"

namespace repose {
namespace {

/// All that another rank needs to know of a ghost.
struct GhostPassport {
  ParticleRecord record;
  std::int64_t id;
  double reach;
  std::int32_t material;
};

/// An owned particle, moved by whole lengths of the domain.
struct Image {
  std::size_t particle;
  Vec3 shift;
};

constexpr int tag = 2;
constexpr int tag_of_values = 3;

/// The room in the memory of a node for where the motion for each of so many ranks begins, in Motions.
std::size_t begins_room(int ranks) {
  return (static_cast<std::size_t>(ranks) * sizeof(std::int64_t) + sizeof(Motion) - 1) / sizeof(Motion);
}

}  // namespace

template <class Visit>
void GhostExchange::for_each_place_near(const Decomposition& decomposition, const Periodicity& periodic,
                                        const Vec3& position, double reach, double growth, Visit&& visit) const {
  const double range = reach + growth * *std::max_element(longest_of_.begin(), longest_of_.end());
  periodic.for_each_shift(position, range, [&](const Vec3& shift) {
    decomposition.for_each_rank_near(position + shift, range, [&](int rank, double squared_distance) {
      const double longest = growth * longest_of_[static_cast<std::size_t>(rank)];
      const double limit = reach + longest;
      if (longest > 0.0 && squared_distance < limit * limit) visit(rank, shift);
    });
  });
}

std::vector<double> GhostExchange::set_up(const Decomposition& decomposition, const SkinRule& rule,
                                          Particles& particles) {
  free_requests();
  sends_.clear();
  receives_.clear();
  send_index_.clear();
  send_shift_.clear();

  std::vector<double> reach(particles.owned);
  double longest = 0.0;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    reach[i] = reach_of(particles.record[i], rule);
    longest = std::max(longest, reach[i]);
  }
  longest_of_ = comm_.all_gather(longest);

  std::vector<std::vector<Image>> ghosts_of(static_cast<std::size_t>(comm_.size()));
  for (std::size_t i = 0; i < particles.owned; ++i) {
    for_each_place_near(decomposition, particles.periodic, particles.record[i].position, reach[i], 1.0,
                        [&](int rank, const Vec3& shift) {
                          if (rank == comm_.rank() && shift == Vec3{}) return;
                          ghosts_of[static_cast<std::size_t>(rank)].push_back({i, shift});
                        });
  }

  std::vector<std::vector<char>> bytes(ghosts_of.size());
  for (std::size_t r = 0; r < ghosts_of.size(); ++r) {
    if (ghosts_of[r].empty()) continue;
    sends_.push_back({static_cast<int>(r), send_index_.size(), ghosts_of[r].size()});
    PackBuffer buffer(bytes[r]);
    for (const auto& [i, shift] : ghosts_of[r]) {
      send_index_.push_back(i);
      GhostPassport ghost{particles.record[i], particles.id[i], reach[i], particles.material[i]};
      if (particles.periodic.any()) {
        send_shift_.push_back(shift);
        ghost.record.position += shift;
      }
      buffer.put(ghost);
    }
  }
  node_.reserve(sizeof(Motion) * (begins_room(comm_.size()) + send_index_.size()));
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
  is_sent_.assign(particles.owned, false);
  for (const std::size_t i : send_index_) is_sent_[i] = true;
}

// Marks, where skins began, keep to the box of their rank: at a set-up all particles do, and a mark that begins alone
// is farther from every other box than its reach and the longest that one there may come to have. So two marks of two
// ranks are farther apart than both reaches when one of them, or both, have begun since.
bool GhostExchange::is_alone(const Decomposition& decomposition, const Particles& particles, std::size_t i,
                             double reach) const {
  if (comm_.size() == 1 && !particles.periodic.any()) return true;
  constexpr double growth = 1.25;  // of the longest reaches
  if (is_sent_[i] || reach > growth * longest_of_[static_cast<std::size_t>(comm_.rank())]) return false;
  bool alone = true;
  for_each_place_near(decomposition, particles.periodic, particles.record[i].position, reach, growth,
                      [&](int rank, const Vec3& shift) { alone &= rank == comm_.rank() && shift == Vec3{}; });
  return alone;
}

/// `kept`: by rank, which of the particles sent there it wants.
void GhostExchange::keep_sends(const std::vector<std::vector<char>>& kept) {
  std::vector<std::size_t> index;
  std::vector<Vec3> shift;
  for (Link& link : sends_) {
    const std::size_t begin = index.size();
    for (UnpackBuffer buffer(kept[static_cast<std::size_t>(link.rank)]); !buffer.at_end();) {
      const std::size_t k = link.begin + static_cast<std::size_t>(buffer.get<std::int32_t>());
      index.push_back(send_index_[k]);
      if (!send_shift_.empty()) shift.push_back(send_shift_[k]);
    }
    link.begin = begin;
    link.count = index.size() - begin;
  }
  send_index_ = std::move(index);
  send_shift_ = std::move(shift);
  std::erase_if(sends_, [](const Link& link) { return link.count == 0; });
}

void GhostExchange::open() {
  std::size_t ghosts = 0;
  for (const Link& link : receives_) ghosts += link.count;
  receive_buffer_.resize(ghosts);
  if (node_.is_open()) {
    auto* begins = reinterpret_cast<std::int64_t*>(node_.mine());
    for (const Link& link : sends_) begins[link.rank] = static_cast<std::int64_t>(link.begin);
    node_.take(exchanges_);
    node_.post(exchanges_);
  } else {
    send_buffer_.resize(send_index_.size());
  }

  constexpr int doubles = sizeof(Motion) / sizeof(double);
  for (const Link& link : receives_) {
    if (!is_remote(link) || is_near(link)) continue;
    check_mpi(MPI_Recv_init(&receive_buffer_[link.begin], doubles * static_cast<int>(link.count), MPI_DOUBLE, link.rank,
                            tag, comm_.handle(), &requests_.emplace_back(MPI_REQUEST_NULL)),
              "MPI_Recv_init");
  }
  messages_ = 0;
  bytes_ = 0;
  for (const Link& link : sends_) {
    if (!is_remote(link)) continue;
    ++messages_;
    bytes_ += static_cast<std::int64_t>(link.count * sizeof(Motion));
    if (is_near(link)) continue;
    check_mpi(MPI_Send_init(&send_buffer()[link.begin], doubles * static_cast<int>(link.count), MPI_DOUBLE, link.rank,
                            tag, comm_.handle(), &requests_.emplace_back(MPI_REQUEST_NULL)),
              "MPI_Send_init");
  }
  is_open_ = true;
}

/// Where the motion is packed that this rank sends.
std::span<Motion> GhostExchange::send_buffer() {
  if (!node_.is_open()) return send_buffer_;
  return {reinterpret_cast<Motion*>(node_.mine()) + begins_room(comm_.size()), send_index_.size()};
}

/// Where the motion of the ghosts of a link stands, once it is there.
std::span<const Motion> GhostExchange::motion_of(const Link& link) const {
  if (!is_near(link)) return std::span(receive_buffer_).subspan(link.begin, link.count);
  const auto* begins = reinterpret_cast<const std::int64_t*>(node_.of(link.rank));
  const auto* motion = reinterpret_cast<const Motion*>(node_.of(link.rank)) + begins_room(comm_.size());
  return {motion + begins[comm_.rank()], link.count};
}

void GhostExchange::free_requests() {
  for (MPI_Request& request : requests_) MPI_Request_free(&request);
  requests_.clear();
  is_open_ = false;
}

void pack_motion(std::span<const ParticleRecord> records, std::span<const std::size_t> index,
                 std::span<const Vec3> shift, std::span<Motion> buffer) {
  for (std::size_t k = 0; k < index.size(); ++k) {
    const ParticleRecord& p = records[index[k]];
    buffer[k] = {p.position, p.velocity, p.spin};
  }
  for (std::size_t k = 0; k < shift.size(); ++k) buffer[k].position += shift[k];
}

template <class T>
void GhostExchange::copy_own_images(std::span<const T> from, std::span<T> to) const {
  const auto own = [&](const Link& link) { return !is_remote(link); };
  const auto sent = std::find_if(sends_.begin(), sends_.end(), own);
  const auto received = std::find_if(receives_.begin(), receives_.end(), own);
  if (sent == sends_.end() || received == receives_.end()) return;
  std::copy_n(&from[sent->begin], sent->count, &to[received->begin]);
}

void GhostExchange::start(const Particles& particles) {
  if (!is_open_) open();
  for (const Link& link : sends_) {
    if (is_near(link)) wait_until([&] { return node_.taken(link.rank) >= exchanges_; });
  }
  pack_motion(particles.record, send_index_, send_shift_, send_buffer());
  copy_own_images<Motion>(send_buffer(), receive_buffer_);
  ++exchanges_;
  if (node_.is_open()) node_.post(exchanges_);
  comm_.count_sent(messages_, bytes_);
  if (requests_.empty()) return;
  check_mpi(MPI_Startall(static_cast<int>(requests_.size()), requests_.data()), "MPI_Startall");
}

bool GhostExchange::have_posted() const {
  return std::all_of(receives_.begin(), receives_.end(),
                     [&](const Link& link) { return !is_near(link) || node_.posted(link.rank) >= exchanges_; });
}

bool GhostExchange::advance() {
  int done = 1;
  if (!requests_.empty()) {
    check_mpi(MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE),
              "MPI_Testall");
  }
  return done != 0 && have_posted();
}

void GhostExchange::finish(Particles& particles) {
  if (!requests_.empty()) {
    check_mpi(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  }
  for (const Link& link : receives_) {
    if (is_near(link)) wait_until([&] { return node_.posted(link.rank) >= exchanges_; });
    ParticleRecord* ghost = &particles.record[particles.owned + link.begin];
    for (const Motion& motion : motion_of(link)) {
      ghost->position = motion.position;
      ghost->velocity = motion.velocity;
      ghost->spin = motion.spin;
      ++ghost;
    }
  }
  if (node_.is_open()) node_.take(exchanges_);
}

void GhostExchange::share(std::size_t owned, std::span<double> values) const {
  std::vector<double> send(send_index_.size());
  for (std::size_t k = 0; k < send.size(); ++k) send[k] = values[send_index_[k]];
  const std::span<double> ghosts = values.subspan(owned);
  std::vector<MPI_Request> requests;
  for (const Link& link : receives_) {
    if (!is_remote(link)) continue;
    check_mpi(MPI_Irecv(&ghosts[link.begin], static_cast<int>(link.count), MPI_DOUBLE, link.rank, tag_of_values,
                        comm_.handle(), &requests.emplace_back(MPI_REQUEST_NULL)),
              "MPI_Irecv");
  }
  for (const Link& link : sends_) {
    if (!is_remote(link)) continue;
    check_mpi(MPI_Isend(&send[link.begin], static_cast<int>(link.count), MPI_DOUBLE, link.rank, tag_of_values,
                        comm_.handle(), &requests.emplace_back(MPI_REQUEST_NULL)),
              "MPI_Isend");
    comm_.count_sent(1, static_cast<std::int64_t>(link.count * sizeof(double)));
  }
  copy_own_images<double>(send, ghosts);
  if (requests.empty()) return;
  check_mpi(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
}

}  // namespace repose
