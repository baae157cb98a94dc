#pragma once

#include <span>

#include "base/vector_level.h"
#include "contact/wall_contacts.h"
#include "neighbours/pair_lists.h"
#include "scene/walls/wall.h"
#include "simulation/guards.h"

namespace repose {

/// The contacts of this rank and how they are evaluated.
struct ContactView {
  const PairLists& pairs;
  const WallContacts& wall_contacts;
  std::span<const Wall> walls;
  VectorLevel level;
  double max_overlap;
};

/// The contact that has raised an alarm: the deepest one beyond the bound, or one whose force the fixed-point sums
/// cannot hold, or the particle that touches walls in too many places. Searches all contacts of this rank; to be called
/// only when an evaluation has raised an alarm, before anything moves on.
Alarm contact_alarm(const GuardView& view, const ContactView& contacts);

}  // namespace repose
