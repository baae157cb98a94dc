#include "integration/held_particles.h"

#include <algorithm>

#include "scene/particles/periodicity.h"

namespace repose {

HeldParticles::HeldParticles(const Deck& deck, const Insertion& insertion) {
  for (std::size_t b = 0; b < deck.particles.size(); ++b) {
    const ParticlesDeck& deck_block = deck.particles[b];
    if (!is_held(deck_block) && !deck_block.rotation_blocked) continue;
    Block block = {.first = insertion.block_begin[b],
                   .end = insertion.block_begin[b + 1],
                   .held = is_held(deck_block),
                   .start = {},
                   .motions = Motions(deck_block.motions),
                   .placement = {}};
    for (std::size_t i = 0; i < insertion.now.size() && !block.motions.empty(); ++i) {
      if (block.contains(insertion.now.id[i])) block.start.push_back(insertion.now.position[i]);
    }
    blocks_.push_back(std::move(block));
  }
}

void HeldParticles::begin_phase(const std::string& phase) {
  for (Block& block : blocks_) block.motions.begin_phase(phase);
}

void HeldParticles::list(Particles& particles) {
  held_.clear();
  if (blocks_.empty()) return;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const std::int64_t id = particles.id[i];
    const auto block = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.contains(id); });
    if (block == blocks_.end()) continue;
    particles.torque_to_acceleration[i] = 0.0;
    if (!block->held) {
      particles.record[i].spin = {};  // of a list
      continue;
    }
    particles.force_to_acceleration[i] = 0.0;
    const Vec3 position = block->motions.empty() ? particles.record[i].position
                                                 : block->start[static_cast<std::size_t>(id - block->first)];
    held_.push_back({i, static_cast<std::size_t>(block - blocks_.begin()), position});
  }
}

void HeldParticles::step(double dt) {
  for (Block& block : blocks_) block.motions.step();
  place(dt);
}

void HeldParticles::place(double dt) {
  for (Block& block : blocks_) block.placement = block.motions.placement(dt);
}

void HeldParticles::hold(Particles& particles) const {
  for (const Held& held : held_) {
    ParticleRecord& p = particles.record[held.index];
    if (is_parked(p)) continue;
    const Placement& placement = blocks_[held.block].placement;
    p.position = blocks_[held.block].motions.empty() ? held.position : placement.place(held.position);
    p.velocity = placement.motion.at(p.position);
    p.spin = placement.motion.angular_velocity;
  }
}

bool HeldParticles::is_any_outside(const DomainDeck& domain, const Particles& particles) const {
  return std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
    const ParticleRecord& p = particles.record[held.index];
    return !blocks_[held.block].motions.empty() && !is_parked(p) && is_outside(domain, p.position);
  });
}

std::size_t HeldParticles::find_moved(std::span<const Mark> marks, const Particles& particles,
                                      std::span<std::int32_t> moved) const {
  std::size_t count = 0;
  for (const Held& held : held_) {
    if (!is_used_up(marks[held.index], particles.record[held.index])) continue;
    moved[count++] = static_cast<std::int32_t>(held.index);
  }
  return count;
}

}  // namespace repose
