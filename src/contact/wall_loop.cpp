#include "contact/wall_loop.h"

#include <algorithm>
#include <type_traits>

#include "contact/contact_law.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// Where the walls of a block's contacts are, by column.
struct LaneWalls {
  alignas(64) double normal[3][block_lanes], distance[block_lanes];
};

/// A distance in m at which a particle of `radius` m has no contact, also not one that adhesion would hold.
template <class Real>
[[gnu::always_inline]] inline Real untouched(const Real& radius) {
  return 2.0 * radius;
}

/// Lanes without a contact repeat the first particle, at a distance at which it does not touch.
[[gnu::always_inline]] inline void gather_contacts(std::span<const WallContact> contacts,
                                                   std::span<const std::int32_t> chosen, const ParticleRecord* records,
                                                   ContactBlock& block, LaneWalls& walls) {
  const auto used = static_cast<int>(chosen.size());
  for (int k = 0; k < block_lanes; ++k) {
    const WallContact& contact = contacts[static_cast<std::size_t>(chosen[static_cast<std::size_t>(k < used ? k : 0)])];
    block.first[k] = contact.particle;
    walls.normal[0][k] = contact.normal.x;
    walls.normal[1][k] = contact.normal.y;
    walls.normal[2][k] = contact.normal.z;
    walls.distance[k] = k < used ? contact.distance : untouched(records[contact.particle].radius);
    set_history(block, static_cast<std::size_t>(k), contact.history);
  }
}

/// Lanes from `used` on, and parked particles, get a distance at which they do not touch.
template <Lanes Real, bool may_move, class FaceShape>
[[gnu::always_inline]] inline void touch_face(const FaceShape& face_in, const Placement* placement, std::size_t used,
                                              const ParticleRecord* records, const ContactBlock& block,
                                              LaneWalls& walls) {
  const FaceShape face = face_in;
  const auto lanes = static_cast<std::int64_t>(used);
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const LaneParticle<Real> p = gather<Real>(records, block.first + k);
    const bool has_travelled = may_move && placement != nullptr;
    BasicFaceTouch<Real> at = touch(face, has_travelled ? placement->back(p.position) : p.position);
    if (has_travelled) at.normal = placement->turn(at.normal);
    const LaneInt<Real> lane = lane_numbers<Real>() + k;
    const LaneInt<Real> here = (lane < lanes) & (p.position.x < broadcast<Real>(parking_distance));
    store(at.normal, walls.normal, k);
    store(select(here, at.distance, untouched(p.radius)), walls.distance + k);
  }
}

/// Velocity and spin of particles relative to a wall's surface.
template <Lanes Real>
struct SeenFromWall {
  Vector3<Real> velocity;  ///< at the touched point, the particle's spin left out
  Vector3<Real> spin;
};

/// m/s: the speed of `belt` along its projection on the plane of the unit vector `n`; 0 where it is along n.
template <Lanes Real>
[[gnu::always_inline]] inline Vector3<Real> belt_velocity(const Vec3& belt, const Vector3<Real>& n) {
  const Vector3<Real> along = without_normal_part(broadcast<Real>(belt), n);
  const Real length = square_root(squared_norm(along));
  const Real speed = square_root(squared_norm(broadcast<Real>(belt)));
  return select(length > 1e-9 * speed, speed / length, Real{}) * along;
}

template <Lanes Real, bool may_move>
[[gnu::always_inline]] inline SeenFromWall<Real> see_from(const SurfaceMotion* surface, const LaneParticle<Real>& p,
                                                          const Real& distance, const Vector3<Real>& n) {
  if (!may_move || surface == nullptr) return {p.velocity, p.spin};
  const auto turning = broadcast<Real>(surface->angular_velocity);
  const Vector3<Real> touched = p.position - distance * n;
  Vector3<Real> wall_velocity = broadcast<Real>(surface->velocity) + cross(turning, touched);
  if (surface->belt != Vec3{}) wall_velocity += belt_velocity(surface->belt, n);
  return {p.velocity - wall_velocity, p.spin - turning};
}

/// Returns the number of contacts deeper than the bound.
template <class Law, Lanes Real, bool may_move>
[[gnu::always_inline]] inline std::int64_t evaluate_geometry(const WallLaw& law, const ParticleRecord* records,
                                                             const ContactBlock& block, const LaneWalls& walls,
                                                             LaneGeometry& contact, LaneBody& body) {
  const typename Law::Parameters pair = law.pair;
  const double density = pair.density_first;
  const double max_overlap = law.max_overlap;
  LaneInt<Real> deep = {};
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const LaneParticle<Real> p = gather<Real>(records, block.first + k);
    const Real distance = load<Real>(walls.distance + k);
    const Vector3<Real> n = load<Real>(walls.normal, k);
    const SeenFromWall<Real> seen = see_from<Real, may_move>(law.surface, p, distance, n);
    const Real overlap = Law::overlap(pair, p.radius - distance, p.radius, remembers<Real>(block, k));
    const Real arm = p.radius - 0.5 * overlap;
    const Real v_n = dot(seen.velocity, n);
    store(n, contact.normal, k);
    store(overlap, contact.overlap + k);
    store(p.radius, contact.radius_eff + k);
    const Real mass = sphere_mass(p.radius, density);
    store(mass, contact.mass_eff + k);
    store(v_n, contact.normal_velocity + k);
    store(seen.velocity - v_n * n - arm * cross(p.spin, n), contact.tangential_velocity, k);
    // The thesis's program scales the rotation at a wall by the lever arm over the distance.
    store((arm / distance) * without_normal_part(seen.spin, n), contact.rolling_velocity, k);
    if constexpr (Law::has_options) {
      store(n, contact.velocity_normal, k);  // of a flat wall that does not turn, the same at all times
      store((arm / distance) * dot(seen.spin, n), contact.twist + k);
      store(1.4 * (mass * (p.radius * p.radius)), contact.rolling_inertia + k);
      store(cohesive_area_at_wall(pair, p.radius, distance, overlap), contact.cohesive_area + k);
    }
    store(arm, body.arm + k);
    body.set_scales(k, p);
    deep += overlap > max_overlap * p.radius;
  }
  return count(deep);
}

template <class Law, Lanes Real, bool may_move>
[[gnu::always_inline]] inline void evaluate_block(const WallLaw& law, const LaneWalls& walls,
                                                  const ParticleRecord* records, ContactBlock& block, ForceSum* sums,
                                                  ContactAlarms& alarms) {
  LaneGeometry contact;
  LaneBody body;
  alarms.too_deep += evaluate_geometry<Law, Real, may_move>(law, records, block, walls, contact, body);
  const std::uint64_t difference = evaluate_law<Law, Real>(law.pair, law.dt, contact, body, nullptr, block, sums);
  alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
}

template <class Law, Lanes Real, bool may_move>
[[gnu::always_inline]] inline ContactAlarms evaluate_body(const WallLaw& law_in, std::span<WallContact> contacts,
                                                          std::span<const std::int32_t> chosen,
                                                          const ParticleRecord* records, ForceSum* sums) {
  const WallLaw law = law_in;  // a copy: nothing that the loop writes can be part of it
  ContactBlock block;
  LaneWalls walls;
  ContactAlarms alarms;
  for (std::size_t begin = 0; begin < chosen.size(); begin += block_lanes) {
    const auto lanes = chosen.subspan(begin, std::min<std::size_t>(block_lanes, chosen.size() - begin));
    gather_contacts(contacts, lanes, records, block, walls);
    evaluate_block<Law, Real, may_move>(law, walls, records, block, sums, alarms);
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      contacts[static_cast<std::size_t>(lanes[k])].history = history(block, k);
    }
  }
  return alarms;
}

/// Asks for what the loop reads and writes of a particle.
[[gnu::always_inline]] inline void fetch_ahead(std::int32_t particle, const ParticleRecord* records,
                                               const ForceSum* sums) {
  const auto* record = reinterpret_cast<const char*>(records + particle);
  __builtin_prefetch(record);
  __builtin_prefetch(record + 64);
  __builtin_prefetch(sums + particle, 1);
}

template <class Law, Lanes Real, bool may_move, class FaceShape>
[[gnu::always_inline]] inline ContactAlarms evaluate_face(const WallLaw& law_in, const FaceShape& face,
                                                          FaceGroup& group, const ParticleRecord* records,
                                                          ForceSum* sums) {
  const WallLaw law = law_in;
  LaneWalls walls;
  ContactAlarms alarms;
  for (std::size_t n = 0; n < group.blocks.size(); ++n) {
    ContactBlock& block = group.blocks[n];
    if (n + 1 < group.blocks.size()) {
      for (const std::int32_t particle : group.blocks[n + 1].first) fetch_ahead(particle, records, sums);
    }
    touch_face<Real, may_move>(face, law.placement, group.lanes - n * block_lanes, records, block, walls);
    evaluate_block<Law, Real, may_move>(law, walls, records, block, sums, alarms);
  }
  return alarms;
}

/// Calls `body` with the law of the pair and whether the wall may move. That most walls rest is worth a loop of its
/// own.
template <class Body>
auto with_wall_law(const WallLaw& law, const Body& body) {
  return with_law(law.pair, [&](auto pair_law) {
    if constexpr (!decltype(pair_law)::has_options) {
      if (law.surface == nullptr) return body(pair_law, std::false_type{});
    }
    return body(pair_law, std::true_type{});
  });
}

}  // namespace

ContactAlarms evaluate_walls(VectorLevel level, const WallLaw& law, std::span<WallContact> contacts,
                             std::span<const std::int32_t> chosen, const ParticleRecord* records, ForceSum* sums) {
  return with_wall_law(law, [&](auto pair_law, auto may_move) {
    return at_level(level, [&](auto lanes) REPOSE_INLINE {
      return evaluate_body<decltype(pair_law), LanesOf<lanes()>, may_move()>(law, contacts, chosen, records, sums);
    });
  });
}

ContactAlarms evaluate_faces(VectorLevel level, const WallLaw& law, FaceGroup& group, const ParticleRecord* records,
                             ForceSum* sums) {
  return with_wall_law(law, [&](auto pair_law, auto may_move) {
    return std::visit(
        [&](const auto& face) {
          return at_level(level, [&](auto lanes) REPOSE_INLINE {
            return evaluate_face<decltype(pair_law), LanesOf<lanes()>, may_move()>(law, face, group, records, sums);
          });
        },
        group.face);
  });
}

}  // namespace repose
