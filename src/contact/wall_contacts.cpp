#include "contact/wall_contacts.h"

#include <algorithm>

namespace repose {
namespace {

constexpr std::int32_t every_wall = -1;

const WallContact* find(std::span<const WallContact> contacts, int wall, int feature) {
  const auto found = std::find_if(contacts.begin(), contacts.end(), [&](const WallContact& c) {
    return c.wall == wall && c.feature == feature && !is_blank(c.history);
  });
  return found == contacts.end() ? nullptr : &*found;
}

bool is_touched(const TouchBuffer& touches, int wall, int feature) {
  return std::any_of(touches.touches().begin(), touches.touches().end(),
                     [&](const WallTouch& t) { return t.wall == wall && t.feature == feature && t.superseded_by < 0; });
}

/// As if no particle had ever touched it.
void forget_all(FaceGroup& group) {
  for (std::size_t lane = 0; lane < group.lanes; ++lane) {
    set_history(group.blocks[lane / block_lanes], lane % block_lanes, {});
  }
}

/// Calls visit(particle, history) for the used lanes of a group.
template <class Visit>
void for_each_lane(const FaceGroup& group, Visit&& visit) {
  for (std::size_t lane = 0; lane < group.lanes; ++lane) {
    const ContactBlock& block = group.blocks[lane / block_lanes];
    visit(block.first[lane % block_lanes], history(block, lane % block_lanes));
  }
}

}  // namespace

/// The contact whose history a touch takes over: that of the same feature before, or of a touch that this one now
/// stands for, or of a neighbouring feature of the wall that is touched no more. Null: it is new. A contact without
/// history counts for nothing, as it may have been dropped when lists were rebuilt.
const WallContact* WallContacts::ancestor(std::span<const WallContact> before, std::span<const Wall> walls,
                                          const TouchBuffer& touches, int touch) const {
  const WallTouch& t = touches[touch];
  if (const WallContact* same = find(before, t.wall, t.feature)) return same;
  for (const WallTouch& other : touches.touches()) {
    if (other.superseded_by != touch) continue;
    if (const WallContact* handed = find(before, other.wall, other.feature)) return handed;
  }
  for (const WallContact& c : before) {
    if (c.wall != t.wall || is_blank(c.history) || is_touched(touches, c.wall, c.feature)) continue;
    if (adjacent_features(walls[static_cast<std::size_t>(t.wall)], c.feature, t.feature)) return &c;
  }
  return nullptr;
}

void WallContacts::find_contacts(std::span<const Wall> walls, const Particles& particles, WallAlarms& alarms) {
  std::swap(before_, contacts_);
  contacts_.clear();
  TouchBuffer touches;
  std::size_t next = 0;             // of before_
  constexpr std::size_t ahead = 8;  // candidates whose records are on their way from memory
  for (std::size_t n = 0; n < near_.size(); ++n) {
    const Candidate& candidate = near_[n];
    const auto later = static_cast<std::size_t>(near_[std::min(n + ahead, near_.size() - 1)].particle);
    __builtin_prefetch(&particles.record[later]);
    const ParticleRecord& p = particles.record[static_cast<std::size_t>(candidate.particle)];
    while (next < before_.size() && before_[next].particle < candidate.particle) ++next;
    const std::size_t first_before = next;
    while (next < before_.size() && before_[next].particle == candidate.particle) ++next;
    if (is_parked(p)) continue;
    const std::span<const WallContact> before(before_.data() + first_before, next - first_before);

    const Vec3 centre = particles.position(static_cast<std::size_t>(candidate.particle));
    const auto* first = &near_walls_[static_cast<std::size_t>(candidate.first_wall)];
    find_touches_of(walls, {first, static_cast<std::size_t>(candidate.walls)}, {centre, p.radius},
                    p.radius + adhesion_range_, touches);
    alarms.too_many += touches.overflowed() ? 1 : 0;
    for (int t = 0; t < touches.size(); ++t) {
      const WallTouch& touch = touches[t];
      if (touch.superseded_by >= 0) continue;
      const WallContact* old = ancestor(before, walls, touches, t);
      if (old == nullptr && touch.distance >= p.radius) continue;  // only what has touched can be held
      contacts_.push_back({candidate.particle, touch.wall, touch.feature, touch.normal, touch.distance,
                           p.radius - touch.distance, old != nullptr ? old->history : ContactHistory{}});
    }
  }
}

void WallContacts::forget(std::int32_t wall) {
  std::erase_if(contacts_, [&](const WallContact& c) { return c.wall == wall; });
  for (FaceGroup& group : faces_) {
    if (group.wall == wall) forget_all(group);
  }
}

void WallContacts::locate(std::span<const Wall> walls, const Particles& particles) {
  WallAlarms ignored;
  find_contacts(walls, particles, ignored);
}

WallAlarms WallContacts::evaluate(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials,
                                  double dt, double max_overlap, Particles& particles) {
  WallAlarms alarms;
  find_contacts(walls, particles, alarms);
  of_law_.resize(materials.size() * walls.size());
  for (auto& chosen : of_law_) chosen.clear();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto material = static_cast<std::size_t>(particles.material[static_cast<std::size_t>(contacts_[k].particle)]);
    of_law_[material * walls.size() + static_cast<std::size_t>(contacts_[k].wall)].push_back(
        static_cast<std::int32_t>(k));
  }
  for (std::size_t k = 0; k < of_law_.size(); ++k) {
    if (of_law_[k].empty()) continue;
    const auto material = static_cast<std::int32_t>(k / walls.size());
    const WallLaw law = wall_law(materials, material, walls[k % walls.size()], dt, max_overlap);
    alarms += evaluate_walls(level, law, contacts_, of_law_[k], particles.record.data(), particles.sum.data());
  }
  for (FaceGroup& group : faces_) {
    const Wall& wall = walls[static_cast<std::size_t>(group.wall)];
    if (!wall.present) {
      forget_all(group);
      continue;
    }
    const WallLaw law = wall_law(materials, group.material, wall, dt, max_overlap);
    alarms += evaluate_faces(level, law, group, particles.record.data(), particles.sum.data());
  }
  return alarms;
}

std::vector<WallContact> WallContacts::contacts(std::span<const Wall> walls, const Particles& particles) const {
  return contacts_if(walls, particles, every_wall);
}

std::vector<WallContact> WallContacts::contacts_with(std::int32_t wall, std::span<const Wall> walls,
                                                     const Particles& particles) const {
  return contacts_if(walls, particles, wall);
}

std::vector<WallContact> WallContacts::contacts_if(std::span<const Wall> walls, const Particles& particles,
                                                   std::int32_t only) const {
  const auto is_asked = [&](std::int32_t wall) { return only == every_wall || only == wall; };
  std::vector<WallContact> all;
  for (const WallContact& c : contacts_) {
    if (is_asked(c.wall) && (c.overlap > 0.0 || !is_blank(c.history))) all.push_back(c);
  }
  TouchBuffer touches;
  for (const FaceGroup& group : faces_) {
    const Wall& wall = walls[static_cast<std::size_t>(group.wall)];
    if (!wall.present || !is_asked(group.wall)) continue;
    for_each_lane(group, [&](std::int32_t particle, const ContactHistory& history) {
      const ParticleRecord& p = particles.record[static_cast<std::size_t>(particle)];
      if (is_parked(p)) return;
      touches.clear();
      const double touching = is_blank(history) ? p.radius : p.radius + adhesion_range_;
      if (find_touches(wall, group.wall, p.position, touching, touches) == 0) return;
      const WallTouch& t = touches[0];
      all.push_back({particle, t.wall, t.feature, t.normal, t.distance, p.radius - t.distance, history});
    });
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const WallContact& a, const WallContact& b) { return a.particle < b.particle; });
  return all;
}

std::size_t WallContacts::in_lanes() const {
  std::size_t lanes = 0;
  for (const FaceGroup& group : faces_) lanes += group.lanes;
  return lanes;
}

std::size_t WallContacts::bytes_of_faces() const {
  std::size_t bytes = bytes_of(faces_);
  for (const FaceGroup& group : faces_) bytes += bytes_of(group.blocks);
  return bytes;
}

Csr<WallMemory> WallContacts::memory(std::size_t owned) const {
  return Csr<WallMemory>::group(owned, [&](const auto& add_row) {
    const auto add = [&](std::int32_t particle, std::int32_t wall, std::int32_t feature, const ContactHistory& h) {
      if (!is_blank(h)) add_row(static_cast<std::size_t>(particle), {wall, feature, h});
    };
    for (const WallContact& c : contacts_) add(c.particle, c.wall, c.feature, c.history);
    for (const FaceGroup& group : faces_) {
      for_each_lane(
          group, [&](std::int32_t particle, const ContactHistory& h) { add(particle, group.wall, group.feature, h); });
    }
  });
}

}  // namespace repose
