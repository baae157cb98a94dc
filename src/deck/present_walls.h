#pragma once

#include <set>
#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

/// Which walls are there while phases add and remove them.
class PresentWalls {
 public:
  explicit PresentWalls(const Deck& deck);

  /// False when it was there already.
  bool add(const std::string& name) { return present_.insert(name).second; }
  /// False when it was not there.
  bool remove(const std::string& name) { return present_.erase(name) > 0; }
  /// Those that move with one that has just been added or removed are where it is.
  void take_along(const std::string& leader);

  /// Whether the wall or one that moves with it is there.
  bool has_body(const std::string& name) const;

 private:
  const Deck& deck_;
  std::set<std::string> present_;
};

/// Those of each phase.
std::vector<PresentWalls> present_walls_by_phase(const Deck& deck);

}  // namespace repose
