#include "neighbours/skin_watch.h"

#include <limits>

namespace repose {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

void SkinWatch::mark(const Particles& particles, const SkinRule& rule, BigVector<Mark>& marks) {
  marks.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    const double skin = is_parked(p) ? unlimited : skin_of(p, rule);
    marks[i] = {p.position, skin * skin};
  }
}

void SkinWatch::outer_listed(const Particles& particles) { mark(particles, outer_, outer_marks_); }
void SkinWatch::inner_selected(const Particles& particles) { mark(particles, inner_, inner_marks_); }

void SkinWatch::ignore_parked(const Particles& particles) {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) inner_marks_[i].squared_skin = unlimited;
  }
}

bool SkinWatch::outer_is_too_short(const Particles& particles) const {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    const Mark& m = outer_marks_[i];
    const double left = std::sqrt(m.squared_skin) - skin_of(p, inner_);
    if (left <= 0.0 || squared_norm(p.position - m.position) >= left * left) return true;
  }
  return false;
}

}  // namespace repose
