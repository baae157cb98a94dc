#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "comm/buffer.h"
#include "simulation/simulation.h"

namespace repose {
namespace {

struct SumOfParticle {
  Vec3 position;
  std::int64_t id;
  ForceSum sum;
};

std::vector<SumOfParticle> force_sums(const Particles& particles) {
  std::vector<SumOfParticle> sums;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    sums.push_back({particles.record[i].position, particles.id[i], particles.sum[i]});
  }
  return sums;
}

/// Collective. Gives every particle its sum back, wherever both have got to.
void bring_back(const Communicator& comm, const Decomposition& decomposition, const std::vector<SumOfParticle>& sums,
                Particles& particles) {
  std::vector<std::vector<char>> send(static_cast<std::size_t>(comm.size()));
  for (const SumOfParticle& sum : sums) {
    PackBuffer(send[static_cast<std::size_t>(decomposition.owner(sum.position))]).put(sum);
  }
  std::unordered_map<std::int64_t, ForceSum> sum_of;
  for (const std::vector<char>& bytes : comm.exchange(send)) {
    for (UnpackBuffer buffer(bytes); !buffer.at_end();) {
      const auto sum = buffer.get<SumOfParticle>();
      sum_of[sum.id] = sum.sum;
    }
  }
  for (std::size_t i = 0; i < particles.owned; ++i) particles.sum[i] = sum_of.at(particles.id[i]);
}

/// FileError when the state cannot be one of this simulation.
void check_fit(const Simulation& simulation, const Particles& particles, const ContactMemory& memory,
               const ExitCount& left) {
  const auto refuse = [](const char* what) { throw FileError(fmt::format("a checkpoint of another deck: {}", what)); };
  const auto is_among = [](std::int64_t index, std::int64_t count) { return index >= 0 && index < count; };
  const std::size_t exits = simulation.deck().exits.size();
  if (left.named_particles.size() != exits || left.named_mass.size() != exits) refuse("it has other exits");
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (!is_among(particles.id[i], simulation.planned())) refuse("it has other particles");
    if (!is_among(particles.material[i], static_cast<std::int64_t>(simulation.materials().size())))
      refuse("it has other materials");
  }
  if (particles.heat.size() != (simulation.heat() != nullptr ? particles.owned : 0)) refuse("it has other heat");
  for (const WallMemory& contact : memory.walls.items) {
    if (!is_among(contact.wall, std::ssize(simulation.walls()))) refuse("it has other walls");
  }
}

}  // namespace

void Simulation::restore(Particles particles, ContactMemory memory, const ExitCount& left, const HeatLedger& heat) {
  agree_after(comm_, [&] { check_fit(*this, particles, memory, left); });
  scene_.place(time_step_.step);
  particles.periodic = particles_.periodic;
  particles.has_heat = particles_.has_heat;
  particles_ = std::move(particles);
  wrap_positions(particles_);
  const std::vector<SumOfParticle> sums = force_sums(particles_);
  pairs_.clear();
  warning_.reset();                                           // of the set-up
  const RunCounters counters = std::exchange(counters_, {});  // a first rebuild bisects anew
  rebuild_lists(std::move(memory));
  bring_back(comm_, decomposition_, sums, particles_);  // a rebuild drops them: mostly it comes right before the forces
  wall_contacts_.locate(walls(), particles_);
  counters_ = counters;
  counters_.peak_ghosts = static_cast<std::int64_t>(particles_.ghosts());
  if (heat_) heat_->set_ledger(comm_.is_root() ? heat : HeatLedger::none(walls().size()));
  left_ = comm_.is_root() ? left : ExitCount::none(deck_.exits.size());
  clock_ = {};
  load_ = RankLoad(comm_);
}

}  // namespace repose
