#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/vector_level.h"
#include "contact/wall_loop.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"
#include "scene/walls/wall.h"

namespace repose {

struct WallAlarms : ContactAlarms {
  std::int64_t too_many = 0;  ///< particles with more touches than a TouchBuffer holds
  bool any() const { return ContactAlarms::any() || too_many > 0; }
};

/// A sphere as walls see it.
struct TouchingSphere {
  Vec3 centre;
  double radius;  ///< m
};

/// Replaces `touches` by those of a sphere with what is nearer than `reach` (m) to its centre of the present ones of
/// the walls that `chosen` names.
inline void find_touches_of(std::span<const Wall> walls, std::span<const std::int32_t> chosen,
                            const TouchingSphere& sphere, double reach, TouchBuffer& touches) {
  touches.clear();
  for (const std::int32_t w : chosen) {
    const Wall& wall = walls[static_cast<std::size_t>(w)];
    if (wall.present) find_touches(wall, w, sphere.centre, reach, touches);
  }
  if (touches.size() < 2) return;
  double tolerance = 1e-9 * sphere.radius;
  for (const std::int32_t w : chosen) tolerance = std::max(tolerance, flatness(walls[static_cast<std::size_t>(w)]));
  resolve_touches(touches, tolerance);
}

/// The contacts of the owned particles with walls.
class WallContacts {
 public:
  /// Lists the walls, present or not, within the reach (m) of each owned particle, and gives the contacts their
  /// histories.
  void build(const Particles& particles, std::span<const Wall> walls, std::span<const double> reach,
             const Csr<WallMemory>& memory);

  /// Lists for owned particle i the walls within this reach as well, which `search` takes up.
  void list_more(const Particles& particles, std::span<const Wall> walls, std::int32_t i, double reach);

  /// Narrows the list to what is within the reaches of `rule`, until select_near is called again: particles that can
  /// touch one face and nothing else go into the lanes of that face, the others are searched at each step.
  void select_near(const Particles& particles, std::span<const Wall> walls, const SkinRule& rule);

  /// Searches the particles `moved` at each step, wherever they go, until select_near is called again.
  void search(std::span<const std::int32_t> moved);

  /// Evaluates the contact law with every present wall and adds force and torque to the particles' sums. Histories
  /// advance by `dt` s. A history follows its contact from one feature of a wall to the next, and across flush seams of
  /// two walls.
  WallAlarms evaluate(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials, double dt,
                      double max_overlap, Particles& particles);

  /// Forgets the contacts with a wall, such as one that is removed: at the next evaluation they are new.
  void forget(std::int32_t wall);

  /// Finds where the contacts of the last evaluation are: a build gives them their histories alone.
  void locate(std::span<const Wall> walls, const Particles& particles);

  /// Calls visit(particle, touch) for what is nearer to the surface of an owned particle than `share` of its radius,
  /// which the reaches of the last build must have covered. False when there was more at a particle than a TouchBuffer
  /// holds; the rest is left out.
  template <class Visit>
  bool for_each_near(std::span<const Wall> walls, const Particles& particles, double share, Visit&& visit) const;
  /// All that touch, in the order of the particles.
  std::vector<WallContact> contacts(std::span<const Wall> walls, const Particles& particles) const;
  /// Those that touch one wall.
  std::vector<WallContact> contacts_with(std::int32_t wall, std::span<const Wall> walls,
                                         const Particles& particles) const;
  /// m, how far apart surfaces that have touched may hold together (SkinRule).
  double adhesion_range() const { return adhesion_range_; }
  std::size_t in_lanes() const;  ///< particles in the lanes of faces
  std::size_t bytes() const {
    return bytes_of(candidates_) + bytes_of(candidate_walls_) + bytes_of(near_) + bytes_of(near_walls_) +
           bytes_of(contacts_) + bytes_of(before_) + bytes_of_faces();
  }
  /// The histories of all contacts that have one, by owned particle.
  Csr<WallMemory> memory(std::size_t owned) const;

 private:
  struct Candidate {
    std::int32_t particle;
    std::int32_t first_wall;  ///< into candidate_walls_ or near_walls_
    std::int32_t walls;
  };
  /// Replaces contacts_ by the touches of this step, with the histories they inherit.
  void find_contacts(std::span<const Wall> walls, const Particles& particles, WallAlarms& alarms);
  FaceGroup& group_for(const Particles& particles, std::size_t particle, const Wall& wall, const WallTouch& touch);
  void add_lane(FaceGroup& group, std::int32_t particle, const ContactHistory& history);
  WallMemory take_lane_of(std::int32_t particle);
  std::size_t bytes_of_faces() const;
  std::vector<WallContact> contacts_if(std::span<const Wall> walls, const Particles& particles,
                                       std::int32_t only) const;
  const WallContact* ancestor(std::span<const WallContact> before, std::span<const Wall> walls,
                              const TouchBuffer& touches, int touch) const;

  double adhesion_range_ = 0.0;  ///< m, as in SkinRule
  std::vector<Candidate> candidates_;
  std::vector<std::int32_t> candidate_walls_;
  std::vector<FaceGroup> faces_;                                 ///< what select_near chose of them
  std::map<std::array<std::int32_t, 3>, std::size_t> group_of_;  ///< of faces_ by material, wall, feature
  std::vector<Candidate> near_;                                  ///< the rest of it
  std::vector<std::int32_t> near_walls_;
  std::vector<WallContact> contacts_;              ///< those of near_, in its order
  std::vector<WallContact> before_;                ///< those of the step before, while evaluate runs
  std::vector<std::vector<std::int32_t>> of_law_;  ///< contacts_ by material of the particle and by wall
};

template <class Visit>
bool WallContacts::for_each_near(std::span<const Wall> walls, const Particles& particles, double share,
                                 Visit&& visit) const {
  bool all_seen = true;
  TouchBuffer touches;
  for (const Candidate& candidate : candidates_) {
    const auto i = static_cast<std::size_t>(candidate.particle);
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    const auto* first = &candidate_walls_[static_cast<std::size_t>(candidate.first_wall)];
    find_touches_of(walls, {first, static_cast<std::size_t>(candidate.walls)}, {particles.position(i), p.radius},
                    p.radius * (1.0 + share), touches);
    all_seen = all_seen && !touches.overflowed();
    for (const WallTouch& touch : touches.touches()) {
      if (touch.superseded_by < 0) visit(i, touch);
    }
  }
  return all_seen;
}

}  // namespace repose
