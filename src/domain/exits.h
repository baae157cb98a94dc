#pragma once

#include <array>
#include <cstdint>

#include "deck/deck.h"
#include "scene/mass_unit.h"
#include "scene/materials.h"
#include "scene/particles.h"

namespace repose {

/// The faces of the domain, through which particles leave for good.
inline constexpr std::array<const char*, 6> exit_names = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};

/// What has left the domain by each exit: on one rank, to be summed over all.
struct ExitCount {
  std::array<std::int64_t, 6> particles{};
  std::array<std::int64_t, 6> mass{};  ///< in the run's MassUnit
};

/// Parks every owned particle whose centre is outside the domain, and counts it at the exit it is furthest beyond.
void retire_leavers(const DomainDeck& domain, const MaterialTable& materials, const MassUnit& unit,
                    Particles& particles, ExitCount& left);

}  // namespace repose
