#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/cell_levels.h"
#include "neighbours/skin_watch.h"

namespace repose {

/// Finds the partners of single owned particles whose outer skins begin anew alone, between two outer lists for all.
class PartnerSearch {
 public:
  /// To be called when an outer list has been made, with the levels that it was found by.
  void begin(std::vector<CellLevel> levels, std::size_t owned);

  /// The outer skins of these particles have begun anew, so that they are not where the levels have them any more.
  void renew(const Particles& particles, const SkinWatch& watch, std::span<const std::int32_t> renewed);
  std::size_t renewals() const { return renewed_.size(); }  ///< since the last outer list for all

  /// The other owned particles, but parked ones, whose outer spheres overlap that of particle i, which has been
  /// renewed; until the next call.
  std::span<const std::int32_t> partners(const Particles& particles, const SkinWatch& watch, std::int32_t i);

  std::size_t bytes() const;

 private:
  static constexpr std::int32_t never = -1;

  std::vector<CellLevel> levels_;
  std::vector<std::int32_t> last_renewal_;  ///< of each owned particle, into renewed_, or never
  std::vector<std::int32_t> renewed_;       ///< looked through one by one; only the last entry of a particle counts
  std::vector<ReachSphere> spheres_;        ///< of renewed_
  std::vector<std::int32_t> partners_;
};

}  // namespace repose
