#include "contact/wall_loop.h"

#include <algorithm>

#include "contact/contact_law.h"
#include "scene/sphere.h"

namespace repose {
namespace {

/// Where the walls of a block's contacts are, by column.
struct LaneWalls {
  alignas(64) double normal[3][block_lanes], distance[block_lanes];
};

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
    walls.distance[k] = k < used ? contact.distance : records[contact.particle].radius;
    set_history(block, static_cast<std::size_t>(k), contact.history);
  }
}

/// Asks for the records and sums of a block's particles.
[[gnu::always_inline]] inline void fetch_ahead(const ContactBlock& block, const ParticleRecord* records,
                                               const ForceSum* sums) {
  for (const std::int32_t particle : block.first) {
    const auto* record = reinterpret_cast<const char*>(records + particle);
    __builtin_prefetch(record);
    __builtin_prefetch(record + 64);
    __builtin_prefetch(sums + particle, 1);
  }
}

/// Lanes from `used` on, and parked particles, get a distance at which they do not touch.
template <class FaceShape>
[[gnu::always_inline]] inline void touch_face(const FaceShape& face_in, std::size_t used, const ParticleRecord* records,
                                              const ContactBlock& block, LaneWalls& walls) {
  const FaceShape face = face_in;
  const auto lanes = static_cast<std::int64_t>(used);
  for (int k = 0; k < block_lanes; k += 4) {
    const QuadParticle p = gather(records, block.first + k);
    const BasicFaceTouch<Quad> at = touch(face, p.position);
    const QuadInt lane = QuadInt{0, 1, 2, 3} + k;
    const QuadInt here = (lane < lanes) & (p.position.x < broadcast<Quad>(parking_distance));
    store(at.normal, walls.normal, k);
    store(select(here, at.distance, p.radius), walls.distance + k);
  }
}

/// Returns the number of contacts deeper than `max_overlap` times the radius.
template <class Law>
[[gnu::always_inline]] inline std::int64_t evaluate_geometry(const ParticleRecord* records, const ContactBlock& block,
                                                             const LaneWalls& walls, double density, double max_overlap,
                                                             LaneGeometry& contact, LaneBody& body) {
  const Quad none = {};
  QuadInt deep = {};
  for (int k = 0; k < block_lanes; k += 4) {
    const QuadParticle p = gather(records, block.first + k);
    const Quad distance = load(walls.distance + k);
    const QuadVec3 n = load(walls.normal, k);
    const Quad gap = p.radius - distance;
    const Quad overlap = gap > none ? gap : none;
    const Quad arm = p.radius - 0.5 * overlap;
    const Quad v_n = dot(p.velocity, n);
    store(n, contact.normal, k);
    store(overlap, contact.overlap + k);
    store(p.radius, contact.radius_eff + k);
    store(sphere_mass(p.radius, density), contact.mass_eff + k);
    store(v_n, contact.normal_velocity + k);
    store(p.velocity - v_n * n - arm * cross(p.spin, n), contact.tangential_velocity, k);
    // The thesis's program scales the rotation at a wall by the lever arm over the distance.
    store((arm / distance) * without_normal_part(p.spin, n), contact.rolling_velocity, k);
    if constexpr (Law::has_options) store(n, contact.velocity_normal, k);  // of a flat wall, the same at all times
    store(arm, body.arm + k);
    body.set_scales(k, p);
    deep += overlap > max_overlap * p.radius;
  }
  return count(deep);
}

template <class Law>
[[gnu::always_inline]] inline ContactAlarms evaluate_body(std::span<WallContact> contacts,
                                                          std::span<const std::int32_t> chosen,
                                                          const PairParameters& pair, double dt, double max_overlap,
                                                          const ParticleRecord* records, ForceSum* sums) {
  ContactBlock block;
  LaneWalls walls;
  LaneGeometry contact;
  LaneBody body;
  ContactAlarms alarms;
  for (std::size_t begin = 0; begin < chosen.size(); begin += block_lanes) {
    const auto lanes = chosen.subspan(begin, std::min<std::size_t>(block_lanes, chosen.size() - begin));
    gather_contacts(contacts, lanes, records, block, walls);
    alarms.too_deep += evaluate_geometry<Law>(records, block, walls, pair.density_first, max_overlap, contact, body);
    const std::uint64_t difference = evaluate_law<Law>(pair, dt, contact, body, nullptr, block, sums);
    alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      contacts[static_cast<std::size_t>(lanes[k])].history = history(block, k);
    }
  }
  return alarms;
}

template <class Law, class FaceShape>
[[gnu::always_inline]] inline ContactAlarms evaluate_face(const FaceShape& face, FaceGroup& group,
                                                          const PairParameters& pair, double dt, double max_overlap,
                                                          const ParticleRecord* records, ForceSum* sums) {
  LaneWalls walls;
  LaneGeometry contact;
  LaneBody body;
  ContactAlarms alarms;
  for (std::size_t n = 0; n < group.blocks.size(); ++n) {
    ContactBlock& block = group.blocks[n];
    if (n + 1 < group.blocks.size()) fetch_ahead(group.blocks[n + 1], records, sums);
    touch_face(face, group.lanes - n * block_lanes, records, block, walls);
    alarms.too_deep += evaluate_geometry<Law>(records, block, walls, pair.density_first, max_overlap, contact, body);
    const std::uint64_t difference = evaluate_law<Law>(pair, dt, contact, body, nullptr, block, sums);
    alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
  }
  return alarms;
}

}  // namespace

ContactAlarms evaluate_walls(VectorLevel level, std::span<WallContact> contacts, std::span<const std::int32_t> chosen,
                             const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                             ForceSum* sums) {
  return with_law(pair, [&](auto law) {
    return at_level(level, [&]() REPOSE_INLINE {
      return evaluate_body<decltype(law)>(contacts, chosen, pair, dt, max_overlap, records, sums);
    });
  });
}

ContactAlarms evaluate_faces(VectorLevel level, FaceGroup& group, const PairParameters& pair, double dt,
                             double max_overlap, const ParticleRecord* records, ForceSum* sums) {
  return std::visit(
      [&](const auto& face) {
        return with_law(pair, [&](auto law) {
          return at_level(level, [&]() REPOSE_INLINE {
            return evaluate_face<decltype(law)>(face, group, pair, dt, max_overlap, records, sums);
          });
        });
      },
      group.face);
}

}  // namespace repose
