// Which walls a particle may touch before the lists are renewed, and which particles need no search for it.
#include <algorithm>

#include "base/index.h"
#include "contact/wall_contacts.h"

namespace repose {
namespace {

/// Whether a particle that feels what is nearer than `touching` (m) and moves by less than `skin` can touch one face
/// and nothing else, and remembers of no other.
bool is_at_one_face(std::span<const Wall> walls, const TouchBuffer& touches, std::span<const WallMemory> memory,
                    const Vec3& centre, double touching, double skin) {
  if (touches.size() != 1 || !touches[0].on_face || memory.size() > 1) return false;
  const WallTouch& t = touches[0];
  if (!memory.empty() && (memory[0].wall != t.wall || memory[0].feature != t.feature)) return false;
  const Wall& wall = walls[static_cast<std::size_t>(t.wall)];
  return keeps_to_face(wall, t.feature, centre, touching + skin + wall.inner_skin, skin + wall.inner_skin);
}

/// Whether a wall is nearer than `reach` to a particle, be it across a periodic boundary that it may pass. None is to
/// one that feels no walls, whose reach is below zero.
bool is_within_reach(const Wall& wall, const Particles& particles, std::size_t i, double reach) {
  if (!(reach > 0.0)) return false;
  const Vec3 position = particles.position(i);
  bool found = false;
  particles.periodic.for_each_shift(
      position, reach, [&](const Vec3& shift) { found = found || is_within(wall, position + shift, reach); });
  return found;
}

/// Of entries in the order of their particles.
constexpr auto comes_before = [](const auto& entry, std::int32_t particle) { return entry.particle < particle; };

}  // namespace

void WallContacts::build(const Particles& particles, std::span<const Wall> walls, std::span<const double> reach,
                         const Csr<WallMemory>& memory) {
  candidates_.clear();
  candidate_walls_.clear();
  contacts_.clear();
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const auto first = static_cast<std::int32_t>(candidate_walls_.size());
    for (std::size_t w = 0; w < walls.size(); ++w) {
      if (is_within_reach(walls[w], particles, i, reach[i] + walls[w].outer_skin)) {
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
  faces_.clear();
  group_of_.clear();
  near_ = candidates_;
  near_walls_ = candidate_walls_;
}

void WallContacts::list_more(const Particles& particles, std::span<const Wall> walls, std::int32_t i, double reach) {
  const auto place = std::lower_bound(candidates_.begin(), candidates_.end(), i, comes_before);
  const bool is_listed = place != candidates_.end() && place->particle == i;
  std::span<const std::int32_t> listed;
  if (is_listed) listed = std::span(candidate_walls_).subspan(index(place->first_wall), index(place->walls));
  std::vector<std::int32_t> all;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto wall = static_cast<std::int32_t>(w);
    const bool is_old = std::find(listed.begin(), listed.end(), wall) != listed.end();
    if (is_old || is_within_reach(walls[w], particles, index(i), reach + walls[w].outer_skin)) all.push_back(wall);
  }
  if (all.size() == listed.size()) return;
  const Candidate more = {i, static_cast<std::int32_t>(candidate_walls_.size()), static_cast<std::int32_t>(all.size())};
  candidate_walls_.insert(candidate_walls_.end(), all.begin(), all.end());
  if (is_listed) {
    *place = more;
  } else {
    candidates_.insert(place, more);
  }
}

void WallContacts::select_near(const Particles& particles, std::span<const Wall> walls, const SkinRule& rule) {
  const Csr<WallMemory> memory = this->memory(particles.owned);
  adhesion_range_ = rule.adhesion_range;
  for (FaceGroup& group : faces_) {
    group.blocks.clear();
    group.lanes = 0;
  }
  near_.clear();
  near_walls_.clear();
  contacts_.clear();
  TouchBuffer touches;
  for (const Candidate& candidate : candidates_) {
    const auto i = static_cast<std::size_t>(candidate.particle);
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    const double skin = skin_of(p, rule);
    const double touching = p.radius + rule.adhesion_range;
    const Vec3 position = particles.position(i);
    const auto first = static_cast<std::int32_t>(near_walls_.size());
    touches.clear();
    for (std::int32_t k = 0; k < candidate.walls; ++k) {
      const std::int32_t w = candidate_walls_[static_cast<std::size_t>(candidate.first_wall + k)];
      const Wall& wall = walls[static_cast<std::size_t>(w)];
      const double range = touching + skin + wall.inner_skin;
      bool near = false;
      particles.periodic.for_each_shift(position, skin, [&](const Vec3& shift) {
        near |= find_touches(wall, w, position + shift, range, touches) > 0 ||
                (touches.overflowed() && is_within(wall, position + shift, range));
      });
      if (near) near_walls_.push_back(w);
    }
    const auto count = static_cast<std::int32_t>(near_walls_.size()) - first;
    if (count == 0) continue;
    const std::span<const WallMemory> old = memory.row(i);
    if (particles.periodic.stays_inside(p.position, skin) &&
        is_at_one_face(walls, touches, old, p.position, touching, skin)) {
      near_walls_.resize(static_cast<std::size_t>(first));
      const Wall& wall = walls[static_cast<std::size_t>(touches[0].wall)];
      add_lane(group_for(particles, i, wall, touches[0]), candidate.particle,
               old.empty() ? ContactHistory{} : old.front().history);
      continue;
    }
    near_.push_back({candidate.particle, first, count});
    for (const WallMemory& m : old) {
      contacts_.push_back({candidate.particle, m.wall, m.feature, {}, 0.0, 0.0, m.history});
    }
  }
}

FaceGroup& WallContacts::group_for(const Particles& particles, std::size_t particle, const Wall& wall,
                                   const WallTouch& touch) {
  const std::int32_t material = particles.material[particle];
  const auto [group, is_new] = group_of_.try_emplace({material, touch.wall, touch.feature}, faces_.size());
  if (!is_new) return faces_[group->second];
  return faces_.emplace_back(FaceGroup{.material = material,
                                       .wall = touch.wall,
                                       .feature = touch.feature,
                                       .face = face_of(wall, touch.feature),
                                       .blocks = {}});
}

void WallContacts::add_lane(FaceGroup& group, std::int32_t particle, const ContactHistory& history) {
  const std::size_t lane = group.lanes++ % block_lanes;
  if (lane == 0) {
    ContactBlock& block = group.blocks.emplace_back();
    std::fill(std::begin(block.first), std::end(block.first), particle);
  }
  group.blocks.back().first[lane] = particle;
  set_history(group.blocks.back(), lane, history);
}

void WallContacts::search(std::span<const std::int32_t> moved) {
  for (const std::int32_t particle : moved) {
    const auto all = std::lower_bound(candidates_.begin(), candidates_.end(), particle, comes_before);
    if (all == candidates_.end() || all->particle != particle) continue;
    const auto near = std::lower_bound(near_.begin(), near_.end(), particle, comes_before);
    const bool is_searched = near != near_.end() && near->particle == particle;
    if (is_searched && near->walls == all->walls) continue;
    const Candidate searched = {particle, static_cast<std::int32_t>(near_walls_.size()), all->walls};
    for (std::int32_t k = 0; k < all->walls; ++k) {
      near_walls_.push_back(candidate_walls_[static_cast<std::size_t>(all->first_wall + k)]);
    }
    if (is_searched) {
      *near = searched;
      continue;
    }
    near_.insert(near, searched);
    const WallMemory memory = take_lane_of(particle);
    if (is_blank(memory.history)) continue;
    contacts_.insert(std::lower_bound(contacts_.begin(), contacts_.end(), particle, comes_before),
                     {particle, memory.wall, memory.feature, {}, 0.0, 0.0, memory.history});
  }
}

/// Takes a particle out of the lanes of faces, if it is there, with what it remembers. The last lane takes its place.
WallMemory WallContacts::take_lane_of(std::int32_t particle) {
  for (FaceGroup& group : faces_) {
    for (std::size_t lane = 0; lane < group.lanes; ++lane) {
      ContactBlock& block = group.blocks[lane / block_lanes];
      const std::size_t slot = lane % block_lanes;
      if (block.first[slot] != particle) continue;
      const WallMemory memory = {group.wall, group.feature, history(block, slot)};
      ContactBlock& last = group.blocks.back();
      const std::size_t last_slot = --group.lanes % block_lanes;
      block.first[slot] = last.first[last_slot];
      set_history(block, slot, history(last, last_slot));
      last.first[last_slot] = last.first[0];
      set_history(last, last_slot, {});
      if (last_slot == 0) group.blocks.pop_back();
      return memory;
    }
  }
  return {};
}

}  // namespace repose
