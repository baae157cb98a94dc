#include "contact/wall_contacts.h"

#include <algorithm>

namespace repose {
namespace {

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
      contacts_.push_back({static_cast<std::int32_t>(i), m.wall, m.feature, {}, 0.0, 0.0, m.history});
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

/// The contact whose history a touch takes over: that of the same feature before, or of a touch that this one now
/// stands for, or of a neighbouring feature of the wall that is touched no more. Null: it is new.
const WallContact* WallContacts::ancestor(std::span<const WallContact> before, std::span<const Wall> walls,
                                          const TouchBuffer& touches, int touch) const {
  const WallTouch& t = touches[touch];
  if (const WallContact* same = find(before, t.wall, t.feature)) return same;
  for (const WallTouch& other : touches.touches()) {
    if (other.superseded_by != touch) continue;
    if (const WallContact* handed = find(before, other.wall, other.feature)) return handed;
  }
  for (const WallContact& c : before) {
    if (c.wall != t.wall || is_touched(touches, c.wall, c.feature)) continue;
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

    touches.clear();
    for (std::int32_t k = 0; k < candidate.walls; ++k) {
      const std::int32_t w = candidate_walls_[static_cast<std::size_t>(candidate.first_wall + k)];
      const Wall& wall = walls[static_cast<std::size_t>(w)];
      if (wall.present) find_touches(wall, w, p.position, p.radius, touches);
    }
    if (touches.size() > 1) resolve_touches(touches, p.radius);
    alarms.too_many += touches.overflowed() ? 1 : 0;
    for (int t = 0; t < touches.size(); ++t) {
      const WallTouch& touch = touches[t];
      if (touch.superseded_by >= 0) continue;
      const WallContact* old = ancestor(before, walls, touches, t);
      contacts_.push_back({candidate.particle, touch.wall, touch.feature, touch.normal, touch.distance,
                           p.radius - touch.distance, old != nullptr ? old->history : ContactHistory{}});
    }
  }
}

WallAlarms WallContacts::evaluate(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials,
                                  double dt, double max_overlap, Particles& particles) {
  WallAlarms alarms;
  find_contacts(walls, particles, alarms);
  of_materials_.resize(materials.size() * materials.size());
  for (auto& chosen : of_materials_) chosen.clear();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto particle = static_cast<std::size_t>(particles.material[static_cast<std::size_t>(contacts_[k].particle)]);
    const auto wall = static_cast<std::size_t>(walls[static_cast<std::size_t>(contacts_[k].wall)].material);
    of_materials_[particle * materials.size() + wall].push_back(static_cast<std::int32_t>(k));
  }
  for (std::size_t k = 0; k < of_materials_.size(); ++k) {
    if (of_materials_[k].empty()) continue;
    const PairParameters& pair = materials.pair(k / materials.size(), k % materials.size());
    const ContactAlarms here = evaluate_walls(level, contacts_, of_materials_[k], pair, dt, max_overlap,
                                              particles.record.data(), particles.sum.data());
    alarms.too_deep += here.too_deep;
    alarms.out_of_range += here.out_of_range;
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
