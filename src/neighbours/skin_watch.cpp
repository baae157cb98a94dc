#include "neighbours/skin_watch.h"

namespace repose {

void SkinWatch::mark(const Particles& particles, const SkinRule& rule, std::vector<Mark>& marks) {
  marks.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    marks[i] = {particles.record[i].position, skin_of(particles.record[i], rule)};
  }
}

void SkinWatch::inner_selected(const Particles& particles) { mark(particles, inner_, inner_marks_); }

void SkinWatch::lists_rebuilt(const Particles& particles) {
  mark(particles, outer_, outer_marks_);
  mark(particles, inner_, inner_marks_);
}

bool SkinWatch::inner_is_used_up(const Particles& particles) const {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    const Mark& m = inner_marks_[i];
    const bool moved = squared_norm(p.position - m.position) >= m.skin * m.skin;
    if (moved && !is_parked(p)) return true;  // a parked particle is out of every contact, however far it went
  }
  return false;
}

bool SkinWatch::outer_is_too_short(const Particles& particles) const {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    const Mark& m = outer_marks_[i];
    const double left = m.skin - skin_of(p, inner_);
    if (left <= 0.0 || squared_norm(p.position - m.position) >= left * left) return true;
  }
  return false;
}

}  // namespace repose
