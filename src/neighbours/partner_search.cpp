#include "neighbours/partner_search.h"

#include <utility>

namespace repose {

void PartnerSearch::begin(std::vector<CellLevel> levels, std::size_t owned) {
  levels_ = std::move(levels);
  last_renewal_.assign(owned, never);
  renewed_.clear();
  spheres_.clear();
}

void PartnerSearch::renew(const Particles& particles, const SkinWatch& watch, std::span<const std::int32_t> renewed) {
  for (const std::int32_t i : renewed) {
    last_renewal_[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(renewed_.size());
    renewed_.push_back(i);
    spheres_.push_back(watch.outer_sphere(particles, static_cast<std::size_t>(i)));
  }
}

std::span<const std::int32_t> PartnerSearch::partners(const Particles& particles, const SkinWatch& watch,
                                                      std::int32_t i) {
  const ReachSphere sphere = watch.outer_sphere(particles, static_cast<std::size_t>(i));
  const auto is_parked_one = [&](std::int32_t j) { return is_parked(particles.record[static_cast<std::size_t>(j)]); };
  partners_.clear();
  for (const CellLevel& level : levels_) {
    for_each_candidate(level, sphere.position, sphere.reach, [&](std::int32_t candidate) {
      const auto j = static_cast<std::size_t>(candidate);
      if (j >= last_renewal_.size() || last_renewal_[j] != never) return;
      if (overlap(sphere, watch.outer_sphere(particles, j)) && !is_parked_one(candidate)) {
        partners_.push_back(candidate);
      }
    });
  }
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    if (!overlap(sphere, spheres_[k])) continue;
    const std::int32_t j = renewed_[k];
    const bool counts = last_renewal_[static_cast<std::size_t>(j)] == static_cast<std::int32_t>(k);
    if (counts && j != i && !is_parked_one(j)) partners_.push_back(j);
  }
  return partners_;
}

std::size_t PartnerSearch::bytes() const {
  std::size_t count = bytes_of(last_renewal_) + bytes_of(renewed_) + bytes_of(spheres_) + bytes_of(partners_);
  for (const CellLevel& level : levels_) count += bytes_of(level.members);
  return count;
}

}  // namespace repose
