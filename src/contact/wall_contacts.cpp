#include "contact/wall_contacts.h"

#include <algorithm>

#include "contact/contact_law.h"
#include "contact/fixed_point.h"
#include "scene/sphere.h"

namespace repose {
namespace {

ContactGeometry wall_geometry(const ParticleRecord& p, const WallTouch& touch, double density) {
  const double overlap = p.radius - touch.distance;
  const double arm = p.radius - 0.5 * overlap;
  const Vec3 n = touch.normal;
  const double v_n = dot(p.velocity, n);
  ContactGeometry contact;
  contact.normal = n;
  contact.overlap = overlap;
  contact.radius_eff = p.radius;
  contact.mass_eff = sphere_mass(p.radius, density);
  contact.normal_velocity = v_n;
  contact.tangential_velocity = p.velocity - v_n * n - arm * cross(p.spin, n);
  // The thesis's program scales the rotation at a wall by the lever arm over the distance.
  contact.rolling_velocity = (arm / touch.distance) * without_normal_part(p.spin, n);
  return contact;
}

/// Adds to the sums of one particle; false when out of range.
bool add_forces(const ContactForces& forces, double arm, const ParticleRecord& p, ForceSum& sum) {
  const Vec3 torque = -(arm * forces.friction_arm) - forces.rolling_moment;
  bool in_range = add_fixed_point(to_fixed_point(forces.force.x, p.force_scale), sum.force[0]);
  in_range &= add_fixed_point(to_fixed_point(forces.force.y, p.force_scale), sum.force[1]);
  in_range &= add_fixed_point(to_fixed_point(forces.force.z, p.force_scale), sum.force[2]);
  in_range &= add_fixed_point(to_fixed_point(torque.x, p.torque_scale), sum.torque[0]);
  in_range &= add_fixed_point(to_fixed_point(torque.y, p.torque_scale), sum.torque[1]);
  in_range &= add_fixed_point(to_fixed_point(torque.z, p.torque_scale), sum.torque[2]);
  return in_range;
}

const WallContact* find(std::span<const WallContact> contacts, int wall, int feature) {
  const auto found = std::find_if(contacts.begin(), contacts.end(),
                                  [&](const WallContact& c) { return c.wall == wall && c.feature == feature; });
  return found == contacts.end() ? nullptr : &*found;
}

bool is_touched(const TouchBuffer& touches, int wall, int feature) {
  return std::any_of(touches.touches().begin(), touches.touches().end(),
                     [&](const WallTouch& t) { return t.wall == wall && t.feature == feature && t.superseded_by < 0; });
}

}  // namespace

void WallContacts::build(const Particles& particles, std::span<const Wall> walls, std::span<const double> reach,
                         const Csr<WallMemory>& memory) {
  candidates_.clear();
  candidate_walls_.clear();
  contacts_.clear();
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const auto first = static_cast<std::int32_t>(candidate_walls_.size());
    for (std::size_t w = 0; w < walls.size(); ++w) {
      if (distance(walls[w], particles.record[i].position) < reach[i]) {
        candidate_walls_.push_back(static_cast<std::int32_t>(w));
      }
    }
    const auto count = static_cast<std::int32_t>(candidate_walls_.size()) - first;
    if (count == 0) continue;
    candidates_.push_back({static_cast<std::int32_t>(i), first, count});
    for (const WallMemory& m : memory.row(i)) {
      contacts_.push_back({static_cast<std::int32_t>(i), m.wall, m.feature, 0.0, m.history});
    }
  }
  near_ = candidates_;
}

void WallContacts::select_near(const Particles& particles, std::span<const Wall> walls, const SkinRule& rule) {
  near_.clear();
  for (const Candidate& candidate : candidates_) {
    const ParticleRecord& p = particles.record[static_cast<std::size_t>(candidate.particle)];
    if (is_parked(p)) continue;
    const double reach = reach_of(p, rule);
    const auto first = candidate_walls_.begin() + candidate.first_wall;
    const bool near = std::any_of(first, first + candidate.walls, [&](std::int32_t w) {
      return distance(walls[static_cast<std::size_t>(w)], p.position) < reach;
    });
    if (near) near_.push_back(candidate);
  }
}

/// The history of a touch: that of the same feature before, or of a touch that this one now stands for, or of a
/// neighbouring feature of the wall that is touched no more.
ContactHistory WallContacts::inherited(std::span<const WallContact> before, std::span<const Wall> walls,
                                       const TouchBuffer& touches, int touch) const {
  const WallTouch& t = touches[touch];
  if (const WallContact* same = find(before, t.wall, t.feature)) return same->history;
  for (const WallTouch& other : touches.touches()) {
    if (other.superseded_by != touch) continue;
    if (const WallContact* handed = find(before, other.wall, other.feature)) return handed->history;
  }
  for (const WallContact& c : before) {
    if (c.wall != t.wall || is_touched(touches, c.wall, c.feature)) continue;
    if (adjacent_features(walls[static_cast<std::size_t>(t.wall)], c.feature, t.feature)) return c.history;
  }
  return {};
}

WallAlarms WallContacts::evaluate(std::span<const Wall> walls, const MaterialTable& materials, double dt,
                                  double max_overlap, Particles& particles) {
  std::swap(before_, contacts_);
  contacts_.clear();
  WallAlarms alarms;
  TouchBuffer touches;
  std::size_t next = 0;  // of before_
  for (const Candidate& candidate : near_) {
    const ParticleRecord& p = particles.record[static_cast<std::size_t>(candidate.particle)];
    ForceSum& sum = particles.sum[static_cast<std::size_t>(candidate.particle)];
    while (next < before_.size() && before_[next].particle < candidate.particle) ++next;
    const std::size_t first_before = next;
    while (next < before_.size() && before_[next].particle == candidate.particle) ++next;
    if (is_parked(p)) continue;
    const std::span<const WallContact> before(before_.data() + first_before, next - first_before);

    touches.clear();
    for (std::int32_t k = 0; k < candidate.walls; ++k) {
      const std::int32_t w = candidate_walls_[static_cast<std::size_t>(candidate.first_wall + k)];
      const Wall& wall = walls[static_cast<std::size_t>(w)];
      if (wall.present) find_touches(wall, w, p.position, p.radius, touches);
    }
    if (touches.size() == 0) continue;
    if (touches.size() > 1) resolve_touches(touches, p.radius);
    alarms.too_many += touches.overflowed() ? 1 : 0;

    const auto material = static_cast<std::size_t>(particles.material[static_cast<std::size_t>(candidate.particle)]);
    for (int t = 0; t < touches.size(); ++t) {
      const WallTouch& touch = touches[t];
      if (touch.superseded_by >= 0) continue;
      const auto wall_material = static_cast<std::size_t>(walls[static_cast<std::size_t>(touch.wall)].material);
      const PairParameters& pair = materials.pair(material, wall_material);
      ContactHistory history = inherited(before, walls, touches, t);
      const ContactGeometry contact = wall_geometry(p, touch, pair.density_first);
      const ContactForces forces = contact_law(pair, contact, dt, history);
      alarms.too_deep += contact.overlap > max_overlap * p.radius ? 1 : 0;
      alarms.out_of_range += add_forces(forces, p.radius - 0.5 * contact.overlap, p, sum) ? 0 : 1;
      contacts_.push_back({candidate.particle, touch.wall, touch.feature, contact.overlap, history});
    }
  }
  return alarms;
}

Csr<WallMemory> WallContacts::memory(std::size_t owned) const {
  std::vector<std::pair<std::size_t, WallMemory>> entries;
  entries.reserve(contacts_.size());
  for (const WallContact& c : contacts_) {
    entries.push_back({static_cast<std::size_t>(c.particle), {c.wall, c.feature, c.history}});
  }
  return Csr<WallMemory>::group(owned, entries);
}

}  // namespace repose
