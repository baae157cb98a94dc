#pragma once

#include <span>
#include <vector>

#include "comm/communicator.h"
#include "comm/node_memory.h"
#include "domain/decomposition.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

/// What of a ghost travels at each step.
struct Motion {
  Vec3 position, velocity, spin;
};

/// Copies the motion of particles `index` to `buffer`, one each; if `shift` is not empty, moved by it.
void pack_motion(std::span<const ParticleRecord> records, std::span<const std::size_t> index,
                 std::span<const Vec3> shift, std::span<Motion> buffer);

/// The ghosts of a rank: copies of the particles of other ranks, and in periodic directions images of particles of any
/// rank, that may touch its own before the next list rebuild.
/// The lists of who sends what to whom are made at a rebuild; each step only positions, velocities and spins travel, by
/// persistent requests, or to ranks of the same node by memory that they read in place. Ghosts are read only: no force
/// travels back.
class GhostExchange {
 public:
  /// Collective.
  explicit GhostExchange(const Communicator& comm) : comm_(comm), node_(comm) {}
  ~GhostExchange() { free_requests(); }
  GhostExchange(const GhostExchange&) = delete;
  GhostExchange& operator=(const GhostExchange&) = delete;

  /// Collective. All particles are in the domain. Appends to the owned particles the ghosts that are within the sum of
  /// reaches of any of them, and returns the outer reach of every particle, owned and ghost, in m.
  std::vector<double> set_up(const Decomposition& decomposition, const SkinRule& rule, Particles& particles);

  /// Collective. Drops the ghosts that are not `needed` (one entry per ghost), here and from what travels; the others
  /// keep their order. A rank's shell is as thick as its longest reach asks for, but few particles have that reach.
  void keep(const std::vector<bool>& needed, Particles& particles);

  /// Whether nothing of another rank, nor any image, can come within its reach and theirs of owned particle i until the
  /// next set_up, if its skin begins anew where it is now, with this reach (m), and if other ranks ask the same of
  /// theirs.
  bool is_alone(const Decomposition& decomposition, const Particles& particles, std::size_t i, double reach) const;

  /// Sends the motion of the owned particles that are ghosts elsewhere, and starts to receive.
  void start(const Particles& particles);
  /// Gives MPI the processor for a moment: large messages, also those that this rank sends, advance only while it is in
  /// one of MPI's calls. Whether `finish` has nothing to wait for any more.
  bool advance();
  /// Waits for the motion of this rank's ghosts and stores it.
  void finish(Particles& particles);
  /// Collective. `values`: one of every particle, the ghosts behind the owned; gives each ghost that of its original.
  void share(std::size_t owned, std::span<double> values) const;

 private:
  /// The ghosts exchanged with one rank; with its own, the images of its own particles.
  struct Link {
    int rank;
    std::size_t begin;  ///< into send_index_ or, when receiving, into the ghosts
    std::size_t count;
  };
  void keep_sends(const std::vector<std::vector<char>>& kept);
  bool is_remote(const Link& link) const { return link.rank != comm_.rank(); }
  bool is_near(const Link& link) const { return is_remote(link) && node_.is_near(link.rank); }
  void open();
  bool have_posted() const;
  std::span<Motion> send_buffer();
  std::span<const Motion> motion_of(const Link& link) const;
  /// Of what this rank sends to itself to where it receives it.
  template <class T>
  void copy_own_images(std::span<const T> from, std::span<T> to) const;
  void free_requests();

  /// Calls visit(rank, shift) for each rank, this one included, that a particle at `position` with this reach may have
  /// partners on, when the particle is moved by `shift`. The longest reach on a rank may have grown by so much.
  template <class Visit>
  void for_each_place_near(const Decomposition& decomposition, const Periodicity& periodic, const Vec3& position,
                           double reach, double growth, Visit&& visit) const;

  const Communicator& comm_;
  std::vector<double> longest_of_;  ///< m, reach on each rank at the set-up
  std::vector<bool> is_sent_;       ///< of each owned particle
  std::vector<Link> sends_;
  std::vector<Link> receives_;
  std::vector<std::size_t> send_index_;  ///< owned particles to send, link by link
  std::vector<Vec3> send_shift_;         ///< to the image, one each; empty without periodic directions
  std::vector<Motion> send_buffer_;      ///< where no rank is near; else it is in the memory of the node
  std::vector<Motion> receive_buffer_;   ///< one per ghost, in the order of the ghosts; of those that come by messages
  bool is_open_ = false;                 ///< requests and memory are those of the links
  NodeMemory node_;  ///< of each rank where in its send buffer the motion for every rank begins, then that buffer
  std::int64_t exchanges_ = 0;
  std::vector<MPI_Request> requests_;
  std::int64_t messages_ = 0;  ///< sent to other ranks at each step
  std::int64_t bytes_ = 0;     ///< in them
};

}  // namespace repose
