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

ListState SkinWatch::state(const Particles& particles) const {
  bool moved = false;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const Mark& m = inner_marks_[i];
    moved |= squared_norm(particles.record[i].position - m.position) >= m.skin * m.skin;
  }
  if (!moved) return ListState::valid;

  bool stale = false;
  bool moved_inside = false;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;  // out of every contact, wherever it went
    const Mark& inner = inner_marks_[i];
    const Mark& outer = outer_marks_[i];
    moved_inside |= squared_norm(p.position - inner.position) >= inner.skin * inner.skin;
    const double left = outer.skin - skin_of(p, inner_);
    stale |= left <= 0.0 || squared_norm(p.position - outer.position) >= left * left;
  }
  if (!moved_inside) return ListState::valid;
  return stale ? ListState::outer_stale : ListState::inner_stale;
}

}  // namespace repose
