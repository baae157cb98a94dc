#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "contact/pair_loop.h"
#include "contact/wall_contacts.h"
#include "deck/deck.h"
#include "domain/decomposition.h"
#include "domain/exits.h"
#include "domain/ghost_exchange.h"
#include "heat/heat_transfer.h"
#include "integration/time_step.h"
#include "neighbours/list_horizon.h"
#include "neighbours/pair_lists.h"
#include "neighbours/partner_search.h"
#include "neighbours/skin_watch.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/mass_unit.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"
#include "scene/walls/wall.h"
#include "simulation/guards.h"
#include "simulation/moving_scene.h"
#include "simulation/pouring.h"
#include "simulation/rank_load.h"
#include "simulation/stage_clock.h"

namespace repose {

/// How the lists and the decomposition have fared, on this rank unless stated otherwise.
struct RunCounters {
  std::int64_t rebuilds = 0;          ///< of the outer lists
  std::int64_t outer_renewals = 0;    ///< outer skins of this rank that began anew alone, since the set-up
  std::int64_t inner_selections = 0;  ///< of the inner lists alone, for all particles of this rank
  std::int64_t bisections = 0;        ///< new decompositions
  double imbalance = 1.0;             ///< cost of the busiest rank over the mean, at the last rebuild
  std::int64_t peak_ghosts = 0;       ///< most ghosts at a time

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("rebuilds", self.rebuilds);
    v("inner_selections", self.inner_selections);
    v("bisections", self.bisections);
  }
};

/// One DEM simulation on the ranks of a communicator: state and time loop. It opens no file; phases, measurements and
/// output are led from outside (run.h). Several can live in one process.
class Simulation {
 public:
  /// Collective. Sets up the scene of a checked deck and evaluates the initial forces (without advancing histories).
  /// DeckError when particles do not fit or the time step is too long.
  Simulation(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level);

  /// Collective. The next `steps` time steps (at least one); several in one call are a little faster. GuardError on all
  /// ranks when a guard of an earlier step was hit.
  void advance(std::int64_t steps);
  void step() { advance(1); }

  /// Collective. GuardError on all ranks when a guard was hit in the steps so far, or when a particle is unfit now
  /// (find_unfit): call before the state is used.
  void check_guards() const;

  /// Adds or removes a named wall from the next evaluation of the forces on. Contacts with a removed wall are
  /// forgotten.
  void set_wall_present(const std::string& name, bool present);
  /// Starts the motions, the tilt, the growth and the boxes of heat that belong to a phase, and stops the others.
  void begin_phase(const std::string& name);
  /// Gives the particles in the boxes of the phase their temperatures.
  void warm();

  /// What the contacts of the owned particles remember.
  ContactMemory contact_memory() const { return {pairs_.memory(particles_), wall_contacts_.memory(particles_.owned)}; }
  /// What is the same on all ranks; particles, contacts and what has left are not in it.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("steps", self.steps_);
    v("scene", self.scene_);
    v("pouring", self.pouring_);
    v("counters", self.counters_);
    v("warned_of_time_step", self.warned_of_time_step_);
    v("moves", self.moves_);
    if (self.heat_) v("heat", *self.heat_);
  }
  /// Collective. Once describe_state has been read, replaces everything else by what the ranks bring of another
  /// simulation of the same deck: particles with their force sums, by any rank, what their contacts remember, what had
  /// left all ranks, and where their heat had come from. The next steps give the same bits as those of the other
  /// simulation.
  void restore(Particles particles, ContactMemory memory, const ExitCount& left, const HeatLedger& heat = {});

  const Communicator& comm() const { return comm_; }
  const Deck& deck() const { return deck_; }
  const Particles& particles() const { return particles_; }
  const MaterialTable& materials() const { return materials_; }
  const MovingScene& scene() const { return scene_; }
  VectorLevel vector_level() const { return level_; }
  const MassUnit& mass_unit() const { return mass_unit_; }
  const PairLists& pairs() const { return pairs_; }
  const WallContacts& wall_contacts() const { return wall_contacts_; }
  const std::vector<Wall>& walls() const { return scene_.walls(); }
  const TimeStep& time_step() const { return time_step_; }
  const RunCounters& counters() const { return counters_; }
  const ExitCount& left_here() const { return left_; }  ///< on this rank
  /// Null without [heat].
  const HeatTransfer* heat() const { return heat_ ? &*heat_ : nullptr; }
  const SkinWatch& skins() const { return watch_; }
  /// Where this rank's time has gone since the set-up; what happens between two calls of advance is Stage::output.
  const StageClock& clock() const { return clock_; }
  const RankLoad& load() const { return load_; }
  /// Bytes this rank holds for its particles, ghosts, neighbour lists and contact histories.
  std::size_t memory_bytes() const;
  /// Particles that have entered so far, those of the start and those poured; planned() counts all that ever will.
  std::int64_t inserted() const { return inserted_at_start_ + pouring_.entered(); }
  std::int64_t planned() const { return planned_; }
  /// Whether particles are being poured, or none has come yet though some will: a phase must not take this for rest.
  bool awaits_particles() const;
  const std::vector<SizeReport>& sizes() const { return sizes_; }  ///< of the blocks with [particles.sizes]
  std::int64_t steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * time_step_.step; }
  /// A warning for the user that came up since the last call, on all ranks alike.
  std::optional<std::string> take_warning();

 private:
  void insert(const NewParticles& all);
  bool pour();
  void grow();
  void admit(ContactMemory& memory);
  void rebuild_lists();
  void rebuild_lists(ContactMemory memory);
  void balance();
  void choose_horizons();
  void check_time_step();
  GuardView guard_view(std::int64_t step) const;
  void count_leavers();
  void ignore_held(std::vector<IndexPair>& near, std::vector<double>& reach) const;
  std::span<const std::int32_t> find_moved(std::size_t moved);
  bool agree_on_rebuild(std::span<const std::int32_t> moved);
  bool can_renew_outer_skins(std::span<const std::int32_t> moved);
  void renew_outer_skins();
  void renew_inner_lists(std::span<const std::int32_t> moved);
  void renew_skins(std::span<const std::int32_t> moved);
  void select_near();
  void move(std::int64_t k, double dt);
  std::int64_t stand_still(std::int64_t most);
  void advance_heat();
  void control_servos();
  void warn(const std::string& what);
  void evaluate_forces(double dt);
  bool evaluate_group(PairGroup& group, double dt);

  const Communicator& comm_;
  Deck deck_;
  VectorLevel level_;
  MaterialTable materials_;
  MovingScene scene_;
  TimeStep time_step_;
  DomainDeck open_domain_;  ///< as Periodicity::open_bounds
  Particles particles_;
  std::int64_t inserted_at_start_ = 0;
  std::int64_t planned_ = 0;
  std::vector<SizeReport> sizes_;
  Pouring pouring_;
  NewParticles entering_;  ///< poured at this step, until the rebuild admits them
  MassUnit mass_unit_{1.0};
  ExitCount left_;
  std::size_t parked_ = 0;  ///< of the owned particles, until the next rebuild drops them
  Decomposition decomposition_;
  GhostExchange ghosts_;
  bool ghosts_on_their_way_ = false;
  std::int64_t outer_listed_at_ = 0;  ///< step
  std::size_t outer_listed_ = 0;      ///< pairs then
  std::int64_t inner_selected_at_ = 0;
  std::size_t renewed_skins_ = 0;  ///< inner ones since then
  SkinWatch watch_{{}, {}};
  std::vector<std::int32_t> moved_;     ///< particles whose inner skins are used up, with room for all
  std::vector<std::int32_t> at_large_;  ///< those of them whose outer skins are, too
  PartnerSearch partner_search_;
  ListHorizon list_horizon_;
  PairLists pairs_;
  WallContacts wall_contacts_;
  std::optional<HeatTransfer> heat_;
  bool moves_ = true;  ///< false: heat alone goes on
  GrowthDeck growth_;  ///< of the phase
  std::int64_t steps_ = 0;
  StageClock clock_;
  RankLoad load_;
  RunCounters counters_;
  double checked_speed_ = 0.0;         ///< m/s, the greatest that the criteria of the time step have seen here
  double safe_step_ = 0.0;             ///< m: who moves by less along each axis has not moved by longest_way
  double slow_step_ = 0.0;             ///< m: nor is it too fast for the time step
  std::vector<std::int32_t> crowded_;  ///< particles whose force sums could come to be full
  std::optional<Alarm> alarm_;         ///< the first guard hit on this rank
  bool warned_of_time_step_ = false;
  std::optional<std::string> warning_;
};

}  // namespace repose
