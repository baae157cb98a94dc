#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector_level.h"
#include "contact/wall_loop.h"
#include "scene/contact_memory.h"
#include "scene/materials.h"
#include "scene/particles.h"
#include "scene/reach.h"
#include "scene/wall.h"

namespace repose {

struct WallAlarms : ContactAlarms {
  std::int64_t too_many = 0;  ///< particles with more touches than a TouchBuffer holds
  bool any() const { return ContactAlarms::any() || too_many > 0; }
};

/// The contacts of the owned particles with walls.
class WallContacts {
 public:
  /// Lists the walls, present or not, within the reach (m) of each owned particle, and gives the contacts their
  /// histories.
  void build(const Particles& particles, std::span<const Wall> walls, std::span<const double> reach,
             const Csr<WallMemory>& memory);

  /// Narrows the list to what is within the reaches of `rule`, until select_near is called again.
  void select_near(const Particles& particles, std::span<const Wall> walls, const SkinRule& rule);

  /// Evaluates the contact law with every present wall and adds force and torque to the particles' sums. Histories
  /// advance by `dt` s. A history follows its contact from one feature of a wall to the next, and across flush seams of
  /// two walls.
  WallAlarms evaluate(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials, double dt,
                      double max_overlap, Particles& particles);

  std::span<const WallContact> contacts() const { return contacts_; }
  std::size_t bytes() const {
    return bytes_of(candidates_) + bytes_of(near_) + bytes_of(candidate_walls_) + bytes_of(contacts_) +
           bytes_of(before_);
  }
  /// The histories of all contacts, by owned particle.
  Csr<WallMemory> memory(std::size_t owned) const;

 private:
  struct Candidate {
    std::int32_t particle;
    std::int32_t first_wall;  ///< into candidate_walls_
    std::int32_t walls;
  };
  /// Replaces contacts_ by the touches of this step, with the histories they inherit.
  void find_contacts(std::span<const Wall> walls, const Particles& particles, WallAlarms& alarms);
  const WallContact* ancestor(std::span<const WallContact> before, std::span<const Wall> walls,
                              const TouchBuffer& touches, int touch) const;

  std::vector<Candidate> candidates_;
  std::vector<Candidate> near_;  ///< those of them that select_near chose
  std::vector<std::int32_t> candidate_walls_;
  std::vector<WallContact> contacts_;                    ///< in the order of the candidates
  std::vector<WallContact> before_;                      ///< those of the step before, while evaluate runs
  std::vector<std::vector<std::int32_t>> of_materials_;  ///< contacts_ by material of the particle and of the wall
};

}  // namespace repose
