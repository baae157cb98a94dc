#include "neighbours/skin_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

void SkinWatch::begin_outer(const Particles& particles) {
  owned_ = particles.owned;
  outer_marks_.resize(particles.total());
  for (std::size_t i = 0; i < outer_marks_.size(); ++i) begin_outer(particles, i);
}

void SkinWatch::begin_outer(const Particles& particles, std::size_t i) {
  const ParticleRecord& p = particles.record[i];
  const double skin = is_parked(p) ? unlimited : skin_of(p, outer_);
  outer_marks_[i] = {p.position, skin * skin};
}

ReachSphere SkinWatch::outer_sphere(const Particles& particles, std::size_t i) const {
  const Mark& mark = outer_marks_[i];
  return {mark.position, reach_of(particles.record[i], outer_, std::sqrt(mark.squared_skin))};
}

void SkinWatch::begin_inner(const Particles& particles) {
  inner_marks_.resize(outer_marks_.size());
  inner_spheres_.resize(outer_marks_.size());
  for (std::size_t i = 0; i < inner_marks_.size(); ++i) begin_inner(particles, i);
}

void SkinWatch::begin_inner(const Particles& particles, std::span<const std::int32_t> moved) {
  for (const std::int32_t i : moved) begin_inner(particles, static_cast<std::size_t>(i));
}

void SkinWatch::begin_inner(const Particles& particles, std::size_t i) {
  const ParticleRecord& p = particles.record[i];
  if (is_parked(p)) {
    inner_marks_[i] = {p.position, unlimited};
    inner_spheres_[i] = {p.position, 0.0};
    return;
  }
  const double skin = std::min(skin_of(p, inner_), left_of_outer(particles, i));
  inner_marks_[i] = {p.position, skin * skin};
  inner_spheres_[i] = {p.position, reach_of(p, inner_, skin)};
}

double SkinWatch::left_of_outer(const Particles& particles, std::size_t i) const {
  const Mark& mark = outer_marks_[i];
  return std::sqrt(mark.squared_skin) - norm(particles.record[i].position - mark.position);
}

void SkinWatch::ignore_parked(const Particles& particles) {
  for (std::size_t i = 0; i < owned_; ++i) {
    if (is_parked(particles.record[i])) inner_marks_[i].squared_skin = unlimited;
  }
}

std::span<const std::int32_t> SkinWatch::moved_ghosts(const Particles& particles) {
  moved_ghosts_.clear();
  for (std::size_t i = owned_; i < inner_marks_.size(); ++i) {
    if (is_used_up(inner_marks_[i], particles.record[i])) moved_ghosts_.push_back(static_cast<std::int32_t>(i));
  }
  return moved_ghosts_;
}

bool SkinWatch::outer_is_used_up(const Particles& particles, std::size_t i) const {
  return !is_parked(particles.record[i]) && left_of_outer(particles, i) <= 0.0;
}

}  // namespace repose
