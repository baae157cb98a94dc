#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "scene/particles/mass_unit.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// The faces of the domain, through which particles leave for good.
inline constexpr std::array<const char*, 6> exit_names = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};

/// What has left the domain by each face, and of it by each named exit: on one rank, to be summed over all.
struct ExitCount {
  std::array<std::int64_t, 6> particles{};
  std::array<std::int64_t, 6> mass{};  ///< in the run's MassUnit
  std::vector<std::int64_t> named_particles = {};
  std::vector<std::int64_t> named_mass = {};

  /// Nothing yet, with so many named exits.
  static ExitCount none(std::size_t named) {
    return {.named_particles = std::vector<std::int64_t>(named), .named_mass = std::vector<std::int64_t>(named)};
  }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("particles", self.particles);
    v("mass", self.mass);
    v("named_particles", self.named_particles);
    v("named_mass", self.named_mass);
  }
};

/// Collective. What has left all ranks.
ExitCount sum_of(const Communicator& comm, const ExitCount& left_here);

/// What has left by one exit in all.
struct ExitTotal {
  std::string name;  ///< of a named exit, or of a face: then what left by its named exits is left out
  std::int64_t particles = 0;
  std::int64_t mass = 0;  ///< in the run's MassUnit
};

/// The faces, then the named exits.
std::vector<ExitTotal> exit_totals(std::span<const ExitDeck> exits, const ExitCount& left);

/// Parks every owned particle whose centre is outside the domain, which has no bounds in periodic directions. Counts it
/// at the face it is furthest beyond, and at the first of the named `exits` of that face, if any, beside which its
/// centre is.
void retire_leavers(const DomainDeck& domain, std::span<const ExitDeck> exits, const MaterialTable& materials,
                    const MassUnit& unit, Particles& particles, ExitCount& left);

}  // namespace repose
