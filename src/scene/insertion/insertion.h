#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "files/read_file.h"
#include "scene/insertion/new_particles.h"
#include "scene/insertion/pour.h"
#include "scene/sizes/size_report.h"
#include "scene/walls/wall.h"

namespace repose {

/// The particles of a snapshot file named in the deck, without numbers; the same on all ranks.
using ReadSnapshot = std::function<NewParticles(const std::string&)>;

/// All that a deck brings in. The blocks [[particles]] own consecutive ranges of numbers, in the order of the deck,
/// also where they are poured later.
struct Insertion {
  NewParticles now;                             ///< at the start
  std::vector<Pour> pours;                      ///< later
  std::vector<SizeReport> sizes;                ///< of the blocks with [particles.sizes]
  std::int64_t planned = 0;                     ///< particles at the start and later
  std::vector<std::int64_t> block_begin = {0};  ///< the first number of each block of the deck, and of none behind them

  /// Calls visit(radius, material) for every particle, present and planned, in the order of this struct.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t i = 0; i < now.size(); ++i) visit(now.radius[i], static_cast<std::size_t>(now.material[i]));
    for (const Pour& pour : pours) {
      for (const double radius : pour.radius) visit(radius, static_cast<std::size_t>(pour.material));
    }
  }
  double largest_radius() const {
    double largest = 0.0;
    for_each([&](double radius, std::size_t) { largest = std::max(largest, radius); });
    return largest;
  }
};

/// What the blocks [[particles]] of the deck bring in. A function of its arguments alone: the same on every rank.
/// DeckError when a block does not fit into its region, a particle is outside the domain, reaches into another or into
/// a present wall by more than the guard `max_overlap` of the smaller radius, or when filled blocks overlap with others
/// at all.
Insertion insert_particles(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file,
                           const ReadSnapshot& read_snapshot = {});

}  // namespace repose
